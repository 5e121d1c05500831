#include <pybind11/stl.h>

#include "comparisons/io/dataset/read_dataset.hpp"
#include "comparisons/python/binding.hpp"

namespace rebound::python {
namespace {

/// (value, one standard deviation), each None where it is not stated; None for neither.
py::object measured(const Measured& number) {
  if (!number.value) return py::none();
  return py::make_tuple(*number.value, py::cast(number.uncertainty));
}

/// Columns of a shot stand in one record with it, which Python keeps alive.
template <class Column>
auto column(Column Trace::*member) {
  return [member](const py::object& self) {
    return view(self.cast<const MeasuredImpact&>().trace.*member, self);
  };
}

void declare_shot(py::module_& module) {
  py::class_<MeasuredImpact> shot(
      module, "Shot",
      "One measured impact, in SI. Scalars are (value, one standard deviation), or None where\n"
      "not stated; arrays are read-only, and empty where nothing was recorded.");
  shot.def_readonly("label", &MeasuredImpact::label)
      .def_property_readonly("speed", [](const MeasuredImpact& self) { return self.impact.speed; })
      .def_readonly("speed_uncertainty", &MeasuredImpact::speed_uncertainty)
      .def_property_readonly("time", column(&Trace::time), "Of the recorder [s].")
      .def_property_readonly("force", column(&Trace::force), "Compression positive [N].")
      .def_property_readonly("deflection", column(&Trace::deflection),
                             "Towards the plate positive [m].");
  for (const ScalarQuantity& quantity : scalar_quantities)
    shot.def_property_readonly(quantity.key,
                               [member = quantity.measured](const MeasuredImpact& self) {
                                 return measured(self.*member);
                               });
}

}  // namespace

void declare_datasets(py::module_& module) {
  declare_shot(module);
  py::class_<Dataset>(module, "Dataset", "A ball, an instrument and what was seen with it, in SI.")
      .def_readonly("name", &Dataset::name)
      .def_readonly("folder", &Dataset::folder)
      .def_property_readonly("mass", [](const Dataset& self) { return self.sphere.mass; })
      .def_property_readonly("diameter", [](const Dataset& self) { return self.sphere.diameter; })
      .def_readonly("notes", &Dataset::notes, "Assumptions behind stated numbers, in words.")
      .def_property_readonly("shots", [](const py::object& self) {
        py::list shots;
        for (const MeasuredImpact& shot : self.cast<const Dataset&>().shots)
          shots.append(py::cast(&shot, py::return_value_policy::reference_internal, self));
        return shots;
      });
  module.def(
      "read_dataset",
      [](const py::object& folder) {
        return read_dataset(
            py::str(py::module_::import("os").attr("fspath")(folder)).cast<std::string>());
      },
      py::arg("folder"), "Reads a data-set folder: its dataset.toml and the CSV files it names.");
}

}  // namespace rebound::python
