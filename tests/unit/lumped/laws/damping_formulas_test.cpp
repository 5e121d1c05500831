#include "lumped/laws/damping_formulas.hpp"

#include <gtest/gtest.h>

#include <map>

#include "lumped/laws/exact_restitution.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

// Restitution really returned when 0.9, 0.8, … 0.3 is asked for: independent
// evaluation of each formula through the exact implicit relation, 4 digits.
const std::map<std::string, std::vector<double>> returned = {
    {"hunt-crossley", {0.9090, 0.8329, 0.7680, 0.7120, 0.6630, 0.6197, 0.5813}},
    {"herbert-mcwhannell", {0.9009, 0.8070, 0.7227, 0.6511, 0.5936, 0.5503, 0.5200}},
    {"lee-wang", {0.9524, 0.9090, 0.8693, 0.8329, 0.7992, 0.7680, 0.7390}},
    {"lankarani-nikravesh", {0.9132, 0.8471, 0.7960, 0.7561, 0.7252, 0.7016, 0.6842}},
    {"gonthier", {0.8764, 0.7680, 0.6696, 0.5773, 0.4877, 0.3978, 0.3042}},
    {"zhiying-qishao", {0.8959, 0.7874, 0.6796, 0.5769, 0.4826, 0.3988, 0.3267}},
    {"flores", {0.8939, 0.7885, 0.6832, 0.5773, 0.4704, 0.3629, 0.2562}},
    {"hu-guo", {0.8999, 0.7992, 0.6973, 0.5936, 0.4877, 0.3796, 0.2707}},
    {"exact", {0.9, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3}},
};

TEST(DampingFormulasTest, ReturnedRestitution) {
  std::size_t found = 0;
  for (const auto& formula : damping_formulas()) {
    if (!returned.contains(formula.name)) continue;  // held to its own number below
    ++found;
    const auto& row = returned.at(formula.name);
    for (std::size_t i = 0; i < row.size(); ++i) {
      const double asked = 0.9 - 0.1 * static_cast<double>(i);
      EXPECT_NEAR(hunt_crossley_restitution(formula.damping_number(asked)), row[i], 5.1e-5)
          << formula.name << " at " << asked;
    }
  }
  EXPECT_EQ(found, returned.size());
}

// Every formula of the list against the number that stands beside it there.
TEST(DampingFormulasTest, EachReturnsWhatItsLineSays) {
  for (const auto& formula : damping_formulas())
    EXPECT_NEAR(hunt_crossley_restitution(formula.damping_number(0.5)), formula.returned_for_half,
                5.1e-5)
        << formula.name;
}

TEST(DampingFormulasTest, LessRestitutionTakesMoreDamping) {
  for (const auto& formula : damping_formulas())
    for (double e = 0.95; e > 0.5; e -= 0.05)
      EXPECT_GT(formula.damping_number(e - 0.05), formula.damping_number(e)) << formula.name;
}

TEST(DampingFormulasTest, ElasticNeedsNoDamping) {
  for (const auto& formula : damping_formulas()) EXPECT_EQ(formula.damping_number(1.0), 0.0);
}

TEST(DampingFormulasTest, UnknownNameListsTheFormulas) {
  const DampingRequest request{.formula = "hertz",
                               .restitution = 0.5,
                               .mass = 0.09,
                               .impact = {.speed = 10.0},
                               .parameters = {}};
  for (auto damping : {hunt_crossley_damping, linear_damping}) {
    try {
      damping(request, 1e6);
      FAIL();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::bad_input);
      EXPECT_NE(error.location().allowed.find("exact"), std::string::npos);
    }
  }
}

// Eq. (8) of the sliotar paper at core A: κ 3.5e6, e 0.527. The printed λ of
// 17.63e4 belongs to 14.085 m/s, not to the nominal 15.
TEST(DampingFormulasTest, PaperDampingOfCoreA) {
  const DampingRequest request{.formula = "hunt-crossley",
                               .restitution = 0.527,
                               .mass = 0.0896,
                               .impact = {.speed = 14.085},
                               .parameters = {}};
  EXPECT_NEAR(hunt_crossley_damping(request, 3.5e6), 17.63e4, 10.0);
}

}  // namespace
}  // namespace rebound
