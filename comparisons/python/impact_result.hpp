#pragma once

#include "comparisons/io/results/json.hpp"
#include "comparisons/python/binding.hpp"

namespace rebound::python {

/// A member of the scalars or of the trace, as an attribute of its own name.
template <class Result, class Number>
void declare_scalar(py::class_<Result>& result, const char* name, Number ImpactScalars::*member,
                    const char* docstring) {
  result.def_property_readonly(
      name, [member](const Result& self) { return self.scalars.*member; }, docstring);
}
template <class Result>
void declare_column(py::class_<Result>& result, const char* name,
                    std::vector<double> Trace::*member, const char* docstring) {
  result.def_property_readonly(
      name,
      [member](const py::object& self) {
        return view(self.cast<const Result&>().trace.*member, self);
      },
      docstring);
}

/// What results of both tiers have.
template <class Result>
void declare_shared(py::class_<Result>& result) {
  declare_column(result, "time", &Trace::time, "Time since first touch [s].");
  declare_column(result, "force", &Trace::force, "Force, compression positive [N].");
  declare_column(result, "deflection", &Trace::deflection,
                 "Of the centre of mass, towards the plate positive [m].");
  declare_scalar(result, "restitution", &ImpactScalars::restitution,
                 "Rebound speed over approach speed [-].");
  declare_scalar(result, "contact_time", &ImpactScalars::contact_time,
                 "Until separation, by the problem's rule [s].");
  declare_scalar(result, "contact_time_1pct", &ImpactScalars::contact_time_1pct,
                 "Between first and last crossing of 1 % of the peak force [s].");
  declare_scalar(result, "peak_force", &ImpactScalars::peak_force, "Largest force [N].");
  declare_scalar(result, "peak_deflection", &ImpactScalars::peak_deflection,
                 "Largest deflection [m].");
  declare_scalar(result, "mean_deflection", &ImpactScalars::mean_deflection,
                 "Mean deflection over the contact [m].");
  declare_scalar(result, "rebound_speed", &ImpactScalars::rebound_speed,
                 "Of the centre of mass at separation [m/s].");
  result.def_property_readonly(
      "columns",
      [](const py::object& self) {
        py::dict columns;
        for (const TraceColumn& column : self.cast<const Result&>().trace.further)
          columns[py::str(column.name)] = view(column.values, self);
        return columns;
      },
      "Further columns of the trace by their names, which end in the unit.");
  result.def(
      "as_dict", [](const Result& self) { return to_python(to_json(self)); },
      "What the command prints under --json.");
  result.def("__repr__", [](const Result& self) {
    const ImpactScalars& scalars = self.scalars;
    return py::str("<{}: restitution {:.4g}, contact time {:.4g} s, peak force {:.4g} N>")
        .format(py::type::of<Result>().attr("__name__"), scalars.restitution, scalars.contact_time,
                scalars.peak_force);
  });
}

}  // namespace rebound::python
