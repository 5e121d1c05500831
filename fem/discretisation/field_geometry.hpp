#pragma once

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/grid/tria.h>

#include <vector>

namespace rebound::fem {

/// The deal.II objects behind a Discretisation. Scalar degree of freedom i is
/// node i.
class FieldGeometry {
 public:
  FieldGeometry() : element(1), dofs(triangulation) {}

  dealii::Triangulation<2> triangulation;
  dealii::FE_Q<2> element;
  dealii::DoFHandler<2> dofs;
};

}  // namespace rebound::fem
