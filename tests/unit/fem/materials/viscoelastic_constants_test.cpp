#include "fem/materials/viscoelastic_constants.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "fem/interface/check_material.hpp"
#include "fem/interface/elastic_models.hpp"
#include "fem/interface/engineering_moduli.hpp"
#include "tests/support/fem_cases.hpp"
#include "tests/support/refusals.hpp"

namespace rebound::fem {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// E = 10 MPa, ν = 0.4: μ = 3.5714 MPa, K = 16.667 MPa.
Material solid(ModulusBasis basis, std::vector<PronyBranch> branches) {
  return {.youngs_modulus = 10e6,
          .poisson_ratio = 0.4,
          .modulus = basis,
          .branches = std::move(branches)};
}

TEST(ViscoelasticConstantsTest, BasesAgree) {
  // Instantaneous 20 MPa with shares 0.3 and 0.2 is long-term 10 MPa with
  // branches of 0.6 and 0.4 of it.
  Material instantaneous =
      solid(ModulusBasis::instantaneous, {{0.3, 1e-4, Relaxes::all}, {0.2, 1e-3, Relaxes::all}});
  instantaneous.youngs_modulus = 20e6;
  const auto a = viscoelastic_constants(instantaneous);
  const auto b = viscoelastic_constants(
      solid(ModulusBasis::long_term, {{0.6, 1e-4, Relaxes::all}, {0.4, 1e-3, Relaxes::all}}));
  EXPECT_NEAR(a.instantaneous.shear / b.instantaneous.shear, 1.0, 1e-15);
  EXPECT_NEAR(a.instantaneous.bulk / b.instantaneous.bulk, 1.0, 1e-15);
  EXPECT_NEAR(a.long_term_deviatoric, b.long_term_deviatoric, 1e-15);
  EXPECT_NEAR(a.long_term_volumetric, b.long_term_volumetric, 1e-15);
  ASSERT_EQ(a.branches.size(), b.branches.size());
  for (std::size_t i = 0; i < a.branches.size(); ++i) {
    EXPECT_NEAR(a.branches[i].deviatoric_share, b.branches[i].deviatoric_share, 1e-15);
    EXPECT_NEAR(a.branches[i].volumetric_share, b.branches[i].volumetric_share, 1e-15);
    EXPECT_EQ(a.branches[i].relaxation_time, b.branches[i].relaxation_time);
  }
}

TEST(ViscoelasticConstantsTest, MixedBranchesRelaxTheirParts) {
  const auto c = viscoelastic_constants(
      solid(ModulusBasis::long_term, {{0.5, 1e-4, Relaxes::all}, {0.3, 1e-3, Relaxes::deviator}}));
  const double shear = 10e6 / 2.8, bulk = 10e6 / 0.6;
  EXPECT_NEAR(c.instantaneous.shear / (1.8 * shear), 1.0, 1e-14);
  EXPECT_NEAR(c.instantaneous.bulk / (1.5 * bulk), 1.0, 1e-14);
  EXPECT_NEAR(c.branches[0].deviatoric_share * c.instantaneous.shear, 0.5 * shear, 1e-8);
  EXPECT_NEAR(c.branches[0].volumetric_share * c.instantaneous.bulk, 0.5 * bulk, 1e-8);
  EXPECT_NEAR(c.branches[1].deviatoric_share * c.instantaneous.shear, 0.3 * shear, 1e-8);
  EXPECT_EQ(c.branches[1].volumetric_share, 0.0);
  EXPECT_NEAR(c.long_term_deviatoric * c.instantaneous.shear, shear, 1e-8);
  EXPECT_NEAR(c.long_term_volumetric * c.instantaneous.bulk, bulk, 1e-8);
}

TEST(ViscoelasticConstantsTest, DeviatorBranchKeepsTheBulkModulus) {
  const auto c =
      viscoelastic_constants(solid(ModulusBasis::instantaneous, {{0.4, 1e-3, Relaxes::deviator}}));
  EXPECT_EQ(c.long_term_volumetric, 1.0);
  EXPECT_DOUBLE_EQ(c.long_term_deviatoric, 0.6);
}

TEST(ViscoelasticConstantsTest, RefusesWhatIsOutOfRange) {
  const auto key_refused = [](const Material& material) {
    const Error error = testing::refusal_of([&] { viscoelastic_constants(material); });
    EXPECT_EQ(error.code(), ExitCode::bad_input);
    return error.location().key;
  };
  const Material fine = solid(ModulusBasis::instantaneous, {{0.4, 1e-3, Relaxes::all}});
  for (const double value : {0.0, -1.0, nan, infinity}) {
    Material bad = fine;
    bad.youngs_modulus = value;
    EXPECT_EQ(key_refused(bad), "model.material.youngs_modulus") << value;
    bad = fine;
    bad.branches[0].relaxation_time = value;
    EXPECT_EQ(key_refused(bad), "model.material.branch[0].relaxation_time") << value;
    bad = fine;
    bad.modulus = ModulusBasis::long_term;
    bad.branches[0].ratio = value;
    EXPECT_EQ(key_refused(bad), "model.material.branch[0].ratio") << value;
  }
  for (const double value : {-1.0, 0.4991, 0.5, nan, infinity}) {
    Material bad = fine;
    bad.poisson_ratio = value;
    EXPECT_EQ(key_refused(bad), "model.material.poisson_ratio") << value;
  }
  Material whole = fine;
  whole.branches = {{0.5, 1e-3, Relaxes::all}, {0.5, 1e-2, Relaxes::deviator}};
  EXPECT_EQ(key_refused(whole), "model.material.branch[1].ratio");
  whole.modulus = ModulusBasis::long_term;  // there any positive sum is fine
  EXPECT_NO_THROW(viscoelastic_constants(whole));
}

Material foam(std::vector<StretchTerm> terms) {
  return {.elastic = ElasticModel::hyperfoam,
          .youngs_modulus = 2.8,
          .poisson_ratio = 0.4,
          .terms = std::move(terms)};
}

TEST(ViscoelasticConstantsTest, TermsAddUpToTheModuli) {
  for (const Material& material :
       {foam({{3.0, 4.0, {}}, {1.0, -2.0, {}}}), foam({{3.0, 4.0, 2.5}, {1.0, -2.0, 0.51}})}) {
    const ElasticConstants elastic = viscoelastic_constants(material).elastic;
    double shear = 0.0, bulk = 0.0;
    for (int i = 0; i < elastic.terms.count; ++i) {
      shear += elastic.terms.shear[i];
      bulk += 2.0 * elastic.terms.shear[i] * (1.0 / 3.0 + elastic.terms.beta[i]);
    }
    EXPECT_DOUBLE_EQ(shear, elastic.moduli.shear);
    EXPECT_DOUBLE_EQ(bulk, elastic.moduli.bulk);
    EXPECT_DOUBLE_EQ(elastic.terms.shear[0], 3.0 * elastic.terms.shear[1]);
  }
}

TEST(ViscoelasticConstantsTest, RefusesTermsThatAreOutOfRange) {
  const auto key_refused = [](const Material& material) {
    const Error error = testing::refusal_of([&] { viscoelastic_constants(material); });
    EXPECT_EQ(error.code(), ExitCode::bad_input);
    return error.location().key;
  };
  EXPECT_EQ(key_refused(foam({})), "model.material.term");
  EXPECT_EQ(key_refused(foam(std::vector<StretchTerm>(7))), "model.material.term");
  for (const double value : {0.0, -1.0, nan, infinity})
    EXPECT_EQ(key_refused(foam({{value, 2.0, {}}})), "model.material.term[0].weight") << value;
  for (const double value : {0.0, 51.0, nan, infinity})
    EXPECT_EQ(key_refused(foam({{1.0, value, {}}})), "model.material.term[0].exponent") << value;
  for (const double value : {-0.34, nan, infinity})
    EXPECT_EQ(key_refused(foam({{1.0, 2.0, value}})), "model.material.term[0].beta") << value;
  // β = 1 everywhere is a Poisson ratio of 1/3, not 0.4.
  EXPECT_EQ(key_refused(foam({{1.0, 2.0, 1.0}})), "model.material.poisson_ratio");
  Material mooney = foam({});
  mooney.elastic = ElasticModel::mooney_rivlin;
  for (const double value : {-0.1, 1.1, nan}) {
    mooney.second_share = value;
    EXPECT_EQ(key_refused(mooney), "model.material.second_share") << value;
  }
}

TEST(ViscoelasticConstantsTest, BothEndsOfRelaxationAreHeldToThePoissonRatio) {
  // Instantaneous 0.4 with a deviatoric share of 0.995 is 0.49946 once relaxed.
  Material material = test::unit_material();
  material.branches = {{.ratio = 0.995, .relaxation_time = 1e-3, .relaxes = Relaxes::deviator}};
  const Error error = testing::refusal_of([&] { check(material); });
  EXPECT_EQ(error.code(), ExitCode::bad_input);
  EXPECT_NE(std::string(error.what()).find("long-term Poisson ratio is 0.499"), std::string::npos)
      << error.what();
  EXPECT_TRUE(error.location().key.ends_with("poisson_ratio"));
  EXPECT_NEAR(poisson_ratio(long_term_moduli(material)), 0.49946, 1e-5);
  // Half of it is 0.4483, and a branch that relaxes all keeps 0.4.
  material.branches.front().ratio = 0.5;
  EXPECT_NO_THROW(check(material));
  material.branches.front() = {.ratio = 0.9, .relaxation_time = 1e-3, .relaxes = Relaxes::all};
  EXPECT_NO_THROW(check(material));
  EXPECT_NEAR(poisson_ratio(long_term_moduli(material)), 0.4, 1e-12);
}

TEST(ViscoelasticConstantsTest, BothEndsAreThoseOfTheOtherBasis) {
  Material fresh = test::unit_material();
  fresh.poisson_ratio = 0.3;
  fresh.branches = {{.ratio = 0.3, .relaxation_time = 1e-3, .relaxes = Relaxes::deviator},
                    {.ratio = 0.2, .relaxation_time = 1e-2, .relaxes = Relaxes::all}};
  const Moduli relaxed = long_term_moduli(fresh);
  EXPECT_NEAR(relaxed.shear / given_moduli(fresh).shear, 0.5, 1e-12);
  EXPECT_NEAR(relaxed.bulk / given_moduli(fresh).bulk, 0.8, 1e-12);
  Material old = fresh;
  old.modulus = ModulusBasis::long_term;
  EXPECT_EQ(long_term_moduli(old).shear, given_moduli(old).shear);
}

}  // namespace
}  // namespace rebound::fem
