#include "fem/implicit/adhesive_sides.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rebound::fem {
namespace {

/// Where (row, column) of the lower triangle is among the values of `pattern`.
int place_of(const SystemMatrix& pattern, int a, int b) {
  const int row = std::max(a, b), column = std::min(a, b);
  const int* first = pattern.innerIndexPtr() + pattern.outerIndexPtr()[column];
  const int* last = pattern.innerIndexPtr() + pattern.outerIndexPtr()[column + 1];
  return static_cast<int>(std::lower_bound(first, last, row) - pattern.innerIndexPtr());
}

}  // namespace

AdhesiveSides::AdhesiveSides(const QuadraticBody& body, const AdhesiveTraction& traction,
                             const SystemMatrix& pattern)
    : traction_(traction) {
  constexpr double gauss[3] = {-0.77459666924148337704, 0.0, 0.77459666924148337704};
  constexpr double share[3] = {5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0};
  for (const std::array<int, 3>& side : body.contact_sides)
    for (int q = 0; q < 3; ++q) {
      const double s = gauss[q];
      Point point{.shape = {0.5 * s * (s - 1.0), 0.5 * s * (s + 1.0), 1.0 - s * s}};
      const double slope[3] = {s - 0.5, s + 0.5, -2.0 * s};
      double radius = 0.0, along_r = 0.0, along_z = 0.0;
      for (int i = 0; i < 3; ++i) {
        const auto& x = body.position[side[i]];
        point.unknown[i] = 2 * side[i] + 1;
        point.height += point.shape[i] * x[1];
        radius += point.shape[i] * x[0];
        along_r += slope[i] * x[0];
        along_z += slope[i] * x[1];
      }
      point.area = 2.0 * std::numbers::pi * radius * std::hypot(along_r, along_z) * share[q];
      for (int i = 0, k = 0; i < 3; ++i)
        for (int j = 0; j <= i; ++j)
          point.place[k++] = place_of(pattern, point.unknown[i], point.unknown[j]);
      points_.push_back(point);
    }
  potential_at_rest_ = potential(Eigen::VectorXd::Zero(pattern.rows()));
}

double AdhesiveSides::gap(const Point& point, const Eigen::VectorXd& u) const {
  double gap = point.height;
  for (int i = 0; i < 3; ++i) gap += point.shape[i] * u[point.unknown[i]];
  return gap;
}

double AdhesiveSides::fade(const Point& point, const Eigen::VectorXd& u) const {
  return std::max(0.0, 1.0 - std::max(gap(point, u), 0.0) / traction_.range);
}

double AdhesiveSides::falls(const Point& point, const Eigen::VectorXd& u) const {
  const double g = gap(point, u);
  return g > 0.0 && g < traction_.range ? 1.0 : 0.0;
}

void AdhesiveSides::add_forces(const Eigen::VectorXd& u, Eigen::VectorXd& force) const {
  const double strength = 2.0 * traction_.work / traction_.range;
  for (const Point& point : points_) {
    const double pull = strength * fade(point, u) * point.area;
    for (int i = 0; i < 3; ++i) force[point.unknown[i]] += point.shape[i] * pull;
  }
}

void AdhesiveSides::add_derivative(const Eigen::VectorXd& u, SystemMatrix& matrix) const {
  const double slope = -2.0 * traction_.work / (traction_.range * traction_.range);
  double* values = matrix.valuePtr();
  for (const Point& point : points_) {
    const double weight = slope * falls(point, u) * point.area;
    for (int i = 0, k = 0; i < 3; ++i)
      for (int j = 0; j <= i; ++j) values[point.place[k++]] += weight * point.shape[i] * point.shape[j];
  }
}

double AdhesiveSides::pull(const Eigen::VectorXd& u) const {
  double sum = 0.0;
  for (const Point& point : points_) sum += fade(point, u) * point.area;
  return 2.0 * traction_.work / traction_.range * sum;
}

double AdhesiveSides::potential(const Eigen::VectorXd& u) const {
  double sum = 0.0;
  for (const Point& point : points_) sum += fade(point, u) * fade(point, u) * point.area;
  return -traction_.work * sum;
}

}  // namespace rebound::fem
