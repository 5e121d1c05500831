#include "comparisons/studies/reproduce/model_runs.hpp"
#include "comparisons/models/installation.hpp"

#include <gtest/gtest.h>

#include "lumped/integration/closed_forms.hpp"

namespace rebound {
namespace {

const Paper& paper() {
  static const Paper read = read_paper(data_folder());
  return read;
}

TEST(ModelRunsTest, AgreeWithTheExactImpact) {
  const auto runs = run_published_model(paper());
  const PaperCore& core = paper().cores[0];
  const PaperShot& shot = core.shots[1];
  const HuntCrossleyImpact exact({.stiffness = core.published.hunt_crossley_stiffness.value,
                                  .damping = shot.published.hunt_crossley_damping.value},
                                 {.mass = core.mass.value, .speed = shot.speed});
  EXPECT_NEAR(runs[0][1].result.scalars.contact_time, exact.contact_time(), 1e-9);
  EXPECT_NEAR(runs[0][1].result.scalars.restitution, exact.restitution(), 1e-7);
  EXPECT_LT(runs[0][1].contact_time.low, exact.contact_time());
  EXPECT_GT(runs[0][1].contact_time.high, exact.contact_time());
}

/// Corners bound a formula that is monotone in each input: no point of the
/// box's interior may lie outside them.
TEST(ModelRunsTest, ScalarsAreMonotoneOverTheRounding) {
  const auto runs = run_published_model(paper());
  for (std::size_t i = 0; i < paper().cores.size(); ++i)
    for (std::size_t j = 0; j < paper().speeds(); ++j) {
      const PaperCore& core = paper().cores[i];
      const PaperShot& shot = core.shots[j];
      const PrintedNumber& kappa = core.published.hunt_crossley_stiffness;
      const PrintedNumber& lambda = shot.published.hunt_crossley_damping;
      for (int k = 0; k < 27; ++k) {
        const double a = k % 3 - 1.0, b = k / 3 % 3 - 1.0, c = k / 9 - 1.0;
        const HuntCrossleyImpact impact(
            {.stiffness = kappa.value + a * kappa.half_width,
             .damping = lambda.value + b * lambda.half_width},
            {.mass = core.mass.value + c * core.mass.half_width, .speed = shot.speed});
        EXPECT_GE(impact.contact_time(), runs[i][j].contact_time.low * (1.0 - 1e-7));
        EXPECT_LE(impact.contact_time(), runs[i][j].contact_time.high * (1.0 + 1e-7));
        EXPECT_GE(impact.peak_force(), runs[i][j].peak_force.low * (1.0 - 1e-4));
        EXPECT_LE(impact.peak_force(), runs[i][j].peak_force.high * (1.0 + 1e-4));
      }
    }
}

TEST(ModelRunsTest, ParameterStudyReturnsOneRestitution) {
  const auto runs = run_parameter_study(paper().parameter_study);
  ASSERT_EQ(runs.size(), 4u);
  // The damping number is 1.5 (1 − e) for every stiffness.
  const double returned =
      hunt_crossley_restitution(1.5 * (1.0 - paper().parameter_study.restitution));
  for (const StudyRun& run : runs) EXPECT_NEAR(run.result.scalars.restitution, returned, 1e-7);
}

}  // namespace
}  // namespace rebound
