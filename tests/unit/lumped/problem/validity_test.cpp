#include "lumped/problem/validity.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lumped/problem/lumped_problem.hpp"
#include "lumped/problem/names.hpp"
#include "tests/support/refusals.hpp"

namespace rebound {
namespace {

using testing::refusal_of;

TEST(ValidityTest, RangesHoldTheirLimitsAndFiniteNumbersOnly) {
  EXPECT_TRUE(from_to(0.0, 1.0).contains(0.0) && from_to(0.0, 1.0).contains(1.0));
  EXPECT_FALSE(above_up_to(0.0, 1.0).contains(0.0));
  EXPECT_TRUE(above_up_to(0.0, 1.0).contains(1.0));
  EXPECT_FALSE(from_to_below(0.0, 1.0).contains(1.0));
  EXPECT_FALSE(between(0.0, 1.0).contains(0.0) || between(0.0, 1.0).contains(1.0));
  EXPECT_FALSE(from_to(0.0, 1.0).contains(std::nextafter(1.0, 2.0)));
  for (const Range& range : {any_number(), at_least(0.0), above(0.0)})
    for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) EXPECT_FALSE(range.contains(bad));
}

TEST(ValidityTest, RangesInWords) {
  EXPECT_EQ(allowed_text(above(0.0), "g"), "value > 0 g");
  EXPECT_EQ(allowed_text(at_least(0.0), ""), "value >= 0");
  EXPECT_EQ(allowed_text(from_to_below(0.0, 1.0), ""), "0 <= value < 1");
  EXPECT_EQ(allowed_text(above_up_to(0.0, 0.01), "mm", 1e-3), "0 < value <= 10 mm");
  EXPECT_EQ(allowed_text(from_to(1.0, 1.0), ""), "1");
  EXPECT_EQ(allowed_text(any_number(), ""), "");
}

TEST(ValidityTest, AnErrorHasTheWholePath) {
  const KeyPath model{"model"}, branch{"branch", 1, &model};
  EXPECT_EQ(branch.of("ratio"), "model.branch[1].ratio");
  EXPECT_EQ(KeyPath{}.of("ratio"), "ratio");
  const Error error = refusal_of([] { require_limits(Sphere{.mass = -1.0}, {"sphere"}); });
  EXPECT_EQ(error.code(), ExitCode::bad_input);
  EXPECT_EQ(error.location().key, "sphere.mass");
  EXPECT_EQ(error.location().value, "-1");
  EXPECT_EQ(error.location().allowed, "value > 0 g");
}

TEST(ValidityTest, WhatStandsForNotGivenIsAllowed) {
  EXPECT_NO_THROW(require_limits(Plate{}, {"plate"}));
  EXPECT_NO_THROW(require_limits(LumpedModel{}, {"model"}));
  Plate plate;
  plate.stiffness = std::nan("");
  EXPECT_EQ(refusal_of([&] { require_limits(plate, {"plate"}); }).location().key,
            "plate.stiffness");
}

TEST(NamesTest, EveryValueHasOneNameThatReadsBack) {
  for (const SeparationRule rule : {SeparationRule::zero_force, SeparationRule::zero_deflection}) {
    SeparationRule read{};
    EXPECT_TRUE(read_name(name_of(rule), read));
    EXPECT_EQ(read, rule);
  }
  SeparationRule rule = SeparationRule::zero_deflection;
  EXPECT_FALSE(read_name("sometimes", rule));
  EXPECT_EQ(rule, SeparationRule::zero_deflection);
  EXPECT_EQ(all_names<SeparationRule>(),
            (std::vector<std::string>{"zero-force", "zero-deflection"}));
}

}  // namespace
}  // namespace rebound
