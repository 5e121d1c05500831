#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <map>
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

/// An impact that was read and checked; numbers of it may be replaced. Copies share what they hold.
class Problem {
 public:
  explicit Problem(Document document)
      : document_(std::make_shared<const Document>(std::move(document))) {
    read_lumped_impact(*document_);  // for its errors, that of another tier's file among them
    LumpedImpactFile file;
    read_document(*document_, file);
    hold(std::move(file));
  }

  /// The same impact with other numbers, by the key paths of its file, in SI.
  Problem with(const std::map<std::string, double>& numbers) const {
    LumpedImpactFile file = *file_;
    std::map<std::string, double> left = numbers;
    const EachNumber::Look look = [&](const std::string& path, const Key& key, double& value) {
      const auto found = left.find(path);
      if (found == left.end()) return;
      require_in_range(key.range, found->second, {}, path.c_str(), key.unit.c_str());
      value = found->second;
      left.erase(found);
    };
    EachNumber visitor(look);
    describe(visitor, file);
    if (!left.empty()) refuse_name(left.begin()->first);
    Problem changed = *this;
    changed.hold(std::move(file));
    return changed;
  }

  const LumpedProblem& solved() const { return *solved_; }
  const Document& document() const { return *document_; }

  Json numbers() const {
    Json all = Json::object();
    const EachNumber::Look look = [&](const std::string& path, const Key&, double& value) {
      all[path] = value;
    };
    LumpedImpactFile file = *file_;
    EachNumber visitor(look);
    describe(visitor, file);
    return all;
  }

 private:
  /// What follows from other numbers, such as damping from a restitution, is found anew each time.
  void hold(LumpedImpactFile file) {
    file_ = std::make_shared<const LumpedImpactFile>(file);
    solved_ = std::make_shared<const LumpedProblem>(complete_impact(*document_, file));
  }

  [[noreturn]] void refuse_name(const std::string& name) const {
    std::string known;
    const Json all = numbers();
    for (const auto& [key, value] : all.items()) known += (known.empty() ? "" : ", ") + key;
    throw Error(ExitCode::bad_input, "the impact gives no number of this name",
                {.key = name, .allowed = known});
  }

  std::shared_ptr<const Document> document_;
  std::shared_ptr<const LumpedImpactFile> file_;
  std::shared_ptr<const LumpedProblem> solved_;
};

Problem problem_of(const Source& source) {
  return Problem(document_of(source, "lumped"));
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

constexpr std::array<std::pair<const char*, double ImpactScalars::*>, 7> scalar_members{{
    {"restitution", &ImpactScalars::restitution},
    {"contact_time", &ImpactScalars::contact_time},
    {"contact_time_1pct", &ImpactScalars::contact_time_1pct},
    {"peak_force", &ImpactScalars::peak_force},
    {"peak_deflection", &ImpactScalars::peak_deflection},
    {"mean_deflection", &ImpactScalars::mean_deflection},
    {"rebound_speed", &ImpactScalars::rebound_speed},
}};

/// Results of many impacts, one row a problem.
struct Many {
  Many(std::size_t count, std::size_t samples)
      : scalars(count), time(count * samples), force(time.size()), deflection(time.size()) {}

  std::vector<ImpactScalars> scalars;
  std::vector<double> time, force, deflection;
};

std::size_t common_samples(const std::vector<Problem>& problems) {
  const int samples = problems.empty() ? 0 : problems.front().solved().controls.samples;
  for (const Problem& problem : problems)
    if (problem.solved().controls.samples != samples)
      throw Error(ExitCode::bad_input, "problems of one call need one number of samples",
                  {.key = "controls.samples",
                   .value = std::to_string(problem.solved().controls.samples),
                   .allowed = std::to_string(samples) + ", as in the first"});
  return static_cast<std::size_t>(samples);
}

Many compute_many(const std::vector<Problem>& problems, std::size_t samples,
                  const RunControl& control) {
  Many many(problems.size(), samples);
  in_parallel(problems.size(), [&](std::size_t i) {
    if (control.interrupted()) throw Error(ExitCode::interrupted, "interrupted");
    const Problem& problem = problems[i];
    LumpedResult result;
    problem.document().locating([&] { result = simulate_soon(problem.solved()); });
    many.scalars[i] = result.scalars;
    const auto put = [&](const std::vector<double>& from, std::vector<double>& to) {
      if (samples != 0)
        std::copy(from.begin(), from.end(), to.begin() + static_cast<std::ptrdiff_t>(i * samples));
    };
    put(result.trace.time, many.time);
    put(result.trace.force, many.force);
    put(result.trace.deflection, many.deflection);
  });
  return many;
}

py::dict simulate_many(const std::vector<Problem>& problems, int threads, bool traces) {
  const std::size_t samples = traces ? common_samples(problems) : 0;
  Many many = interruptible([problems, samples, threads](const RunControl& control) {
    std::optional<ThreadLimit> limit;
    if (threads != 0) limit.emplace(threads);
    return compute_many(problems, samples, control);
  });
  py::dict found;
  for (const auto& [name, member] : scalar_members) {
    py::array_t<double> column(static_cast<py::ssize_t>(many.scalars.size()));
    for (std::size_t i = 0; i < many.scalars.size(); ++i)
      column.mutable_data()[i] = many.scalars[i].*member;
    found[name] = column;
  }
  if (!traces) return found;
  found["time"] = rows(std::move(many.time), samples);
  found["force"] = rows(std::move(many.force), samples);
  found["deflection"] = rows(std::move(many.deflection), samples);
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
          "numbers", [](const Problem& problem) { return to_python(problem.numbers()); },
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
