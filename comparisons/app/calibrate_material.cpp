#include "comparisons/app/calibrate_material.hpp"

#include <fmt/format.h>

#include <cmath>

#include "comparisons/app/calibration_output.hpp"
#include "comparisons/app/progress_line.hpp"
#include "comparisons/calibration/material_calibration_file.hpp"
#include "comparisons/config/impact_file.hpp"
#include "comparisons/config/describe_fem.hpp"
#include "comparisons/config/reader.hpp"
#include "comparisons/config/toml_writer.hpp"
#include "comparisons/modules/fem_runner.hpp"
#include "comparisons/references/measured_impacts.hpp"

namespace rebound {
namespace {

/// All impacts of all folders; they must be of one ball, that of the model.
MeasuredBall measured_of(const Document& document, const MaterialCalibrationFile& file,
                         const Sphere& sphere) {
  MeasuredBall all{.sphere = sphere, .impacts = {}, .labels = {}, .notes = {}};
  for (std::size_t i = 0; i < file.folders.size(); ++i) {
    const auto read = file.observable == MaterialObservable::force_time ? measured_histories
                                                                        : measured_ball;
    const MeasuredBall one = read(document.folder() / file.folders[i],
                                  {.restitution = file.restitution_uncertainty,
                                   .contact_time = file.contact_time_uncertainty,
                                   .force = file.force_uncertainty});
    constexpr double same = 0.01;  // what a mass or a diameter may be off by between files
    if (std::abs(one.sphere.mass / sphere.mass - 1.0) > same ||
        std::abs(one.sphere.diameter / sphere.diameter - 1.0) > same)
      throw document.error_at(fmt::format("folders[{}]", i),
                              fmt::format("the ball there has {:.4g} g and {:.4g} mm, that of the "
                                          "model {:.4g} g and {:.4g} mm",
                                          1e3 * one.sphere.mass, 1e3 * one.sphere.diameter,
                                          1e3 * sphere.mass, 1e3 * sphere.diameter),
                              "data of the model's ball");
    all.impacts.insert(all.impacts.end(), one.impacts.begin(), one.impacts.end());
    all.labels.insert(all.labels.end(), one.labels.begin(), one.labels.end());
    all.notes.insert(all.notes.end(), one.notes.begin(), one.notes.end());
  }
  return all;
}

MaterialCalibration fit(const MaterialCalibrationFile& file, const FemProblem& start,
                        const MeasuredBall& measured) {
  const auto numbers = material_numbers(start.material, file.reach);
  std::vector<FreeMaterialNumber> free;
  for (const auto& key : file.free) free.push_back(find_material_number(numbers, key));
  ProgressLine progress("calibration");
  const RunControl control = progress.control();
  return calibrate_material(start, measured.impacts, free,
                            fem_runner(start.sphere, start.cells, control), control, file.controls);
}

}  // namespace

bool asks_for_material(const Document& document) {
  return document.root()["tier"].value_or(std::string()) == "fem";
}

ExitCode calibrate_material_file(const Session& session, const std::string& path,
                                 const Document& document) {
  MaterialCalibrationFile file;
  read_document(document, file);
  FemProblem problem = read_fem_file(document.folder() / file.model);
  if (!problem.mesh_file.empty())
    throw document.error_at("model", "a calibration makes its own mesh: the model names a mesh file");
  const MeasuredBall measured = measured_of(document, file, problem.sphere);
  file.controls.checkpoint = checkpoint_of(session);
  MaterialCalibration found = [&] {
    try {
      return fit(file, problem, measured);
    } catch (const Error& error) {
      throw told_of(error, document, file.controls.checkpoint);
    }
  }();
  found.fit.warnings.insert(found.fit.warnings.end(), measured.notes.begin(), measured.notes.end());
  problem.material = found.material;
  problem.impact.speed = measured.impacts.front().impact.speed;
  return put_out(session, document, path,
                 {.head = {{"schema", 1}, {"tier", "fem"}, {"references", measured.labels}},
                  .fit = found.fit,
                  .seed = file.controls.seed,
                  .model_toml = write_toml(problem)});
}

}  // namespace rebound
