// Case b: free vibration of the sphere, both kinds of cells, against Lamb's
// frequency equations at ν = 0.4, R = 33.1 mm, m = 89.6 g, E = 10 MPa.
#include <gtest/gtest.h>

#include "comparisons/accuracy/verification/element_cases.hpp"
#include "fem/element_tests/element_checks.hpp"
#include "tests/support/verification_rows.hpp"

namespace rebound {
namespace {

TEST(VerificationCaseB, FrequenciesOfTheSphere) {
  test::expect_rows(verify_free_vibration(fem::element_checks()).rows, 14);
}

}  // namespace
}  // namespace rebound
