// Rung g: finite-strain viscoelasticity of uniformly stretched cells, both kinds.
//
// The update of a branch is exact for stress linear over a step; the histories
// are not, so the error is of second order in the step, which is gated too.
#include <gtest/gtest.h>

#include "comparisons/verification/element_rungs.hpp"
#include "fem/verification/element_checks.hpp"
#include "tests/support/verification_rows.hpp"

namespace rebound {
namespace {

TEST(RungG, RampsStepsAndCycles) {
  test::expect_rows(verify_viscoelastic_cells(fem::element_checks()).rows, 20);
}

TEST(RungG, NoMaterialWinsEnergyInAClosedCycle) {
  test::expect_rows(verify_dissipation(fem::element_checks()).rows, 18);
}

TEST(RungG, PublishedRod) {
  test::expect_rows(verify_published_rod(fem::element_checks()).rows, 6);
}

}  // namespace
}  // namespace rebound
