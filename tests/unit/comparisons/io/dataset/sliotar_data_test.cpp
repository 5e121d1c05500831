// The paper's numbers as they stand in comparisons/studies/data, against relations the
// paper itself states between them: a slip in copying breaks one of these.
#include <gtest/gtest.h>

#include <cmath>

#include "comparisons/io/dataset/published_values.hpp"
#include "comparisons/io/dataset/read_dataset.hpp"

namespace rebound {
namespace {

struct Core {
  Dataset measured;
  PublishedValues published;
  Document file;
};

class SliotarData : public ::testing::TestWithParam<std::string> {
 protected:
  static Core core(const std::string& letter) {
    const auto folder = std::filesystem::path(REBOUND_DATA_FOLDER) / ("sliotar-core-" + letter);
    return {read_dataset(folder), read_published_values(folder),
            Document::load(folder / "dataset.toml")};
  }
};

TEST_P(SliotarData, HoldsThreeShotsAtTheSpeedsOfThePaper) {
  const Core c = core(GetParam());
  ASSERT_EQ(c.measured.shots.size(), 3u);
  ASSERT_EQ(c.published.at_speed.size(), 3u);
  const double speeds[] = {5.0, 15.0, 25.0};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(c.measured.shots[i].impact.speed, speeds[i]);
    EXPECT_EQ(c.published.at_speed[i].speed, speeds[i]);
    EXPECT_FALSE(c.measured.shots[i].has_history());  // the paper prints none
    EXPECT_FALSE(c.measured.shots[i].peak_force.value.has_value());
  }
  EXPECT_EQ(c.measured.quasistatic.at(0).platens, 2);
  EXPECT_EQ(c.measured.pooled_peaks.size(), 3u);
  EXPECT_FALSE(c.measured.notes.empty());
}

/// Table 4 from Tables 3 and 4: c_eq = λ x_R^1.5, k_eq = κ √x_R within the
/// rounding of all printed digits.
TEST_P(SliotarData, TableFourFollowsFromItsInputs) {
  const Core c = core(GetParam());
  const PrintedNumber kappa = c.published.hunt_crossley_stiffness;
  for (std::size_t i = 0; i < 3; ++i) {
    const PublishedAtSpeed& at = c.published.at_speed[i];
    const PrintedNumber x =
        printed_number(c.file, "shot[" + std::to_string(i) + "].mean_deflection");
    const auto within = [](const PrintedNumber& printed, double low, double high) {
      return printed.value + printed.half_width >= low &&
             printed.value - printed.half_width <= high;
    };
    const PrintedNumber lambda = at.hunt_crossley_damping;
    EXPECT_TRUE(within(at.linear_damping,
                       (lambda.value - lambda.half_width) * std::pow(x.value - x.half_width, 1.5),
                       (lambda.value + lambda.half_width) * std::pow(x.value + x.half_width, 1.5)))
        << at.speed;
    EXPECT_TRUE(within(at.linear_stiffness,
                       (kappa.value - kappa.half_width) * std::sqrt(x.value - x.half_width),
                       (kappa.value + kappa.half_width) * std::sqrt(x.value + x.half_width)))
        << at.speed;
  }
}

/// All twelve printed contact times lie on a 1/32 ms grid, rounded to 0.01 ms.
TEST_P(SliotarData, ContactTimesLieOnAGrid) {
  for (const MeasuredImpact& shot : core(GetParam()).measured.shots) {
    const double steps = std::round(*shot.contact_time.value * 32e3);
    EXPECT_NEAR(*shot.contact_time.value, steps / 32e3, 0.0051e-3);
  }
}

INSTANTIATE_TEST_SUITE_P(Cores, SliotarData, ::testing::Values("a", "b", "c", "d"),
                         [](const auto& instance) { return "Core" + instance.param; });

class SliotarPaper : public SliotarData {};

struct Percentages {
  double contact_time = 0.0;
  double restitution = 0.0;
};

/// Mean over the cores of |model / measured - 1| at one speed.
Percentages mean_differences(const std::vector<Core>& cores, std::size_t speed) {
  Percentages mean;
  const double share = 1.0 / static_cast<double>(cores.size());
  for (const Core& c : cores) {
    const MeasuredImpact& shot = c.measured.shots[speed];
    const PublishedAtSpeed& at = c.published.at_speed[speed];
    mean.contact_time +=
        share * std::abs(at.linear_contact_time.value / *shot.contact_time.value - 1.0);
    mean.restitution +=
        share * std::abs(at.linear_restitution.value / *shot.restitution.value - 1.0);
  }
  return mean;
}

/// Section 4.4: differences by speed; section 4.5: mean restitution at 15 m/s.
/// The overall 7.6 % of section 4.4 is left out: it does not follow from
/// Table 5, whose mean is 6.3 %, as the three speeds' own percentages confirm.
TEST_F(SliotarPaper, AveragesOfTheTextFollowFromTheTables) {
  std::vector<Core> cores;
  for (const char* letter : {"a", "b", "c", "d"}) cores.push_back(core(letter));
  double restitution = 0.0;
  for (const Core& c : cores) restitution += *c.measured.shots[1].restitution.value / 4.0;
  EXPECT_NEAR(restitution, 0.5354, 0.0002);
  const Percentages published[] = {{0.124, 0.066}, {0.038, 0.128}, {0.025, 0.183}};
  for (std::size_t speed = 0; speed < 3; ++speed) {
    const Percentages mean = mean_differences(cores, speed);
    EXPECT_NEAR(mean.contact_time, published[speed].contact_time, 0.002) << speed;
    EXPECT_NEAR(mean.restitution, published[speed].restitution, 0.002) << speed;
  }
}

}  // namespace
}  // namespace rebound
