#pragma once

#include "comparisons/accuracy/verification/verification_part.hpp"
#include "fem/interface/element_checks.hpp"

namespace rebound {

/// Case a in space, both kinds of cells: a uniform stretch of distorted cells is
/// carried exactly; a manufactured solution at finite strain converges in
/// L2/H1 with orders 2/1 (bilinear) and 3/2 (nine-node). A second.
VerificationPart verify_fields(const ElementChecks& checks);

/// Case b, both kinds of cells: Lamb's frequencies of the elastic sphere, and the
/// order in which they are approached: 2 (bilinear) and 4 (nine-node). Seconds.
VerificationPart verify_free_vibration(const ElementChecks& checks);

/// Case c with linear kinematics, nine-node cells: what linear theory makes of the finite
/// sphere. (Of case c itself, at finite strain, see fem_cases.hpp.) Half a second.
VerificationPart verify_linear_contact(const ElementChecks& checks);

/// Case g, both kinds of cells: finite-strain viscoelasticity under ramps,
/// steps and cycles, second order in the step. Under a second.
VerificationPart verify_viscoelastic_cells(const ElementChecks& checks);

/// Invariant, bilinear cells: no material wins energy in a closed cycle from
/// rest. Random cycles of both stretches, a tenth to ten relaxation times long. A second.
VerificationPart verify_dissipation(const ElementChecks& checks);

/// Published: the elongation of a viscoelastic rod under a constant load, given to
/// the cells, takes that load. Both kinds.
VerificationPart verify_published_rod(const ElementChecks& checks);

/// Poisson ratios 0.45, 0.49 and 0.499 against what is known, both kinds of cells, linear
/// elasticity: a thick-walled sphere under pressure (Lamé), a disc pressed with and without
/// friction (uniform; Gent & Lindley), a sphere on a bonded layer (Garcia & Garcia). Cells that
/// lock in volume miss these by ten per cent to several times. Seconds.
VerificationPart verify_nearly_incompressible(const ElementChecks& checks);

}  // namespace rebound
