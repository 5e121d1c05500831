// Published restitutions of real balls go through inspection, calibration and selection.
#include <cmath>
#include <filesystem>

#include "comparisons/discrepancy/inspection/inspection.hpp"
#include "comparisons/inference/references/read_references.hpp"
#include "comparisons/inference/selection/selection.hpp"
#include "comparisons/io/dataset/read_dataset.hpp"
#include "tests/support/refusals.hpp"

namespace rebound {
namespace {

struct BallCase {
  const char* folder;
  std::size_t shots;
  double first_speed;        ///< by hand from the printed numbers [m/s]
  double first_restitution;  ///< likewise, without air
  bool contradicts_itself;
};

std::filesystem::path folder_of(const BallCase& ball) {
  return std::filesystem::path(REBOUND_DATA_FOLDER) / "balls" / ball.folder;
}

class RealBalls : public ::testing::TestWithParam<BallCase> {};

TEST_P(RealBalls, AreReadAndInspected) {
  const BallCase& ball = GetParam();
  const Dataset dataset = read_dataset(folder_of(ball));
  ASSERT_EQ(dataset.shots.size(), ball.shots);
  // The order of the shots: those stated one by one, then the rows of the table.
  const MeasuredImpact& first = dataset.shots[ball.contradicts_itself ? 1 : 0];
  constexpr double air = 0.03;  // at most, on either number
  EXPECT_NEAR(first.impact.speed, ball.first_speed, air * ball.first_speed);
  EXPECT_NEAR(*first.restitution.value, ball.first_restitution, air);
  EXPECT_TRUE(first.restitution.has_error());
  const Inspection found = inspect(dataset);
  EXPECT_EQ(!found.contradictions.empty(), ball.contradicts_itself);
}

/// The stiffness of no ball is told by restitutions: it is fixed, and the losses follow.
LawRequest request_for(const std::string& law, double stiffness) {
  return {.law = law, .damping_formula = {}, .fixed = {{"stiffness", stiffness}}};
}

TEST_P(RealBalls, ALawIsCalibratedToThem) {
  const auto shots = read_scalar_references(folder_of(GetParam()));
  LawCalibrationOptions options;
  options.observable = Observable::scalars;
  const LawCalibration fitted = calibrate(request_for("kuwabara-kono", 2e6), shots, options);
  ASSERT_EQ(fitted.fit.estimates.size(), 1u);
  EXPECT_EQ(fitted.fit.estimates[0].identifiability, Identifiability::identified);
  EXPECT_GT(fitted.fit.estimates[0].value, 1e-6);
  EXPECT_LT(fitted.fit.estimates[0].value, 1e-2);
}

TEST_P(RealBalls, LawsAreSelectedBetween) {
  const auto shots = read_scalar_references(folder_of(GetParam()));
  LawCalibrationOptions options;
  options.observable = Observable::scalars;
  const Selection selection =
      select_law({{"Kuwabara-Kono", request_for("kuwabara-kono", 2e6)},
                  {"Kelvin-Voigt", request_for("linear-kelvin-voigt", 1e6)}},
                 shots, options);
  for (const CandidateScore& one : selection.candidates) EXPECT_EQ(one.failure, "") << one.label;
  EXPECT_FALSE(selection.chosen.empty());
}

INSTANTIATE_TEST_SUITE_P(
    All, RealBalls,
    ::testing::Values(BallCase{"baseball-1", 9, 9.4325, 11.35 / 21.1, false},
                      BallCase{"baseball-2", 8, 8.5877, 9.67 / 19.21, false},
                      BallCase{"golf-ball", 4, 3.9611, std::sqrt(63.83 / 80.0), false},
                      BallCase{"tennis-ball", 6, 2.2144, std::sqrt(12.87 / 25.0), true},
                      BallCase{"tennis-ball-rule", 1, 7.0583, std::sqrt(1.41 / 2.54), false}),
    [](const auto& c) {
      std::string name = c.param.folder;
      std::erase(name, '-');
      return name;
    });

TEST(ScalarCalibration, ARestitutionAloneTellsNoStiffness) {
  const auto shots =
      read_scalar_references(std::filesystem::path(REBOUND_DATA_FOLDER) / "balls" / "golf-ball");
  LawCalibrationOptions options;
  options.observable = Observable::scalars;
  const Error error = testing::refusal_of([&] {
    calibrate({.law = "kuwabara-kono", .damping_formula = {}, .fixed = {}}, shots, options);
  });
  EXPECT_EQ(error.location().key, "fixed.stiffness");
}

/// The restitution of Hunt-Crossley depends on damping times speed over stiffness alone, here
/// exactly p(1 + e) = ln((1 + p)/(1 - p e)): e = 0.59362426 at p = 1 (verification case h).
TEST(ScalarCalibration, FindsTheDampingOfAClosedForm) {
  MeasuredImpact shot;
  shot.sphere = {.mass = 0.0896, .diameter = 0.0662};
  shot.impact.speed = 10.0;
  shot.restitution = {.value = 0.59362426040, .uncertainty = 1e-4};
  LawCalibrationOptions options;
  options.observable = Observable::scalars;
  const LawCalibration fitted = calibrate(request_for("hunt-crossley", 3e6), {shot}, options);
  EXPECT_NEAR(fitted.fit.estimates[0].value, 3e6 / 10.0, 10.0);
}

}  // namespace
}  // namespace rebound
