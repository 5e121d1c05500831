// Rung e of the FE tier: standard linear solid pressed along a triangle and a
// half sine, against Lee–Radok and Ting on the elastic force of the same cells.
#include <gtest/gtest.h>

#include "comparisons/modules/module_loader.hpp"
#include "comparisons/verification/ting_rung.hpp"
#include "tests/support/verification_rows.hpp"

namespace rebound {
namespace {

TEST(RungEFem, Triangle) {
  test::expect_rows(verify_ting(fem_tier(), CompressionPath::triangle, {}).rows, 3);
}

TEST(RungEFem, HalfSine) {
  test::expect_rows(verify_ting(fem_tier(), CompressionPath::half_sine, {}).rows, 3);
}

}  // namespace
}  // namespace rebound
