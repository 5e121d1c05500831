// Rung b: free vibration of the sphere, both kinds of cells, against Lamb's
// frequency equations at ν = 0.4, R = 33.1 mm, m = 89.6 g, E = 10 MPa.
#include <gtest/gtest.h>

#include "comparisons/verification/element_rungs.hpp"
#include "fem/verification/element_checks.hpp"
#include "tests/support/verification_rows.hpp"

namespace rebound {
namespace {

TEST(RungB, FrequenciesOfTheSphere) {
  test::expect_rows(verify_free_vibration(fem::element_checks()).rows, 14);
}

}  // namespace
}  // namespace rebound
