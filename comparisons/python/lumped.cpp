#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "comparisons/io/toml/describe_lumped.hpp"
#include "comparisons/io/toml/impact_file.hpp"
#include "comparisons/io/toml/reader.hpp"
#include "comparisons/models/parallel/in_parallel.hpp"
#include "comparisons/python/binding.hpp"
#include "comparisons/python/impact_result.hpp"
#include "comparisons/studies/campaign/each_number.hpp"
#include "lumped/integration/simulate.hpp"

namespace rebound::python {
namespace {

/// An impact that was read and checked; numbers of it may be replaced.
class Problem {
 public:
  explicit Problem(std::shared_ptr<const Document> document) : document_(std::move(document)) {
    read_lumped_impact(*document_);  // for its errors, that of another tier's file among them
    read_document(*document_, file_);
    complete();
  }

  /// The same impact with other numbers, by the key paths of its file, in SI.
  Problem with(const std::map<std::string, double>& numbers) const {
    Problem changed = *this;
    std::map<std::string, double> left = numbers;
    std::string known;
    const EachNumber::Look look = [&](const std::string& path, const Key& key, double& value) {
      known += (known.empty() ? "" : ", ") + path;
      const auto found = left.find(path);
      if (found == left.end()) return;
      require_in_range(key.range, found->second, {}, path.c_str(), key.unit.c_str());
      value = found->second;
      left.erase(found);
    };
    EachNumber visitor(look);
    describe(visitor, changed.file_);
    if (!left.empty())
      throw Error(ExitCode::bad_input, "the impact gives no number of this name",
                  {.key = left.begin()->first, .allowed = known});
    changed.complete();
    return changed;
  }

  const LumpedProblem& solved() const { return solved_; }
  const Document& document() const { return *document_; }

  Json numbers() {
    Json all = Json::object();
    const EachNumber::Look look = [&](const std::string& path, const Key&, double& value) {
      all[path] = value;
    };
    EachNumber visitor(look);
    describe(visitor, file_);
    return all;
  }

 private:
  void complete() {
    LumpedImpactFile file = file_;  // what follows from other numbers is found anew each time
    solved_ = complete_impact(*document_, file);
  }

  std::shared_ptr<const Document> document_;
  LumpedImpactFile file_;
  LumpedProblem solved_;
};

Problem problem_of(const Source& source) {
  return Problem(std::make_shared<const Document>(document_of(source, "lumped")));
}

LumpedResult simulate_one(const Problem& problem) {
  const py::gil_scoped_release without_lock;
  LumpedResult result;
  problem.document().locating([&] { result = simulate(problem.solved()); });
  return result;
}

/// The fast integrator; CVODE where the contact is too stiff for it.
LumpedResult simulate_soon(const LumpedProblem& problem) {
  try {
    return simulate_fast(problem);
  } catch (const Error& error) {
    if (error.code() != ExitCode::solver_failed) throw;
    return simulate(problem);
  }
}

/// Rows of an array of doubles, one a problem, filled without Python's lock.
struct Rows {
  Rows(std::size_t count, std::size_t samples)
      : array({count, samples}), data(array.mutable_data()), length(samples) {}
  void set(std::size_t row, const std::vector<double>& values) const {
    std::copy(values.begin(), values.end(), data + row * length);
  }

