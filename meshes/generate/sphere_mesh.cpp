#include "meshes/generate/sphere_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <utility>

#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

using Point = std::complex<double>;  // r + i z

constexpr double largest_grading = 200.0;  ///< beyond, the far cells cannot follow the shape
constexpr double rings_per_core_cell = 0.41;
/// Core sides lie this far from straight to arcs: cells of about equal size.
constexpr double bulge = 0.35;

/// Cells from the axis to the core's side, and rings around the core.
struct Blocks {
  int core = 1;
  int rings = 1;

  int cells() const { return 2 * core * core + 4 * core * rings; }
  /// Radius of the core's corners over the disc's: rings about as thick as core cells.
  double corner_radius() const { return std::clamp(1.0 - 0.53 * rings / core, 0.5, 0.85); }
};

Blocks blocks_for(int cells) {
  Blocks blocks;
  blocks.core = std::max(
      1, static_cast<int>(std::lround(std::sqrt(cells / (2.0 + 4.0 * rings_per_core_cell)))));
  const double left = cells - 2.0 * blocks.core * blocks.core;
  blocks.rings = std::max(1, static_cast<int>(std::lround(left / (4.0 * blocks.core))));
  return blocks;
}

/// Vertex numbers of the core, of the rings around it, and their places on the
/// unit disc before grading.
class Disc {
 public:
  explicit Disc(const Blocks& blocks) : blocks_(blocks) {
    const int n = blocks.core;
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= 2 * n; ++j)
        places_.push_back(core_place(static_cast<double>(i) / n, static_cast<double>(j) / n - 1.0));
    for (int k = 0; k <= 4 * n; ++k) {
      const Point inside = places_[perimeter(k)];
      const double angle = std::numbers::pi * k / (4.0 * n);
      const Point on_circle(std::sin(angle), -std::cos(angle));
      for (int ring = 1; ring <= blocks.rings; ++ring)
        places_.push_back(inside +
                          (on_circle - inside) * (static_cast<double>(ring) / blocks.rings));
    }
  }

  const std::vector<Point>& places() const { return places_; }
  int core(int i, int j) const { return i * (2 * blocks_.core + 1) + j; }
  /// Vertex k of the way round the core from the lower axis to the upper, out by some rings.
  int around(int k, int ring) const {
    if (ring == 0) return perimeter(k);
    const int first = (blocks_.core + 1) * (2 * blocks_.core + 1);
    return first + k * blocks_.rings + ring - 1;
  }

 private:
  int perimeter(int k) const {
    const int n = blocks_.core;
    if (k <= n) return core(k, 0);
    if (k <= 3 * n) return core(n, k - n);
    return core(4 * n - k, 2 * n);
  }
  /// The core's lower side at t in [−1, 1].
  Point side(double t) const {
    const double radius = blocks_.corner_radius(), half = radius / std::numbers::sqrt2;
    const double angle = 0.25 * std::numbers::pi * t;
    const Point straight(half * t, -half), arc(radius * std::sin(angle), -radius * std::cos(angle));
    return straight + bulge * (arc - straight);
  }
  /// Transfinite interpolation of the four sides; x, y in [−1, 1].
  Point core_place(double x, double y) const {
    const double half = blocks_.corner_radius() / std::numbers::sqrt2;
    const Point lower = side(x), upper = std::conj(side(x));
    const Point right = side(y) * Point(0, 1), left = -std::conj(right);
    const Point corners(half * x, half * y);
    return 0.5 * ((1 - y) * lower + (1 + y) * upper + (1 - x) * left + (1 + x) * right) - corners;
  }

  Blocks blocks_;
  std::vector<Point> places_;
};

void add_cells(Mesh& mesh, const Disc& disc, const Blocks& blocks) {
  const int n = blocks.core;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < 2 * n; ++j)
      mesh.cells.push_back(
          {disc.core(i, j), disc.core(i + 1, j), disc.core(i + 1, j + 1), disc.core(i, j + 1)});
  for (int k = 0; k < 4 * n; ++k)
    for (int ring = 0; ring < blocks.rings; ++ring)
      mesh.cells.push_back({disc.around(k, ring + 1), disc.around(k + 1, ring + 1),
                            disc.around(k + 1, ring), disc.around(k, ring)});
}

/// Möbius grading of a grading.
double draw_of(double grading) {
  const double root = std::sqrt(grading);
  return (root - 1.0) / (root + 1.0);
}

