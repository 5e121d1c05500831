#include <pybind11/stl.h>

#include <filesystem>
#include <utility>

#include "comparisons/app/calibrate_law.hpp"
#include "comparisons/app/calibrate_material.hpp"
#include "comparisons/discrepancy/diagnosis/believed_model.hpp"
#include "comparisons/discrepancy/error_rates/error_rates_output.hpp"
#include "comparisons/discrepancy/synthesis/synthesize.hpp"
#include "comparisons/discrepancy/synthesis/truth.hpp"
#include "comparisons/io/dataset/read_dataset.hpp"
#include "comparisons/io/dataset/write_dataset.hpp"
#include "comparisons/python/binding.hpp"

namespace rebound::python {
namespace {

std::filesystem::path path_of(const py::handle& path) {
  return py::str(py::module_::import("os").attr("fspath")(path)).cast<std::string>();
}

py::tuple synthesize_from(const Source& source, const py::object& out) {
  const Document document = document_of(source);
  const SynthesisFile file = read_synthesis(document);
  Synthesis made = interruptible([document, file](const RunControl& control) {
    Synthesis found;
    document.locating([&] { found = synthesize(file, simulator_of(file, control), control); });
    return found;
  });
  if (!out.is_none()) write_dataset(made.dataset, path_of(out));
  const Json truth = truth_json(file, document.text(), made);
  return py::make_tuple(std::move(made.dataset), to_python(truth));
}

py::object calibrate_from(const Source& source) {
  const Document document = document_of(source);
  const auto run = asks_for_material(document) ? calibrate_material_file : calibrate_law_file;
  return to_python(interruptible(
      [document, run](const RunControl& control) { return to_json(run(document, {}, control)); }));
}

struct DiagnoseOptions {
  std::optional<double> held_out_speed;
  bool hold_out = true;
  std::uint64_t seed = 1;
  bool bootstrap = true;
  bool ask_fem = true;
};

py::object diagnose_from(const py::object& data, const Source& model,
                         const DiagnoseOptions& options) {
  std::vector<Dataset> datasets;
  const bool several = py::isinstance<py::list>(data) || py::isinstance<py::tuple>(data);
  for (const py::handle one : several ? py::list(data) : py::list(py::make_tuple(data)))
    datasets.push_back(py::isinstance<Dataset>(one) ? one.cast<Dataset>()
                                                    : read_dataset(path_of(one)));
  const Document document = document_of(model, "lumped");
  DiagnosisRequest request = request_for(document, std::move(datasets));
  request.seed = options.seed;
  request.hold_out = options.hold_out;
  request.held_out_speed = options.held_out_speed;
  if (!options.bootstrap) request.rules.bootstrap_draws = 0;
  if (!options.ask_fem && request.believed_fem)
    throw Error(ExitCode::bad_input, "the believed model is one of finite elements",
                {.key = "ask_fem", .value = "False", .allowed = "with a lumped model"});
  request.ask_fem = options.ask_fem;
  return to_python(interruptible([document, request](const RunControl& control) {
    Json found;
    document.locating([&] { found = json_with_error_rates(diagnose(request, control)); });
    return found;
  }));
}

}  // namespace

void declare_inference(py::module_& module) {
  module.def(
      "synthesize",
      [](const py::object& file, const py::object& text, const py::object& out,
         const py::kwargs& tables) {
        return synthesize_from({file, text, tables}, out);
      },
      py::arg("file") = py::none(), py::pos_only(), py::kw_only(), py::arg("text") = py::none(),
      py::arg("out") = py::none(),
      "A data set as a laboratory would hand it over, with something hidden in it: a Dataset and\n"
      "the truth, as `rebound synthesize` stores it. `out`: a folder that the data set is written "
      "to.");
  module.def(
      "calibrate",
      [](const py::object& file, const py::object& text, const py::kwargs& tables) {
        return calibrate_from({file, text, tables});
      },
      py::arg("file") = py::none(), py::pos_only(), py::kw_only(), py::arg("text") = py::none(),
      "Fits a law, or the material of the FE tier, as `rebound calibrate --json` prints it.\n"
      "Folders are relative to the file, or to where Python runs. 'converged' says whether the\n"
      "search did.");
  module.def(
      "diagnose",
      [](const py::object& data, const py::object& model, const py::object& text,
         const std::optional<double>& held_out_speed, bool hold_out, std::uint64_t seed,
         bool bootstrap, bool ask_fem, const py::kwargs& tables) {
        return diagnose_from(data, {model, text, tables},
                             {.held_out_speed = held_out_speed,
                              .hold_out = hold_out,
                              .seed = seed,
                              .bootstrap = bootstrap,
                              .ask_fem = ask_fem});
      },
      py::arg("data"), py::arg("believed") = py::none(), py::kw_only(),
      py::arg("text") = py::none(), py::arg("held_out_speed") = py::none(),
      py::arg("hold_out") = true, py::arg("seed") = 1, py::arg("bootstrap") = true,
      py::arg("ask_fem") = true,
      "Where a believed model and data part, and which effect is missing, as\n"
      "`rebound diagnose --json` prints it. `data`: a folder, a Dataset, or a list of them.\n"
      "The believed model is an impact file, its text, or its tables as keyword arguments.\n"
      "Without `ask_fem` the lumped law answers alone, sooner.");
}

}  // namespace rebound::python
