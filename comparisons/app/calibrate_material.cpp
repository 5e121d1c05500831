#include "comparisons/app/calibrate_material.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparisons/inference/calibration/material_calibration.hpp"
#include "comparisons/inference/calibration/material_calibration_file.hpp"
#include "comparisons/inference/references/measured_impacts.hpp"
#include "comparisons/io/toml/describe_fem.hpp"
#include "comparisons/io/toml/impact_file.hpp"
#include "comparisons/io/toml/reader.hpp"
#include "comparisons/io/toml/toml_writer.hpp"
#include "comparisons/models/fem_access/fem_runner.hpp"
#include "comparisons/models/fem_access/mesh_for.hpp"

namespace rebound {
namespace {

/// All impacts of all folders; they must be of one ball, that of the model.
std::vector<MeasuredImpact> measured_of(const Document& document,
                                        const MaterialCalibrationFile& file, const Sphere& sphere) {
  std::vector<MeasuredImpact> all;
  for (std::size_t i = 0; i < file.folders.size(); ++i) {
    const auto read =
        file.observable == MaterialObservable::force_time ? measured_histories : measured_scalars;
    const std::vector<MeasuredImpact> found =
        read(document.folder() / file.folders[i], {.restitution = file.restitution_uncertainty,
                                                   .contact_time = file.contact_time_uncertainty,
                                                   .force = file.force_uncertainty});
    const Sphere& ball = found.back().sphere;
    constexpr double same = 0.01;  // what a mass or a diameter may be off by between files
    if (std::abs(ball.mass / sphere.mass - 1.0) > same ||
        std::abs(ball.diameter / sphere.diameter - 1.0) > same)
      throw document.error_at(fmt::format("folders[{}]", i),
                              fmt::format("the ball there has {:.4g} g and {:.4g} mm, that of the "
                                          "model {:.4g} g and {:.4g} mm",
                                          1e3 * ball.mass, 1e3 * ball.diameter, 1e3 * sphere.mass,
                                          1e3 * sphere.diameter),
                              "data of the model's ball");
    all.insert(all.end(), found.begin(), found.end());
  }
  return all;
}

struct Fit {
  MaterialCalibration found;
  std::size_t cells;
};

Fit fit(const MaterialCalibrationFile& file, const FemProblem& start,
        const std::vector<MeasuredImpact>& measured, const RunControl& control) {
  const auto numbers = material_numbers(start.material, file.reach);
  std::vector<FreeMaterialNumber> free;
  for (const auto& key : file.free) free.push_back(find_material_number(numbers, key));
  FemProblem slowest = start;
  slowest.impact =
      std::min_element(measured.begin(), measured.end(), [](const auto& a, const auto& b) {
        return a.impact.speed < b.impact.speed;
      })->impact;
  const Mesh mesh = mesh_for(slowest, control);
  return {calibrate_material(start, measured, free, fem_runner(mesh, start.sphere, control),
                             control, file.controls),
          mesh.cells.size()};
}

}  // namespace

bool asks_for_material(const Document& document) {
  return document.root()["tier"].value_or(std::string()) == "fem";
}

CalibrationOutput calibrate_material_file(const Document& document,
                                          const std::filesystem::path& checkpoint,
                                          const RunControl& control) {
  MaterialCalibrationFile file;
  read_document(document, file);
  FemProblem problem = read_fem_file(document.folder() / file.model);
  const std::vector<MeasuredImpact> measured = measured_of(document, file, problem.sphere);
  file.controls.checkpoint = checkpoint;
  auto [found, cells] = [&] {
    try {
      return fit(file, problem, measured, control);
    } catch (const Error& error) {
      throw document.located(error);
    }
  }();
  std::vector<std::string> labels;
  for (const MeasuredImpact& one : measured) {
    labels.push_back(one.label);
    found.fit.warnings.insert(found.fit.warnings.end(), one.assumed.begin(), one.assumed.end());
  }
  problem.material = found.material;
  problem.impact.speed = measured.front().impact.speed;
  return {.head = {{"schema", 1}, {"tier", "fem"}, {"cells", cells}, {"references", labels}},
          .fit = found.fit,
          .seed = file.controls.seed,
          .model_toml = write_toml(problem)};
}

}  // namespace rebound