/// Boundary vertex, counted from the pole, that becomes the corner of the lower
/// half: the one nearest to where the grading leaves it.
int corner_for(double grading, int count) {
  const double angle = 0.5 * std::numbers::pi + 2.0 * std::atan(grading);
  return std::clamp(static_cast<int>(std::lround(angle / std::numbers::pi * count)), count / 2,
                    count - 1);
}

/// Conformal map of the unit disc to its lower half that keeps −i and ±1 and takes i to 0.
Point fold(const Point& w) {
  // √(−i m) as √m √−i: m lies right of the imaginary axis, far from the cut.
  const Point root =
      std::sqrt((1.0 + w) / (1.0 - w)) * Point(std::numbers::sqrt2 / 2, -std::numbers::sqrt2 / 2);
  return (root - 1.0) / (root + 1.0);
}

/// Edges of axis and contact; the circle up to boundary vertex `last`.
void add_boundary(Mesh& mesh, const Disc& disc, const Blocks& blocks, int last) {
  const int n = blocks.core, rings = blocks.rings;
  for (int ring = rings; ring > 0; --ring)
    mesh.axis_edges.push_back({disc.around(0, ring), disc.around(0, ring - 1)});
  for (int j = 0; j < 2 * n; ++j) mesh.axis_edges.push_back({disc.core(0, j), disc.core(0, j + 1)});
  for (int ring = 0; ring < rings; ++ring)
    mesh.axis_edges.push_back({disc.around(4 * n, ring), disc.around(4 * n, ring + 1)});
  for (int k = 0; k < last; ++k)
    mesh.contact_edges.push_back({disc.around(k, rings), disc.around(k + 1, rings)});
}

void check(const SphereMeshRequest& request) {
  const auto refuse = [](const char* key, double value, const char* allowed) {
    throw Error(ExitCode::bad_input, std::string("sphere mesh: ") + key + " is out of range",
                {.key = key, .value = std::to_string(value), .allowed = allowed});
  };
  if (!(request.radius > 0 && std::isfinite(request.radius)))
    refuse("radius", request.radius, "> 0 m");
  if (request.cells < 20)
    throw Error(ExitCode::bad_input, "sphere mesh: cells is out of range",
                {.key = "cells", .value = std::to_string(request.cells), .allowed = "20 and more"});
  if (!(request.grading >= 1 && request.grading <= largest_grading))
    refuse("grading", request.grading, "[1, 200]");
}

}  // namespace

double grading_for_contact(int cells, double contact_over_radius) {
  constexpr double even = 1.5;  ///< the default: a contact of a third of the radius and more
  if (!(contact_over_radius > 0.0 && contact_over_radius < 1.0) || cells < 20) return even;
  constexpr double fewest = 8.0, share = 0.125;
  const double around = 4.0 * blocks_for(cells).core;
  const double in_contact = std::min(std::max(fewest, share * around), 0.5 * around);
  const double root = std::tan(0.5 * std::numbers::pi * in_contact / around) /
                      std::tan(0.5 * std::asin(contact_over_radius));
  return std::clamp(root * root, even, largest_grading);
}

Mesh generate_sphere_mesh(const SphereMeshRequest& request) {
  check(request);
  const Blocks blocks = blocks_for(request.cells);
  const Disc disc(blocks);
  const int count = 4 * blocks.core;
  const bool half = request.part == SpherePart::lower_half;
  double grading = draw_of(request.grading);
  const int last = half ? corner_for(grading, count) : count;
  if (half) grading = std::tan(0.5 * std::numbers::pi * (static_cast<double>(last) / count - 0.5));
  Mesh mesh;
  for (const Point& place : disc.places()) {
    Point drawn = (place - Point(0, grading)) / (1.0 + Point(0, grading) * place);
    if (half) drawn = fold(drawn);
    mesh.vertices.push_back({request.radius * drawn.real(), request.radius * (1.0 + drawn.imag())});
  }
  add_cells(mesh, disc, blocks);
  add_boundary(mesh, disc, blocks, last);
  // The axis and the pole are constraints of the discretisation: exactly zero, not 1e-19.
  for (const auto& edge : mesh.axis_edges)
    for (const int vertex : edge) mesh.vertices[static_cast<std::size_t>(vertex)][0] = 0.0;
  mesh.vertices[static_cast<std::size_t>(disc.around(0, blocks.rings))][1] = 0.0;
  for (int k = last; half && k <= count; ++k)
    mesh.vertices[static_cast<std::size_t>(disc.around(k, blocks.rings))][1] = request.radius;
  if (half)
    mesh.vertices[static_cast<std::size_t>(disc.around(last, blocks.rings))][0] = request.radius;
  return mesh;
}

}  // namespace rebound
