// Case a: patch test, and a manufactured axisymmetric solution at finite strain,
// near-axis points included, on both kinds of cells.
//
// Orders in L2/H1: bilinear cells 2/1, nine-node cells 3/2.
#include <gtest/gtest.h>

#include "comparisons/accuracy/verification/element_cases.hpp"
#include "comparisons/accuracy/verification/fem_cases.hpp"
#include "comparisons/models/fem_access/module_loader.hpp"
#include "fem/element_tests/element_checks.hpp"
#include "fem/element_tests/manufactured_solution.hpp"
#include "tests/support/verification_rows.hpp"

namespace rebound {
namespace {

// Targets: evaluated apart from this program, 14 digits.
TEST(VerificationCaseA, BodyForceOfTheManufacturedSolution) {
  struct Point {
    double r, z, b_r, b_z;
  };
  for (const Point& at : {Point{0.25, 0.25, -0.23257044097246, 0.35743610872518},
                          Point{0.5, 0.5, -0.45774960341445, 0.67223047766909},
                          Point{0.75, 0.1, -0.57601793108742, 0.12376196701162},
                          Point{0.9, -0.6, -0.71390910626763, -0.65936038015377},
                          Point{0.001, 0.3, -0.00095833792693215, 0.43622240623733}}) {
    const auto b = fem::manufactured_body_force(at.r, at.z);
    EXPECT_NEAR(b[0], at.b_r, 1e-12);
    EXPECT_NEAR(b[1], at.b_z, 1e-12);
  }
}

TEST(VerificationCaseA, PatchAndManufacturedSolution) {
  const VerificationPart part = verify_fields(fem::element_checks());
  test::expect_rows(part.rows, 22);
  EXPECT_EQ(part.figures.size(), 2u);
}

TEST(VerificationCaseA, BothSchemesAreOfSecondOrderInTime) {
  test::expect_rows(verify_time_order(fem_tier(), {}).rows, 2);
}

}  // namespace
}  // namespace rebound
