#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "comparisons/accuracy/verification/element_cases.hpp"
#include "comparisons/accuracy/verification/element_meshes.hpp"
#include "comparisons/accuracy/verification/refinement.hpp"
#include "comparisons/accuracy/verification/targets.hpp"
#include "meshes/generate/sphere_mesh.hpp"

namespace rebound {
namespace {

constexpr std::size_t mode_count = std::size(targets::sphere_modes);

/// The frequency of the mode that a target names.
double frequency_of(const FreeVibration& found, const targets::SphereMode& mode) {
  return mode.place < 0 ? found.radial : found.frequencies.at(mode.place);
}

FreeVibration vibrate(const ElementChecks& checks, const Mesh& mesh, CellKind cells,
                      VibratingMass mass) {
  return checks.free_vibration(mesh, cells, mass,
                               {.radius = targets::ball_radius,
                                .mass = targets::ball_mass,
                                .material = {.youngs_modulus = targets::ball_modulus,
                                             .poisson_ratio = targets::ball_poisson_ratio}});
}

Mesh even_sphere(int cells) {
  return generate_sphere_mesh({.radius = targets::ball_radius, .cells = cells, .grading = 1.0});
}

/// Root of the mean area of a cell of the half-disc.
double cell_size(const Mesh& mesh) {
  return targets::ball_radius *
         std::sqrt(0.5 * std::numbers::pi / static_cast<double>(mesh.cells.size()));
}

constexpr const char* source = "Lamb's frequency equations of the elastic sphere";

/// Errors of all modes over the cells of one kind.
struct Family {
  std::vector<Refinement> modes;
  Refinement all;  ///< root of the mean square over the modes
};

Refinement empty_refinement(const std::string& what, CellKind cells) {
  return {.name = fmt::format("{}, {} cells", what, name_of(cells)),
          .size = {},
          .error = {},
          .expected_order = cells == CellKind::bilinear ? 2.0 : 4.0,
          .tolerance = 0.3};
}

Family run_family(const ElementChecks& checks, CellKind cells, VerificationTable& rows) {
  const bool bilinear = cells == CellKind::bilinear;
  Family family{.modes = {}, .all = empty_refinement("four frequencies", cells)};
  for (const targets::SphereMode& mode : targets::sphere_modes)
    family.modes.push_back(empty_refinement(mode.name, cells));
  FreeVibration finest;
  int count = 0;
  for (int asked = bilinear ? 250 : 30; asked <= (bilinear ? 2000 : 240); asked *= 2) {
    const Mesh mesh = even_sphere(asked);
    finest = vibrate(checks, mesh, cells, VibratingMass::own);
    count = static_cast<int>(mesh.cells.size());
    double squares = 0.0;
    for (std::size_t i = 0; i < mode_count; ++i) {
      const targets::SphereMode& mode = targets::sphere_modes[i];
      const double error = std::abs(frequency_of(finest, mode) / mode.frequency - 1.0);
      family.modes[i].size.push_back(cell_size(mesh));
      family.modes[i].error.push_back(error);
      squares += error * error;
    }
    family.all.size.push_back(cell_size(mesh));
    family.all.error.push_back(std::sqrt(squares / mode_count));
  }
  for (const targets::SphereMode& mode : targets::sphere_modes)
    rows.push_back(
        {.case_id = "b",
         .quantity = fmt::format("frequency, {}, {} {} cells", mode.name, count, name_of(cells)),
         .unit = "Hz",
         .target = mode.frequency,
         .result = frequency_of(finest, mode),
         .tolerance = bilinear ? 1e-3 : 2e-5,
         .source = source});
  return family;
}

/// Contact nodes without inertia, as in impacts, move the frequency by less and less.
void add_mass_of_impacts(const ElementChecks& checks, VerificationTable& rows) {
  const targets::SphereMode& mode = targets::sphere_modes[0];
  const auto error = [&](int cells) {
    return frequency_of(vibrate(checks, even_sphere(cells), CellKind::nine_node,
                                VibratingMass::as_in_impacts),
                        mode) /
               mode.frequency -
           1.0;
  };
  const double coarse = error(30), fine = error(120);
  rows.push_back(
      {.case_id = "b",
       .quantity = fmt::format("frequency, {}, 120 nine-node cells, mass as in impacts", mode.name),
       .unit = "Hz",
       .target = mode.frequency,
       .result = mode.frequency * (1.0 + fine),
       .tolerance = 3e-3,
       .order = std::log2(std::abs(coarse / fine)),
       .source = source});
  rows.push_back({.case_id = "b",
                  .quantity = "what the mass of impacts changes at 120 cells over that at 30",
                  .unit = "",
                  .target = 0.0,
                  .result = std::abs(fine / coarse),
                  .tolerance = 0.5,
                  .scale = ToleranceScale::absolute,
                  .source = "inertia is taken from one row of nodes"});
}

}  // namespace

VerificationPart verify_free_vibration(const ElementChecks& checks) {
  VerificationPart part;
  std::vector<Refinement> drawn;
  for (const CellKind cells : cell_kinds) {
    const Family family = run_family(checks, cells, part.rows);
    const Refinement &spheroidal = family.modes.front(), &radial = family.modes.back();
    // Not the order of l = 2: with lumped mass its errors of stiffness and mass nearly
    // cancel, and what is left falls faster than either.
    for (const Refinement* one : {&radial, &family.all})
      part.rows.push_back(order_row("b", *one, "order of the energy of the shape functions"));
    drawn.insert(drawn.end(), {spheroidal, radial, family.all});
  }
  add_mass_of_impacts(checks, part.rows);
  part.figures = {refinement_figure(
      {.title = "Frequencies of the elastic sphere",
       .caption =
           "Case b: deviation from Lamb's frequencies, even meshes; R = 33.1 mm, m = 89.6 g, "
           "E = 10 MPa, Poisson ratio 0.4. Of l = 2 on bilinear cells the errors of stiffness and "
           "of "
           "lumped mass nearly cancel.",
       .size = {"cell size", "m"},
       .error = {"relative error of the frequency", "1"}},
      drawn)};
  return part;
}

}  // namespace rebound
