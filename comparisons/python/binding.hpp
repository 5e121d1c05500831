#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "comparisons/io/results/json.hpp"
#include "comparisons/io/toml/document.hpp"
#include "lumped/problem/run_control.hpp"
#include "lumped/problem/trace.hpp"

/// What the files of the Python module share. Each declares its part of `rebound_impact`.
namespace rebound::python {

namespace py = pybind11;

void declare_error(py::module_& module);
void declare_cards(py::module_& module);
void declare_datasets(py::module_& module);
void declare_lumped(py::module_& module);
void declare_fem(py::module_& module);
void declare_inference(py::module_& module);
void declare_interruption(const py::module_& module);

/// Numbers, texts, lists and dicts; what is not finite becomes None, as it does in JSON.
py::object to_python(const Json& json);

/// Where an input comes from: a file, the text of one, or its tables as keyword arguments.
///
/// Tables are those of the file. A plain number in them is in SI, a text has its unit; `tier` and
/// `schema` may be left out. They pass the reader of files, so that every check of a file holds.
/// Errors: Error(bad_input) for none or several of the three, and for a value of a type that no
/// file can hold; those of Document.
struct Source {
  py::object file;
  py::object text;
  py::dict tables;
};
Document document_of(const Source& source, const std::string& tier = {});

/// The name that errors of keyword arguments carry instead of a file's.
inline constexpr const char* keywords_name = "keyword arguments";

/// A read-only view of numbers that live as long as `owner`.
py::array view(const std::vector<double>& values, const py::handle& owner);

/// Numbers that the array takes over, in rows of `length`.
py::array rows(std::vector<double> values, std::size_t length);

/// Long work. It owns all that it touches, nothing of Python among it.
using Work = std::function<void(const RunControl&)>;

/// Does long work on a thread of its own without Python's lock, and looks for signals meanwhile:
/// after Ctrl-C `interrupted` says so, and KeyboardInterrupt is raised within a second. A phase
/// that does not look in that time, such as the set-up of a large mesh, ends behind it; the process
/// waits for it at its own end.
///
/// Signals reach Python's main thread alone; calls from its other threads are not interrupted.
/// Errors: those of the work; the exception that a signal's handler raised.
void run_interruptibly(Work work);

/// The same of work that gives something back.
template <class Compute>
auto interruptible(Compute compute) {
  using Result = std::invoke_result_t<Compute, const RunControl&>;
  const auto result = std::make_shared<std::optional<Result>>();
  run_interruptibly([compute = std::move(compute), result](const RunControl& control) {
    *result = compute(control);
  });
  return std::move(result->value());
}

}  // namespace rebound::python
