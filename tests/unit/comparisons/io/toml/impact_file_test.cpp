#include "comparisons/io/toml/impact_file.hpp"

#include <fmt/format.h>

#include "fem/interface/elastic_models.hpp"
#include "tests/support/refusals.hpp"

namespace rebound {
namespace {

using testing::refusal_of;

const std::string head = R"(schema = 1
[impact]
speed = "15 m/s"
[sphere]
mass = "89.6 g"
diameter = "66.2 mm"
[model]
)";
const std::string hunt_crossley = R"(tier = "lumped"
law = "hunt-crossley"
stiffness = "3.5e6 N/m^1.5"
)";
const std::string material = R"(tier = "fem"
[model.material]
elastic = "neo-hookean"
youngs_modulus = "10 MPa"
poisson_ratio = 0.4
)";

LumpedProblem lumped(const std::string& text) {
  return read_lumped_problem(Document::parse(text, "f.toml"));
}
FemProblem fem(const std::string& text) {
  return read_fem_problem(Document::parse(text, "f.toml"));
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos);
  return text.replace(at, from.size(), to);
}

TEST(ImpactFileTest, ReadsTheContractsLumpedExample) {
  const LumpedProblem problem = lumped(head + hunt_crossley + R"(damping = "17.63e4 N.s/m^2.5"
[[model.at_speed]]
speed = "5 m/s"
damping = "37.69e4 N.s/m^2.5"
)");
  EXPECT_EQ(problem.impact.speed, 15.0);
  EXPECT_EQ(problem.sphere.mass, 0.0896);
  EXPECT_EQ(problem.model.parameters.at("stiffness"), 3.5e6);
  EXPECT_EQ(problem.model.parameters.at("exponent"), 1.5);
  ASSERT_EQ(problem.model.at_speed.size(), 1u);
  EXPECT_EQ(problem.model.at_speed[0].parameters.at("damping"), 37.69e4);
}

TEST(ImpactFileTest, UnitOfStiffnessFollowsTheExponent) {
  const std::string text = head + replaced(hunt_crossley, "N/m^1.5", "N/m^1.3") +
                           "exponent = 1.3\ndamping = \"1e4 N.s/m^2.3\"\n";
  EXPECT_EQ(lumped(text).model.parameters.at("exponent"), 1.3);
  const Error error =
      refusal_of([&] { lumped(replaced(text, "exponent = 1.3", "exponent = 1.4")); });
  EXPECT_EQ(error.location().key, "model.stiffness");
  EXPECT_EQ(error.location().line, 10);
}

TEST(ImpactFileTest, DampingIsGivenExactlyOnce) {
  const std::string formula = "restitution = 0.527\ndamping_formula = \"exact\"\n";
  EXPECT_EQ(lumped(head + hunt_crossley + formula).model.restitution, 0.527);
  for (const std::string& bad :
       {std::string(), formula + "damping = \"1e4 N.s/m^2.5\"\n",
        std::string("restitution = 0.5\n"),
        std::string("damping = \"1e4 N.s/m^2.5\"\ndamping_formula = \"exact\"\n")})
    EXPECT_EQ(refusal_of([&] { lumped(head + hunt_crossley + bad); }).location().file, "f.toml")
        << bad;
}

TEST(ImpactFileTest, ParametersOfAnotherLawAreUnknown) {
  const std::string text = head +
                           "tier = \"lumped\"\nlaw = \"linear-kelvin-voigt\"\n"
                           "stiffness = \"2e5 N/m\"\ndamping = \"50 N.s/m\"\nexponent = 1.5\n";
  EXPECT_EQ(refusal_of([&] { lumped(text); }).location().key, "model.exponent");
}

TEST(ImpactFileTest, UnitSlipsShowInTheDensity) {
  const std::string text = head + hunt_crossley + "damping = \"17.63e4 N.s/m^2.5\"\n";
  for (const auto& [from, to] : {std::pair{"66.2 mm", "33.1 m"}, {"89.6 g", "89.6 kg"}}) {
    const Error error = refusal_of([&] { lumped(replaced(text, from, to)); });
    EXPECT_EQ(error.location().key, "sphere.diameter");
    EXPECT_EQ(error.location().line, 6);
    EXPECT_NE(error.location().allowed.find("50 to 20000 kg/m^3"), std::string::npos);
  }
}

