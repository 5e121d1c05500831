#include <gtest/gtest.h>

#include "comparisons/discrepancy/trials/generator/trial.hpp"

namespace trials::testing {
namespace {

/// The first of the trials with this form whose effect shows.
Trial visible_trial_of(const std::string& form) {
  for (int number = 1;; ++number) {
    Trial trial = make_trial({.seed = 5, .set = "rivals", .number = number, .only = form});
    if (trial.visible_chi_square >= 25.0) return trial;
  }
}

TEST(TrialRivals, ANullHasNone) {
  const Trial null = make_trial({.seed = 5, .set = "rivals", .number = 1, .only = "null"});
  EXPECT_EQ(null.rivals.of_other_family.form, "");
  EXPECT_EQ(null.rivals.of_other_name.cosine, 0.0);
}

/// A stiffness that grows with deflection is a power of it, nearly: another name, one family.
TEST(TrialRivals, FormsOfOneFamilyAreNearerThanThoseOfOthers) {
  const Trial trial = visible_trial_of("linear-stiffening");
  EXPECT_GT(trial.rivals.of_other_name.cosine, 0.9);
  EXPECT_LE(trial.rivals.of_other_name.cosine, 1.0 + 1e-12);
  EXPECT_GE(trial.rivals.of_other_name.cosine, trial.rivals.of_other_family.cosine);
  EXPECT_NE(trial.rivals.of_other_name.form, "linear-stiffening");
}

/// Nothing else rings through the whole record.
TEST(TrialRivals, HumIsLikeNothingElse) {
  EXPECT_LT(visible_trial_of("hum").rivals.of_other_family.cosine, 0.8);
}

/// The largest pull of this trial holds the ball, and the next smaller one shows too little: the
/// search for a size went to and fro between them for ever.
TEST(TrialSizes, AreFoundWhereTheNextLargerOneHoldsTheBall) {
  const Trial trial = make_trial({.seed = 20261123, .set = "scoring", .number = 170});
  EXPECT_GT(trial.visible_chi_square, 0.0);
}

}  // namespace
}  // namespace trials::testing
