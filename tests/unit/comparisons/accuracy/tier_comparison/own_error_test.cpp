// What a run says of its own error does not widen what it may move by, where the mesh is the same.
#include <gtest/gtest.h>

#include "comparisons/accuracy/tier_comparison/comparison.hpp"

namespace rebound {
namespace {

TierRecord record_with(double error) {
  TierRecord record{.tier = "fem",
                    .speed = 5.0,
                    .separation = "zero-force",
                    .input_sha256 = "abc",
                    .discretisation = {"explicit", 100, 120, 1e-6},
                    .scalars = {}};
  for (const std::string& key : compared_keys())
    record.scalars[key] = {.value = 1.0, .rounding = error, .step = error, .numerical = error};
  return record;
}

/// Moved by a hundred errors of the baseline, with an error of its own of a thousand.
bool passes_with(const Discretisation& now_on) {
  const CompareCase one{.name = "a", .lumped = {}, .fem = "f", .speeds = {}, .agreement = {}};
  TierRecord now = record_with(1e-1);
  now.discretisation = now_on;
  now.scalars["restitution"].value += 1e-2;
  return compare_case(one, {now}, {record_with(1e-4)}).passes();
}

TEST(OwnErrorTest, CountsOnAnotherMeshAlone) {
  EXPECT_FALSE(passes_with({"explicit", 100, 120, 1e-6}));
  EXPECT_FALSE(passes_with({"explicit", 100, 120, 0.9e-6})) << "the step is another";
  EXPECT_TRUE(passes_with({"explicit", 144, 169, 1e-6}));
}

}  // namespace
}  // namespace rebound
