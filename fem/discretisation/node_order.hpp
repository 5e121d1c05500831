#pragma once

#include <deal.II/dofs/dof_handler.h>

namespace rebound::fem {

/// Numbers the nodes of a bilinear space so that neighbours lie side by side: as the mesh does, or
/// by reverse Cuthill–McKee, whichever has fewer diagonals. A diagonal is a distance in number at
/// which any node of a block has a neighbour; a mesh that counts its vertices row by row has
/// little more than eight to a block, one that counts them at random some thirty.
///
/// Limit: the rows of the built-in mesh are kept; of vertices numbered at random Cuthill–McKee's
///        remain -> test DiscretisationTest.NodesAreNumberedForFewDiagonals
void number_nodes(dealii::DoFHandler<2>& nodes);

}  // namespace rebound::fem
