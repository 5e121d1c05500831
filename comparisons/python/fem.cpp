#include <array>

#include "comparisons/io/toml/impact_file.hpp"
#include "comparisons/models/fem_access/material_stability.hpp"
#include "comparisons/models/fem_access/mesh_for.hpp"
#include "comparisons/models/fem_access/module_loader.hpp"
#include "comparisons/python/binding.hpp"
#include "comparisons/python/impact_result.hpp"

namespace rebound::python {
namespace {

constexpr std::array<std::pair<const char*, double EnergyBalance::*>, 12> energy_members{{
    {"kinetic_centre_of_mass", &EnergyBalance::kinetic_centre_of_mass},
    {"kinetic_vibration", &EnergyBalance::kinetic_vibration},
    {"stored", &EnergyBalance::stored},
    {"held", &EnergyBalance::held},
    {"dissipated", &EnergyBalance::dissipated},
    {"contact_constraint", &EnergyBalance::contact_constraint},
    {"friction", &EnergyBalance::friction},
    {"adhesion", &EnergyBalance::adhesion},
    {"plate_kinetic", &EnergyBalance::plate_kinetic},
    {"plate_spring", &EnergyBalance::plate_spring},
    {"plate_damper", &EnergyBalance::plate_damper},
    {"gravity", &EnergyBalance::gravity},
}};

py::dict energies_of(const FemResult& result) {
  py::dict energies;
  for (const auto& [name, member] : energy_members) {
    py::array_t<double> column(static_cast<py::ssize_t>(result.energies.size()));
    for (std::size_t i = 0; i < result.energies.size(); ++i)
      column.mutable_at(i) = result.energies[i].*member;
    energies[name] = column;
  }
  return energies;
}

FemResult simulate_fem(const Source& source) {
  const Document document = document_of(source, "fem");
  const FemProblem problem = read_fem_problem(document);
  if (problem.controls.field_frames != 0)
    throw document.error_at("controls.field_frames", "fields are written by `rebound fem --out`",
                            "0 in Python");
  return interruptible([document, problem](const RunControl& control) {
    FemResult result;
    document.locating([&] {
      result = watched_impact(problem, mesh_for(problem, control), control);
      if (!result.incomplete_because.empty())
        throw Error(ExitCode::solver_failed, result.incomplete_because);
    });
    return result;
  });
}

}  // namespace

void declare_fem(py::module_& module) {
  py::class_<FemResult> result(
      module, "FemResult",
      "One impact of the FE tier, in SI. time, force and deflection are read-only arrays.");
  declare_shared(result);
  result
      .def_readonly("restitution_momentum", &FemResult::restitution_momentum,
                    "Restitution from the nodes' velocities, never from the force [-].")
      .def_readonly("contact_radius_peak", &FemResult::contact_radius_peak,
                    "Largest radius of the contact [m].")
      .def_readonly("cells", &FemResult::cells, "Cells of the mesh.")
      .def_readonly("steps", &FemResult::steps, "Steps taken.")
      .def_property_readonly("energies", &energies_of,
                             "Where the energy is, an array a channel, one value a sample [J].");
  module.def(
      "fem",
      [](const py::object& file, const py::object& text, const py::kwargs& tables) {
        return simulate_fem({file, text, tables});
      },
      py::arg("file") = py::none(), py::pos_only(), py::kw_only(), py::arg("text") = py::none(),
      "One impact of the finite-element model, as `rebound fem`: a FemResult.\n\n"
      "Arguments as LumpedProblem's, with the tables of an FE impact file. The FE tier is\n"
      "loaded at the first call. Ctrl-C is answered within a second.");
  module.def("has_fem", &has_fem_tier, "Was this module built with the FE tier?");
}

}  // namespace rebound::python
