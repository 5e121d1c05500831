#include "fem/implicit/adhesive_sides.hpp"

#include <algorithm>

namespace rebound::fem {
namespace {

/// 1 − g/r; 1 at the plate, 0 beyond the range.
double fade(double gap) {
  return std::clamp(1.0 - gap, 0.0, 1.0);
}

}  // namespace

AdhesiveSides::AdhesiveSides(const QuadraticBody& body, const AdhesiveTraction& traction)
    : body_(body), traction_(traction) {
  potential_at_rest_ = potential(Eigen::VectorXd::Zero(2 * body.node_count()));
}

template <class Use>
void AdhesiveSides::each_point(const Eigen::VectorXd& u, const Use& use) const {
  for (const ContactSide& side : body_.contact_sides)
    for (const ContactSide::Point& point : side.points) {
      double gap = point.height;
      for (int i = 0; i < 3; ++i) gap += point.shape[i] * u[2 * side.nodes[i] + 1];
      use(side, point, gap / traction_.range);
    }
}

void AdhesiveSides::add_forces(const Eigen::VectorXd& u, Eigen::VectorXd& force) const {
  const double strength = 2.0 * traction_.work / traction_.range;
  each_point(u, [&](const ContactSide& side, const ContactSide::Point& point, double gap) {
    const double pull = strength * fade(gap) * point.area;
    for (int i = 0; i < 3; ++i) force[2 * side.nodes[i] + 1] += point.shape[i] * pull;
  });
}

void AdhesiveSides::add_derivative(const Eigen::VectorXd& u, SystemMatrix& matrix) const {
  const double slope = -2.0 * traction_.work / (traction_.range * traction_.range);
  each_point(u, [&](const ContactSide& side, const ContactSide::Point& point, double gap) {
    if (gap <= 0.0 || gap >= 1.0) return;  // constant or gone
    std::array<int, 3> unknowns;
    std::array<double, 9> block;
    for (int i = 0; i < 3; ++i) {
      unknowns[i] = 2 * side.nodes[i] + 1;
      for (int j = 0; j < 3; ++j)
        block[3 * i + j] = slope * point.area * point.shape[i] * point.shape[j];
    }
    matrix.add(unknowns, block);
  });
}

double AdhesiveSides::pull(const Eigen::VectorXd& u) const {
  double sum = 0.0;
  each_point(u, [&](const ContactSide&, const ContactSide::Point& point, double gap) {
    sum += fade(gap) * point.area;
  });
  return 2.0 * traction_.work / traction_.range * sum;
}

double AdhesiveSides::potential(const Eigen::VectorXd& u) const {
  double sum = 0.0;
  each_point(u, [&](const ContactSide&, const ContactSide::Point& point, double gap) {
    sum += fade(gap) * fade(gap) * point.area;
  });
  return -traction_.work * sum;
}

}  // namespace rebound::fem
