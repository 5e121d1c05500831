// Case g: finite-strain viscoelasticity of uniformly stretched cells, both kinds.
//
// The update of a branch is exact for stress linear over a step; the histories
// are not, so the error is of second order in the step, which is gated too.
#include <gtest/gtest.h>

#include "comparisons/accuracy/verification/element_cases.hpp"
#include "fem/element_tests/element_checks.hpp"
#include "tests/support/verification_rows.hpp"

namespace rebound {
namespace {

TEST(VerificationCaseG, RampsStepsAndCycles) {
  test::expect_rows(verify_viscoelastic_cells(fem::element_checks()).rows, 20);
}

TEST(VerificationCaseG, NoMaterialWinsEnergyInAClosedCycle) {
  test::expect_rows(verify_dissipation(fem::element_checks()).rows, 18);
}

TEST(VerificationCaseG, PublishedRod) {
  test::expect_rows(verify_published_rod(fem::element_checks()).rows, 6);
}

}  // namespace
}  // namespace rebound
