// Case e of the FE tier: standard linear solid pressed along a triangle and a
// half sine, against Lee–Radok and Ting on the elastic force of the same cells.
#include <gtest/gtest.h>

#include "comparisons/accuracy/verification/ting_case.hpp"
#include "comparisons/models/fem_access/module_loader.hpp"
#include "tests/support/verification_rows.hpp"

namespace rebound {
namespace {

TEST(VerificationCaseEFem, Triangle) {
  test::expect_rows(verify_ting(fem_tier(), CompressionPath::triangle, {}).rows, 3);
}

TEST(VerificationCaseEFem, HalfSine) {
  test::expect_rows(verify_ting(fem_tier(), CompressionPath::half_sine, {}).rows, 3);
}

}  // namespace
}  // namespace rebound
