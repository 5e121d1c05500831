#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "comparisons/accuracy/verification/element_cases.hpp"
#include "comparisons/accuracy/verification/element_meshes.hpp"
#include "meshes/generate/cylinder_mesh.hpp"

namespace rebound {
namespace {

constexpr double modulus = 1.0;
constexpr double ratios[] = {0.45, 0.49, 0.499};
constexpr double shear_of(double ratio) {
  return 0.5 * modulus / (1.0 + ratio);
}
constexpr double bulk_of(double ratio) {
  return modulus / (3.0 * (1.0 - 2.0 * ratio));
}

LinearStatics problem_of(double ratio) {
  LinearStatics problem;
  problem.material = {.youngs_modulus = modulus, .poisson_ratio = ratio};
  return problem;
}

std::string of(const char* what, double ratio, CellKind cells) {
  return fmt::format("{}, Poisson ratio {:g}, {} cells", what, ratio, name_of(cells));
}

/// Outer radius twice the inner, 1; the inner surface moves out by a millionth, the outer is free:
///   u = A ρ + B/ρ²,   3 K A = 4 μ B/b³,   pressure inside 4 μ B (1/a³ − 1/b³)
void thick_sphere(const ElementChecks& checks, double ratio, CellKind cells,
                  VerificationTable& rows) {
  constexpr double inner = 1.0, outer = 2.0, travel = 1e-6;
  const double mu = shear_of(ratio), share = 4.0 * mu / (3.0 * bulk_of(ratio)) / std::pow(outer, 3);
  const double b = travel / (share * inner + 1.0 / (inner * inner)), a = share * b;
  const double pressure = 4.0 * mu * b * (1.0 / std::pow(inner, 3) - 1.0 / std::pow(outer, 3));
  const auto exact = [&](double rho) { return a * rho + b / (rho * rho); };
  LinearStatics problem = problem_of(ratio);
  const auto inside = [&](double rho) { return rho < inner * (1.0 + 1e-9); };
  problem.radial = [&](double r, double z) -> std::optional<double> {
    const double rho = std::hypot(r, z);
    if (!inside(rho)) return std::nullopt;
    return exact(rho) * r / rho;
  };
  problem.axial = [&](double r, double z) -> std::optional<double> {
    const double rho = std::hypot(r, z);
    if (z == 0.0) return 0.0;
    if (!inside(rho)) return std::nullopt;
    return exact(rho) * z / rho;
  };
  const int around = cells == CellKind::bilinear ? 32 : 16;
  const LinearAnswer found =
      checks.linear_statics(quarter_of_thick_sphere(inner, outer, around), cells, problem);
  double work = 0.0, miss = 0.0;
  for (std::size_t i = 0; i < found.position.size(); ++i) {
    const auto& [r, z] = found.position[i];
    const double rho = std::hypot(r, z);
    const auto& [ur, uz] = found.displacement[i];
    if (inside(rho)) work += found.force[i][0] * ur + (z > 0.0 ? found.force[i][1] * uz : 0.0);
    miss = std::max(miss,
                    std::hypot(ur - exact(rho) * r / rho, uz - exact(rho) * z / rho) / exact(rho));
  }
  const double area = 2.0 * std::numbers::pi * inner * inner;
  const char* source =
      "Lamé, thick-walled sphere under pressure, closed form; polygons of the mesh";
  rows.push_back({.case_id = "nearly incompressible",
                  .quantity = of("thick-walled sphere, pressure inside", ratio, cells),
                  .unit = "Pa",
                  .target = pressure,
                  .result = work / (area * travel),
                  .tolerance = 5e-3,
                  .source = source});
  rows.push_back(
      {.case_id = "nearly incompressible",
       .quantity = of("thick-walled sphere, largest miss of a displacement", ratio, cells),
       .unit = "",
       .target = 0.0,
       .result = miss,
       .tolerance = 5e-3,
       .scale = ToleranceScale::absolute,
       .source = source});
}

/// A disc of radius 1 pressed by a millionth of its height; apparent modulus over Young's.
double pressed_disc(const ElementChecks& checks, const Mesh& mesh, double height, bool bonded,
                    double ratio, CellKind cells) {
  constexpr double strain = 1e-6;
  LinearStatics problem = problem_of(ratio);
  const auto end = [&](double z) { return z == 0.0 || z > height * (1.0 - 1e-12); };
  problem.axial = [&](double, double z) -> std::optional<double> {
    if (!end(z)) return std::nullopt;
    return z == 0.0 ? 0.0 : -strain * height;
  };
  if (bonded)
    problem.radial = [&](double, double z) -> std::optional<double> {
      return end(z) ? std::optional<double>(0.0) : std::nullopt;
    };
  const LinearAnswer found = checks.linear_statics(mesh, cells, problem);
  double force = 0.0;
  for (std::size_t i = 0; i < found.position.size(); ++i)
    if (found.position[i][1] > 0.5 * height && end(found.position[i][1]))
      force -= found.force[i][1];
  return force / (std::numbers::pi * strain * modulus);
}

void pressed_discs(const ElementChecks& checks, double ratio, CellKind cells,
                   VerificationTable& rows) {
  constexpr double height = 0.25, shape = 1.0 / (2.0 * height);
  const int fine = cells == CellKind::bilinear ? 2 : 1;
  const Mesh mesh = cylinder_mesh(
      {.radius = 1.0, .length = height, .cells_across = 32 * fine, .cells_along = 8 * fine});
  rows.push_back(
      {.case_id = "nearly incompressible",
       .quantity = of("disc pressed without friction, modulus over Young's", ratio, cells),
       .unit = "",
       .target = 1.0,
       .result = pressed_disc(checks, mesh, height, false, ratio, cells),
       .tolerance = 1e-5,  // a stiffness by differences: rounding times K over the modulus
       .source = "uniform stress, closed form"});
  if (ratio < 0.49) return;
  const double apparent = 1.0 + 2.0 * shape * shape;
  rows.push_back(
      {.case_id = "nearly incompressible",
       .quantity = of("bonded disc of shape factor 2, modulus over Young's", ratio, cells),
       .unit = "",
       .target = 1.0 / (1.0 / apparent + modulus / bulk_of(ratio)),
       .result = pressed_disc(checks, mesh, height, true, ratio, cells),
       .tolerance = 0.05,
       .source = "Gent & Lindley 1959, E (1 + 2 S²) with bulk compression; its own "
                 "error is some per cent"});
}

/// Rigid sphere on a bonded incompressible layer, force over that of a half-space; χ = √(R δ)/h.
double garcia(double chi) {
  return 1.0 + chi * (1.133 + chi * (1.497 + chi * (1.469 + chi * 0.755)));
}

void indented_layer(const ElementChecks& checks, double chi, CellKind cells,
                    VerificationTable& rows) {
  constexpr double ratio = 0.499, depth = 1e-6, width = 5.0;
  const double radius = chi * chi / depth;
  LinearStatics problem = problem_of(ratio);
  problem.radial = problem.axial = [](double, double z) -> std::optional<double> {
    return z == 0.0 ? std::optional<double>(0.0) : std::nullopt;
  };
  problem.indenter = [&](double r, double z) -> std::optional<double> {
    if (z < 1.0 - 1e-9 || r > 1.0) return std::nullopt;
    return r * r / (2.0 * radius) - depth;
  };
  const double finest = cells == CellKind::bilinear ? 0.02 : 0.04;
  const LinearAnswer found = checks.linear_statics(
      layer_mesh({.height = 1.0, .width = width, .finest = finest}), cells, problem);
  double force = 0.0;
  for (std::size_t i = 0; i < found.position.size(); ++i)
    if (problem.indenter(found.position[i][0], found.position[i][1])) force -= found.force[i][1];
  const double half_space =
      4.0 / 3.0 * modulus / (1.0 - ratio * ratio) * std::sqrt(radius) * std::pow(depth, 1.5);
  rows.push_back(
      {.case_id = "nearly incompressible",
       .quantity = fmt::format("sphere on a bonded layer, force over half-space's, "
                               "sqrt(R delta)/h = {:g}, Poisson ratio {:g}, {} cells",
                               chi, ratio, name_of(cells)),
       .unit = "",
       .target = garcia(chi),
       .result = force / half_space,
       .tolerance = 0.02,
       .source = "Garcia & Garcia, Biophys. J. 114 (2018) 2923-2932, incompressible layer"});
}

}  // namespace

VerificationPart verify_nearly_incompressible(const ElementChecks& checks) {
  VerificationPart part;
  for (const CellKind cells : cell_kinds) {
    for (const double ratio : ratios) {
      thick_sphere(checks, ratio, cells, part.rows);
      pressed_discs(checks, ratio, cells, part.rows);
    }
    for (const double chi : {0.25, 0.4, 0.5}) indented_layer(checks, chi, cells, part.rows);
  }
  return part;
}

}  // namespace rebound
