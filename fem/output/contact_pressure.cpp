#include "fem/output/contact_pressure.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "fem/discretisation/edge_area.hpp"

namespace rebound::fem {

std::vector<std::array<int, 2>> contact_edges(const std::vector<std::array<int, 4>>& cells,
                                              const std::vector<int>& contact_nodes) {
  std::map<std::pair<int, int>, int> sides;
  for (const auto& cell : cells)
    for (int i = 0; i < 4; ++i) ++sides[std::minmax(cell[i], cell[(i + 1) % 4])];
  const auto touches = [&](int node) {
    return std::find(contact_nodes.begin(), contact_nodes.end(), node) != contact_nodes.end();
  };
  std::vector<std::array<int, 2>> edges;
  for (const auto& [ends, count] : sides)
    if (count == 1 && touches(ends.first) && touches(ends.second))
      edges.push_back({ends.first, ends.second});
  return edges;
}

ContactPressure::ContactPressure(std::vector<std::array<int, 2>> edges,
                                 std::vector<std::array<double, 2>> position, double window)
    : edges_(std::move(edges)),
      position_(std::move(position)),
      half_window_(0.5 * window),
      total_(position_.size(), 0.0),
      older_(total_),
      newer_(total_) {}

void ContactPressure::pass(double time) {
  time_ = time;
  if (time < newer_time_ + half_window_) return;
  std::swap(older_, newer_);
  older_time_ = std::exchange(newer_time_, time);
  newer_ = total_;
}

std::vector<double> ContactPressure::pressure(const std::vector<double>& displacement) const {
  std::vector<double> area(position_.size(), 0.0), pressure(position_.size(), 0.0);
  const auto place = [&](int node) {
    return std::array{position_[node][0] + displacement[2 * node],
                      position_[node][1] + displacement[2 * node + 1]};
  };
  for (const auto& [first, second] : edges_) {
    const auto [at_first, at_second] = edge_areas(place(first), place(second));
    area[first] += at_first;
    area[second] += at_second;
  }
  const double span = time_ - older_time_;
  if (!(span > 0.0)) return pressure;
  for (std::size_t node = 0; node < pressure.size(); ++node)
    if (area[node] > 0.0) pressure[node] = (total_[node] - older_[node]) / (span * area[node]);
  return pressure;
}

}  // namespace rebound::fem
