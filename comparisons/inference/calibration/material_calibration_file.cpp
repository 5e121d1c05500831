#include "comparisons/inference/calibration/material_calibration_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparisons/inference/calibration/calibration_file.hpp"
#include "comparisons/inference/references/measured_impacts.hpp"
#include "comparisons/io/toml/describe_impact.hpp"
#include "comparisons/io/toml/impact_file.hpp"
#include "comparisons/models/fem_access/fem_runner.hpp"
#include "comparisons/models/fem_access/mesh_for.hpp"

namespace rebound {
namespace {

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

}  // namespace

void describe(Visitor& visit, MaterialCalibrationFile& file) {
  describe_schema(visit);
  std::string tier = "fem";
  visit.text(
      {.name = "tier", .sentence = "Numbers of an FE material, not of a law.", .allowed = {"fem"}},
      tier);
  visit.text({.name = "model",
              .sentence = "FE impact file: cells, and the material that the search starts from; "
                          "relative to this file."},
             file.model);
  visit.texts({.name = "free",
               .sentence = "Numbers that are fitted: \"youngs_modulus\", \"branch[0].ratio\", "
                           "\"branch[0].relaxation_time\", and so on."},
              file.free);
  visit.texts({.name = "folders",
               .sentence = "Data sets, or results of `lumped` or `fem --out`; relative to this "
                           "file. Every shot is fitted."},
              file.folders);
  visit.choice({.name = "observable",
                .sentence = "What is fitted: restitution and contact time, or "
                            "the force over time where there are traces.",
                .presence = Presence::optional},
               file.observable);
  visit.number({.name = "force_uncertainty",
                .sentence = "Standard deviation of a force that states none, over the peak.",
                .presence = Presence::optional,
                .range = above(0.0)},
               file.force_uncertainty);
  visit.number({.name = "reach",
                .sentence = "Bounds of a number: this many times its start, either way.",
                .presence = Presence::optional,
                .range = between(1.0, 1e4)},
               file.reach);
  describe_search(visit, file.controls);
  visit.number({.name = "restitution_uncertainty",
                .sentence = "Standard deviation of a restitution that states none.",
                .presence = Presence::optional,
                .range = above(0.0)},
               file.restitution_uncertainty);
  visit.number({.name = "contact_time_uncertainty",
                .sentence = "Standard deviation of a contact time that states none, as a share.",
                .presence = Presence::optional,
                .range = above(0.0)},
               file.contact_time_uncertainty);
}

MaterialCalibrationInput read_input(const Document& document, const MaterialCalibrationFile& file) {
  FemProblem start = read_fem_file(document.folder() / file.model);
  std::vector<MeasuredImpact> measured = measured_of(document, file, start.sphere);
  return {std::move(start), std::move(measured)};
}

MeshedCalibration calibrate_material(const MaterialCalibrationFile& file,
                                     const MaterialCalibrationInput& input,
                                     const RunControl& control) {
  const auto& [start, measured] = input;
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

}  // namespace rebound