  py::array_t<double> array;
  double* data;
  std::size_t length;
};

constexpr std::array<std::pair<const char*, double ImpactScalars::*>, 7> scalar_members{{
    {"restitution", &ImpactScalars::restitution},
    {"contact_time", &ImpactScalars::contact_time},
    {"contact_time_1pct", &ImpactScalars::contact_time_1pct},
    {"peak_force", &ImpactScalars::peak_force},
    {"peak_deflection", &ImpactScalars::peak_deflection},
    {"mean_deflection", &ImpactScalars::mean_deflection},
    {"rebound_speed", &ImpactScalars::rebound_speed},
}};

py::dict simulate_many(const std::vector<const Problem*>& problems, int threads, bool traces) {
  const std::size_t count = problems.size();
  const auto samples =
      static_cast<std::size_t>(count == 0 ? 0 : problems.front()->solved().controls.samples);
  for (std::size_t i = 0; i < count; ++i)
    if (static_cast<std::size_t>(problems[i]->solved().controls.samples) != samples)
      throw Error(ExitCode::bad_input, "problems of one call need one number of samples",
                  {.key = "controls.samples",
                   .value = std::to_string(problems[i]->solved().controls.samples),
                   .allowed = std::to_string(samples) + ", as in the first"});
  const std::size_t length = traces ? samples : 0;
  const Rows time(count, length), force(count, length), deflection(count, length);
  std::vector<ImpactScalars> scalars(count);
  run_interruptibly([&](const RunControl& control) {
    std::optional<ThreadLimit> limit;
    if (threads != 0) limit.emplace(threads);
    in_parallel(count, [&](std::size_t i) {
      if (control.interrupted()) throw Error(ExitCode::interrupted, "interrupted");
      LumpedResult result;
      problems[i]->document().locating([&] { result = simulate_soon(problems[i]->solved()); });
      scalars[i] = result.scalars;
      if (!traces) return;
      time.set(i, result.trace.time);
      force.set(i, result.trace.force);
      deflection.set(i, result.trace.deflection);
    });
  });
  py::dict found;
  for (const auto& [name, member] : scalar_members) {
    py::array_t<double> column(static_cast<py::ssize_t>(count));
    for (std::size_t i = 0; i < count; ++i) column.mutable_at(i) = scalars[i].*member;
    found[name] = column;
  }
  if (!traces) return found;
  found["time"] = time.array;
  found["force"] = force.array;
  found["deflection"] = deflection.array;
  return found;
}

}  // namespace

void declare_lumped(py::module_& module) {
  py::class_<LumpedResult> result(
      module, "LumpedResult",
      "One impact of the lumped tier, in SI. time, force and deflection are read-only arrays.");
  declare_shared(result);

  py::class_<Problem>(module, "LumpedProblem",
                      "An impact of the lumped tier, read and checked.\n\n"
                      "    LumpedProblem(file)          an impact file\n"
                      "    LumpedProblem(text=...)      the text of one\n"
                      "    LumpedProblem(sphere={...}, impact={...}, model={...})\n\n"
                      "Tables are those of the file. Plain numbers are in SI; a text has its unit.")
      .def(py::init([](const py::object& file, const py::object& text, const py::kwargs& tables) {
             return problem_of({file, text, tables});
           }),
           py::arg("file") = py::none(), py::pos_only(), py::kw_only(),
           py::arg("text") = py::none())
      .def("replace", &Problem::with, py::arg("numbers"),
           "The same impact with other numbers: {'impact.speed': 12.0}, in SI. The result is\n"
           "checked as a file is. Errors name the key and what is allowed.")
      .def_property_readonly(
          "numbers", [](Problem& problem) { return to_python(problem.numbers()); },
          "All numbers of the impact in SI, by the key paths that replace() takes.")
      .def("simulate", &simulate_one, "The impact, by CVODE: a LumpedResult.");

  module.def(
      "lumped",
      [](const py::object& file, const py::object& text, const py::kwargs& tables) {
        return simulate_one(problem_of({file, text, tables}));
      },
      py::arg("file") = py::none(), py::pos_only(), py::kw_only(), py::arg("text") = py::none(),
      "One impact of a contact law, as `rebound lumped`: a LumpedResult.\n"
      "Arguments as LumpedProblem's.");
  module.def("simulate_many", &simulate_many, py::arg("problems"), py::kw_only(),
             py::arg("threads") = 0, py::arg("traces") = true,
             "Many LumpedProblems on all processors (or `threads`), by the fast integrator.\n\n"
             "A dict of arrays, one row a problem, in their order whatever the threads do:\n"
             "restitution, contact_time, contact_time_1pct, peak_force, peak_deflection,\n"
             "mean_deflection, rebound_speed of shape (n,); time, force, deflection of shape\n"
             "(n, samples) unless traces=False. In SI. Ctrl-C is answered within a second.");
}

}  // namespace rebound::python
