#pragma once

#include "comparisons/evaluation/export/export_target.hpp"

/// One writer a code, each in the file of its name. The text is without its head, which
/// export_deck() writes from what the writers say is different.
/// Errors: Error(bad_input) for a law or a kind of relaxation that the code does not have.
namespace rebound {

/// CalculiX 2.20: a wedge of bricks with curved sides (C3D20R), since its axisymmetric elements
/// take no initial velocity; face-to-face penalty contact on a plate of one brick; *DYNAMIC.
DeckBody calculix_deck(const ImpactToExport& impact);

/// Abaqus/Explicit: CAX4R on an analytical rigid surface, kinematic contact.
DeckBody abaqus_deck(const ImpactToExport& impact);

/// FEBio 4: a wedge of bricks (hex20) on a rigid brick, sliding-elastic contact, implicit dynamics.
DeckBody febio_deck(const ImpactToExport& impact);

/// LS-DYNA: a quarter in bricks of eight nodes (formulation 2) on a planar rigid wall.
DeckBody lsdyna_deck(const ImpactToExport& impact);

/// FEniCSx 0.5: a Python script that runs the impact, axisymmetric, nine nodes a cell, with a
/// volume ratio of the cell where the FE tier has one, penalty contact, Newmark's method.
DeckBody fenicsx_deck(const ImpactToExport& impact);

}  // namespace rebound