TEST(ImpactFileTest, AFileForTheOtherTierIsSentThere) {
  EXPECT_NE(std::string(refusal_of([] { lumped(head + material); }).what()).find("rebound fem"),
            std::string::npos);
}

TEST(ImpactFileTest, ReadsTheContractsFemExample) {
  const FemProblem problem = fem(head + R"(tier = "fem"
scheme = "explicit"
cells = 1000
[model.material]
elastic = "neo-hookean"
youngs_modulus = "10 MPa"
poisson_ratio = 0.4
modulus = "instantaneous"
relaxation = "convolution"
[[model.material.branch]]
ratio = 0.3
relaxation_time = "0.3 ms"
relaxes = "all"
)");
  EXPECT_EQ(problem.cells, 1000);
  EXPECT_EQ(problem.material.youngs_modulus, 10e6);
  ASSERT_EQ(problem.material.branches.size(), 1u);
  EXPECT_EQ(problem.material.branches[0].relaxation_time, 0.3e-3);
}

TEST(ImpactFileTest, TheSoftestRealCoreAtTheHighestSpeedIsAccepted) {
  // Core A's block modulus, 1.94 MPa, at 25 m/s: v/c_s = 0.73.
  const std::string text = replaced(replaced(head + material, "10 MPa", "1.94 MPa"), "15", "25");
  EXPECT_NO_THROW(fem(text));
}

struct RefusedImpact {
  const char* name;
  const char* from;
  const char* to;
  const char* key;
  const char* part;  ///< of the message or of what is allowed
};

class FemFileRefuses : public ::testing::TestWithParam<RefusedImpact> {};

TEST_P(FemFileRefuses, WithKeyAndReason) {
  const RefusedImpact& c = GetParam();
  const Error error = refusal_of([&] { fem(replaced(head + material, c.from, c.to)); });
  EXPECT_EQ(error.code(), ExitCode::bad_input);
  EXPECT_EQ(error.location().key, c.key);
  EXPECT_GT(error.location().line, 0);
  const std::string all = std::string(error.what()) + " " + error.location().allowed;
  EXPECT_NE(all.find(c.part), std::string::npos) << all;
}

constexpr const char* nu = "poisson_ratio = 0.4\n";
constexpr const char* nu_key = "model.material.poisson_ratio";

