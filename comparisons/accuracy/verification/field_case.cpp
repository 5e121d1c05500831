#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparisons/accuracy/verification/element_cases.hpp"
#include "comparisons/accuracy/verification/element_meshes.hpp"
#include "comparisons/accuracy/verification/refinement.hpp"
#include "comparisons/accuracy/verification/targets.hpp"

namespace rebound {
namespace {

const Material unit_material{.youngs_modulus = 2.8, .poisson_ratio = 0.4};  // μ = 1, λ = 4

void add_patch_test(const ElementChecks& checks, CellKind cells, VerificationTable& rows) {
  StretchHistory history;
  for (const targets::UniformPatch& patch : targets::uniform_patches)
    history.stretches.push_back({patch.radial_stretch, patch.axial_stretch});
  const auto stresses = checks.follow(distorted_cylinder(), cells, unit_material, history);
  double stray = 0.0;
  for (std::size_t i = 0; i < stresses.size(); ++i) {
    const targets::UniformPatch& patch = targets::uniform_patches[i];
    const auto add = [&](const char* which, double target, double result) {
      rows.push_back(
          {.case_id = "a",
           .quantity = fmt::format("{} stress of a patch, stretches {:g} and {:g}, {} cells", which,
                                   patch.radial_stretch, patch.axial_stretch, name_of(cells)),
           .unit = "Pa",
           .target = target,
           .result = result,
           .tolerance = 1e-12,
           .source = "uniform neo-Hookean deformation, closed form"});
    };
    add("radial", patch.radial_stress, stresses[i].radial);
    add("axial", patch.axial_stress, stresses[i].axial);
    stray = std::max(stray, stresses[i].stray_force);
  }
  rows.push_back(
      {.case_id = "a",
       .quantity = fmt::format("force inside a patch over that on it, {} cells", name_of(cells)),
       .unit = "",
       .target = 0.0,
       .result = stray,
       .tolerance = 1e-12,
       .scale = ToleranceScale::absolute,
       .source = "uniform stress needs no force"});
}

}  // namespace

VerificationPart verify_fields(const ElementChecks& checks) {
  constexpr int finest = 32;
  VerificationPart part;
  std::vector<Refinement> displacement, gradient;
  for (const CellKind cells : cell_kinds) {
    add_patch_test(checks, cells, part.rows);
    const double order = cells == CellKind::bilinear ? 2.0 : 3.0;
    Refinement u{.name = fmt::format("displacement (L2), {} cells", name_of(cells)),
                 .size = {},
                 .error = {},
                 .expected_order = order};
    Refinement f{.name = fmt::format("gradient (H1), {} cells", name_of(cells)),
                 .size = {},
                 .error = {},
                 .expected_order = order - 1.0};
    for (int n = 4; n <= finest; n *= 2) {
      const FieldError error = checks.manufactured_solution(bent_cylinder(n), cells);
      for (Refinement* norm : {&u, &f}) norm->size.push_back(1.0 / n);
      u.error.push_back(error.displacement);
      f.error.push_back(error.gradient);
    }
    const char* source = "manufactured solution at finite strain, order of the shape functions";
    for (Refinement* norm : {&u, &f}) {
      norm->left_out = 1;  // resolves too little to tell an order
      part.rows.push_back(order_row("a", *norm, source));
    }
    displacement.push_back(std::move(u));
    gradient.push_back(std::move(f));
  }
  const report::Axis size{"cell size", "m"};
  part.figures = {
      refinement_figure({.title = "Manufactured solution, displacement",
                         .caption = "Case a: cylinder of radius 1 at finite strain, bent cells.",
                         .size = size,
                         .error = {"error in L2", "m^2.5"}},
                        displacement),
      refinement_figure({.title = "Manufactured solution, gradient",
                         .caption = "Case a: the same, deformation gradient.",
                         .size = size,
                         .error = {"error in H1", "m^1.5"}},
                        gradient)};
  return part;
}

}  // namespace rebound
