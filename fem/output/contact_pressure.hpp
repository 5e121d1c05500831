#pragma once

#include <array>
#include <vector>

namespace rebound::fem {

/// Edges of the surface that may touch: sides of one cell alone whose ends are
/// both among `contact_nodes`. `cells` are node numbers around each cell.
std::vector<std::array<int, 2>> contact_edges(const std::vector<std::array<int, 4>>& cells,
                                              const std::vector<int>& contact_nodes);

/// Contact pressure at the nodes, from the impulses that the plate gives them.
///
///   p_i = (impulse of node i in the window)/(window · A_i),   A_i = ∫ N_i 2π r ds
///
///   N_i  linear shape function along the surface as it is deformed now
///
/// so that ∫ p 2π r ds is the mean force of the window, to rounding
/// -> test ContactPressureTest.IntegratesToTheForce. The window are the last W/2 to W
/// seconds: impulses of one step alternate between nodes.
///
/// Limit:   Hertz's profile at low speed -> test PressureOfAnImpact.IsHertz
/// Caution: the outermost node in contact carries what its half of the open
///          side would: there the pressure is a mean over a side.
class ContactPressure {
 public:
  /// `window` W [s]; `position` of all nodes at rest, (r, z) [m].
  ContactPressure(std::vector<std::array<int, 2>> edges,
                  std::vector<std::array<double, 2>> position, double window);

  /// Impulses of the nodes [N s], compression positive; then the time they lead to.
  void add(int node, double impulse) { total_[node] += impulse; }
  void pass(double time);

  /// Pressure of all nodes [Pa], zero off the surface; `displacement` is [node][2] (r, z).
  std::vector<double> pressure(const std::vector<double>& displacement) const;

 private:
  std::vector<std::array<int, 2>> edges_;
  std::vector<std::array<double, 2>> position_;
  double half_window_;
  double time_ = 0.0, older_time_ = 0.0, newer_time_ = 0.0;
  std::vector<double> total_, older_, newer_;  ///< impulses up to those times
};

}  // namespace rebound::fem