INSTANTIATE_TEST_SUITE_P(
    Cases, FemFileRefuses,
    ::testing::Values(
        RefusedImpact{"Half", nu, "poisson_ratio = 0.5\n", nu_key, "-1 < value <= 0.499"},
        RefusedImpact{"MinusOne", nu, "poisson_ratio = -1.0\n", nu_key, "-1 < value <= 0.499"},
        RefusedImpact{"Incompressible", nu, "poisson_ratio = 0.4995\n", nu_key, "incompressible"},
        RefusedImpact{"Modulus", "10 MPa", "10 Pa", "impact.speed", "shear wave speed"},
        RefusedImpact{"Speed", "15 m/s", "999 m/s", "impact.speed", "shear wave speed"},
        RefusedImpact{"Elastic", "\"neo-hookean\"", "\"ogden\"", "model.material.term",
                      "this key is missing"},
        RefusedImpact{"Relaxation", nu, "poisson_ratio = 0.4\nrelaxation = \"split\"\n",
                      "model.material.relaxation", "multiplicative"},
        RefusedImpact{"Scheme", "tier = \"fem\"\n", "tier = \"fem\"\nscheme = \"leap\"\n",
                      "model.scheme", "implicit"},
        RefusedImpact{"ImplicitMovingPlate", "tier = \"fem\"\n",
                      "tier = \"fem\"\nscheme = \"implicit\"\nplate = {stiffness = \"50 MN/m\"}\n"
                      "adhesion = {work = \"1 J/m^2\"}\n",
                      "model.adhesion.work", "implicit scheme"},
        RefusedImpact{"Plate", nu, "poisson_ratio = 0.4\n[model.plate]\nfriction = -0.3\n",
                      "model.plate.friction", ""},
        RefusedImpact{"PlateMass", nu, "poisson_ratio = 0.4\n[model.plate]\nmass = \"2 kg\"\n",
                      "model.plate.mass", "stiffness"},
        RefusedImpact{"Effect", nu,
                      "poisson_ratio = 0.4\n[[model.effect]]\nname = \"x\"\nsize = 1\n",
                      "model.effect[0].name", "permanent-set"},
        RefusedImpact{
            "EffectForm", nu,
            "poisson_ratio = 0.4\n[[model.effect]]\nname = \"force-exponent\"\nsize = 0.1\n",
            "model.effect[0].name", "no form in the FE tier"},
        RefusedImpact{"Separation", "speed = \"15 m/s\"\n",
                      "speed = \"15 m/s\"\nseparation = \"zero-deflection\"\n", "impact.separation",
                      "zero-force"},
        RefusedImpact{"Time", nu,
                      "poisson_ratio = 0.4\n[[model.material.branch]]\nratio = 0.3\n"
                      "relaxation_time = \"0 s\"\n",
                      "model.material.branch[0].relaxation_time", "value > 0 ms"},
        RefusedImpact{"Shares", nu,
                      "poisson_ratio = 0.4\n[[model.material.branch]]\nratio = 0.6\n"
                      "relaxation_time = \"1 ms\"\n[[model.material.branch]]\nratio = 0.4\n"
                      "relaxation_time = \"2 ms\"\n",
                      "model.material.branch[1].ratio", "sum below 1"},
        RefusedImpact{"TwoMeshes", "tier = \"fem\"\n",
                      "tier = \"fem\"\ncells = 50\nmesh = \"a.msh\"\n", "model.cells", "mesh"}),
    [](const auto& instance) { return std::string(instance.param.name); });

TEST(ImpactFileTest, RatiosToALongTermModulusMayExceedOne) {
  const std::string text = head + material +
                           "modulus = \"long-term\"\n[[model.material.branch]]\n"
                           "ratio = 1.5\nrelaxation_time = \"1 ms\"\n";
  EXPECT_EQ(fem(text).material.branches[0].ratio, 1.5);
}

TEST(ImpactFileTest, AMeshIsFoundBesideItsFile) {
  const std::string text =
      replaced(head + material, "tier = \"fem\"\n", "tier = \"fem\"\nmesh = \"ball.msh\"\n");
  const FemProblem problem = read_fem_problem(Document::parse(text, "some/where/f.toml"));
  EXPECT_EQ(problem.mesh_file, std::filesystem::absolute("some/where/ball.msh"));
}

TEST(ImpactFileTest, TermsOfAnElasticLaw) {
  const std::string base = head + replaced(material, "neo-hookean", "hyperfoam");
  const std::string term = "[[model.material.term]]\nweight = 24400\nexponent = 8.31\n";
  EXPECT_EQ(fem(base + term).material.terms.at(0).exponent, 8.31);
  const auto key_refused = [](const std::string& text) {
    return refusal_of([&] { fem(text); }).location().key;
  };
  EXPECT_EQ(key_refused(base), "model.material.term");
  EXPECT_EQ(key_refused(base + replaced(term, "8.31", "0")), "model.material.term[0].exponent");
  EXPECT_EQ(key_refused(base + term + "beta = 1.0\n"), "model.material.poisson_ratio");
  EXPECT_EQ(key_refused(base + term + term + "beta = 2.0\n"), "model.material.term[0]");
  EXPECT_EQ(fem(base + term + "beta = 2.0\n").material.terms.at(0).beta, 2.0);
  // Keys of one law are unknown to the others.
  EXPECT_EQ(key_refused(head + material + term), "model.material.term");
  EXPECT_EQ(key_refused(base + "second_share = 0.2\n" + term), "model.material.second_share");
  const std::string ogden = head + replaced(material, "neo-hookean", "ogden") + term;
  EXPECT_EQ(fem(ogden).material.elastic, ElasticModel::ogden);
  EXPECT_EQ(key_refused(ogden + "beta = 2.0\n"), "model.material.term[0].beta");
}

}  // namespace
}  // namespace rebound
