#include "comparisons/evaluation/convert/conversion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "comparisons/evaluation/convert/conversion_file.hpp"
#include "comparisons/io/toml/document.hpp"
#include "comparisons/io/toml/reader.hpp"
#include "lumped/integration/closed_forms.hpp"
#include "lumped/problem/error.hpp"
#include "tests/support/lumped_cases.hpp"

namespace rebound {
namespace {

ConversionRequest request_of(Convention convention) {
  ConversionRequest request;
  request.sphere = test::core_a();
  request.impact = {.speed = 15.0, .separation = SeparationRule::zero_deflection};
  request.given.convention = convention;
  request.given.restitution = 0.5;
  request.given.stiffness = 3.5e6;
  request.given.contact_time = 1.9e-3;
  request.given.loss_tangent = 0.3;
  request.given.spring = 2.5e5;
  request.given.dashpot = 60.0;
  request.given.model = test::typical_problem("tsuji").model;
  return request;
}

const Conversion& row(ConversionTable&&, const std::string&) = delete;  // gone before it is read
const Conversion& row(const ConversionTable& table, const std::string& name) {
  for (const auto& c : table.conversions)
    if (c.convention == name) return c;
  throw std::logic_error("no row " + name);
}

TEST(ConversionTest, IntoItselfWithoutError) {
  const auto linear = convert(request_of(Convention::spring_dashpot));
  const auto& same = row(linear, "linear-restitution").by_formula;
  EXPECT_NEAR(*same.error.restitution, 0.0, 1e-9);
  EXPECT_NEAR(*same.error.contact_time, 0.0, 1e-8);
  EXPECT_NEAR(*same.error.peak_force, 0.0, 1e-6);
  EXPECT_NEAR(same.parameters[0].value, 2.5e5, 1e-3);
  EXPECT_NEAR(same.parameters[1].value, 60.0, 1e-6);
  const auto law = convert(request_of(Convention::law));
  const auto& tsuji = row(law, "hertz-restitution").by_formula;
  EXPECT_NEAR(*tsuji.error.restitution, 0.0, 1e-8);
  EXPECT_NEAR(*tsuji.error.peak_force, 0.0, 1e-6);
}

// What each formula really returns when e = 0.5 is asked for: independent
// evaluation of the implicit relation, four digits.
TEST(ConversionTest, FormulasReturnWhatTheyAreKnownToReturn) {
  const auto table = convert(request_of(Convention::restitution));
  const std::pair<const char*, double> returned[] = {{"hunt-crossley/hunt-crossley", 0.6630},
                                                     {"hunt-crossley/herbert-mcwhannell", 0.5936},
                                                     {"hunt-crossley/lee-wang", 0.7992},
                                                     {"hunt-crossley/lankarani-nikravesh", 0.7252},
                                                     {"hunt-crossley/gonthier", 0.4877},
                                                     {"hunt-crossley/zhiying-qishao", 0.4826},
                                                     {"hunt-crossley/flores", 0.4704},
                                                     {"hunt-crossley/hu-guo", 0.4877},
                                                     {"hunt-crossley/exact", 0.5},
                                                     {"hertz-restitution", 0.5}};
  for (const auto& [name, e] : returned) {
    const auto& law = row(table, name).by_formula;
    EXPECT_NEAR(*law.returned.restitution, e, 6e-5) << name;
    EXPECT_NEAR(*law.error.restitution, e - 0.5, 6e-5) << name;
    EXPECT_FALSE(law.error.peak_force.has_value());
  }
}

TEST(ConversionTest, MatchedLawsReturnWhatWasGiven) {
  for (const auto convention : {Convention::contact_time, Convention::restitution,
                                Convention::loss_tangent, Convention::spring_dashpot})
    for (const auto& c : convert(request_of(convention)).conversions) {
      ASSERT_EQ(c.matched.failure, "") << c.convention;
      EXPECT_NEAR(*c.matched.error.restitution, 0.0, 1e-8) << c.convention;
      if (c.matched.error.contact_time) {
        EXPECT_NEAR(*c.matched.error.contact_time, 0.0, 1e-7) << c.convention;
      }
    }
}

TEST(ConversionTest, TheSeparationRuleShowsAsError) {
  auto request = request_of(Convention::restitution);
  request.impact.separation = SeparationRule::zero_force;
  const auto table = convert(request);
  const auto& row_ = row(table, "hertz-restitution");
  EXPECT_EQ(row_.assumes, SeparationRule::zero_deflection);
  // α of e = 0.5 at zero deflection, read at zero force: ζ = α/√5 = 0.21545.
  EXPECT_NEAR(*row_.by_formula.error.restitution,
              kelvin_voigt_restitution(0.2154541, SeparationRule::zero_force) - 0.5, 1e-5);
}

TEST(ConversionTest, ErrorsElsewhereNeedALaw) {
  auto request = request_of(Convention::law);
  request.check_speed = 5.0;
  const auto table = convert(request);
  // Tsuji keeps its restitution at every speed; Hunt–Crossley does not.
  EXPECT_NEAR(*row(table, "hertz-restitution").matched.error.restitution, 0.0, 1e-7);
  EXPECT_GT(*row(table, "hunt-crossley/exact").matched.error.restitution, 0.1);
  request.given.convention = Convention::restitution;
  EXPECT_THROW(convert(request), Error);
}

TEST(ConversionTest, LossTangentIsLowLossTheoryAtLowLoss) {
  auto request = request_of(Convention::loss_tangent);
  request.given.loss_tangent = 1e-3;
  const auto meaning = meaning_of(request);
  EXPECT_NEAR((1.0 - *meaning.at_impact.restitution) / 1e-3, 1.7723, 3e-3);
}

TEST(ConversionTest, Refusals) {
  auto request = request_of(Convention::restitution);
  for (double e : {0.0, 1.0, 1.2, -0.5, std::nan("")}) {
    request.given.restitution = e;
    EXPECT_THROW(convert(request), Error) << e;
  }
  request = request_of(Convention::spring_dashpot);
  request.given.dashpot = 1e4;  // overdamped: never back at zero deflection
  try {
    convert(request);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::solver_failed);
  }
}

TEST(ConversionFileTest, ReadsEveryConvention) {
  const std::string head =
      "schema = 1\n[impact]\nspeed = \"15 m/s\"\n[sphere]\nmass = \"89.6 g\"\n"
      "diameter = \"66.2 mm\"\n[given]\nconvention = ";
  const std::pair<Convention, std::string> cases[] = {
      {Convention::law,
       "\"law\"\nlaw = \"tsuji\"\n[given.parameters]\nstiffness = \"3e6 N/m^1.5\"\n"
       "damping = \"100 N.s/m^1.25\"\n"},
      {Convention::spring_dashpot,
       "\"spring-dashpot\"\nspring = \"2e5 N/m\"\ndashpot = \"50 N.s/m\"\n"},
      {Convention::contact_time,
       "\"contact-time\"\ncontact_time = \"1.9 ms\"\nrestitution = 0.5\n"},
      {Convention::restitution,
       "\"restitution\"\nstiffness = \"3e6 N/m^1.5\"\nrestitution = 0.5\n"},
      {Convention::loss_tangent,
       "\"loss-tangent\"\nstiffness = \"3e6 N/m^1.5\"\nloss_tangent = 0.2\n"}};
  for (const auto& [convention, text] : cases) {
    ConversionRequest request;
    const Document document = Document::parse(head + text, "f");
    read_document(document, request);
    EXPECT_EQ(request.given.convention, convention);
    EXPECT_NO_THROW(convert(request)) << text;
  }
  ConversionRequest request;
  const Document wrong = Document::parse(head + "\"restitution\"\nspring = \"2e5 N/m\"\n", "f");
  EXPECT_THROW(read_document(wrong, request), Error);
}

}  // namespace
}  // namespace rebound
