#include <fmt/format.h>

#include <utility>

#include "comparisons/python/binding.hpp"

namespace rebound::python {
namespace {

constexpr const char* error_docstring =
    "What the library refuses or could not do.\n\n"
    "message    what is the matter\n"
    "file       the input's file, or None\n"
    "line       its line, and column in it, or None\n"
    "key        full path of the key, such as 'model.material.poisson_ratio', or None\n"
    "value      as it was written, or None\n"
    "allowed    what would have been accepted, or None\n"
    "exit_code  of the command that meets the same error: 2 bad input, 3 no solution,\n"
    "           4 reading or writing failed, 5 a stored result is corrupt";

PyObject* error_class = nullptr;  // lives as long as the module, which is never unloaded

py::object text_or_none(const std::string& text) {
  return text.empty() ? py::object(py::none()) : to_python(Json(text));
}
py::object number_or_none(int number) {
  return number > 0 ? py::object(py::int_(number)) : py::object(py::none());
}

/// Text made of keyword arguments has no lines that its author knows.
ErrorLocation known_to_the_caller(ErrorLocation at) {
  if (at.file != keywords_name) return at;
  at.file.clear();
  at.line = at.column = 0;
  return at;
}

std::string words(const Error& error, const ErrorLocation& at) {
  std::string text;
  if (!at.file.empty()) text += at.file;
  if (at.line > 0) text += fmt::format(":{}", at.line);
  if (!text.empty()) text += ": ";
  if (!at.key.empty()) text += at.key;
  if (!at.key.empty() && !at.value.empty()) text += " = ";
  text += at.value;
  if (!at.key.empty() || !at.value.empty()) text += ": ";
  text += error.what();
  if (!at.allowed.empty()) text += " (allowed: " + at.allowed + ")";
  return text;
}

void raise(const Error& error) {
  const ErrorLocation at = known_to_the_caller(error.location());
  const py::object raised =
      py::reinterpret_borrow<py::object>(error_class)(to_python(Json(words(error, at))));
  raised.attr("message") = to_python(Json(std::string(error.what())));
  raised.attr("file") = text_or_none(at.file);
  raised.attr("line") = number_or_none(at.line);
  raised.attr("column") = number_or_none(at.column);
  raised.attr("key") = text_or_none(at.key);
  raised.attr("value") = text_or_none(at.value);
  raised.attr("allowed") = text_or_none(at.allowed);
  raised.attr("exit_code") = static_cast<int>(error.code());
  PyErr_SetObject(error_class, raised.ptr());
}

}  // namespace

void declare_error(py::module_& module) {
  error_class =
      PyErr_NewExceptionWithDoc("rebound_impact.Error", error_docstring, nullptr, nullptr);
  if (error_class == nullptr) throw py::error_already_set();
  module.attr("Error") = py::reinterpret_borrow<py::object>(error_class);
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(std::move(thrown));
    } catch (const Error& error) {
      raise(error);
    }
  });
}

}  // namespace rebound::python
