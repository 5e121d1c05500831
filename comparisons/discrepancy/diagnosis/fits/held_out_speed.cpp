#include "comparisons/discrepancy/diagnosis/fits/held_out_speed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr double smallest_difference = 0.02;  // of a speed: closer ones tell the same
constexpr double deviations = 3.0;
constexpr std::size_t fewest_speeds = 3;

/// Are two shots of the same speed, as well as it is known?
bool same_speed(const MeasuredImpact& a, const MeasuredImpact& b) {
  const double error =
      std::hypot(a.speed_uncertainty.value_or(0.0), b.speed_uncertainty.value_or(0.0));
  const double slack = std::max(deviations * error, smallest_difference * b.impact.speed);
  return std::abs(a.impact.speed - b.impact.speed) <= slack;
}

}  // namespace

std::vector<SpeedCluster> speed_clusters(const Observations& all) {
  std::vector<std::size_t> order(all.shots.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return all.shots[a].impact.speed < all.shots[b].impact.speed;
  });
  std::vector<SpeedCluster> clusters;
  for (const std::size_t shot : order) {
    if (clusters.empty() || !same_speed(all.shots[clusters.back().shots.back()], all.shots[shot]))
      clusters.emplace_back();
    clusters.back().shots.push_back(shot);
  }
  for (SpeedCluster& cluster : clusters) {
    for (const std::size_t shot : cluster.shots) cluster.speed += all.shots[shot].impact.speed;
    cluster.speed /= static_cast<double>(cluster.shots.size());
  }
  return clusters;
}

std::optional<SpeedCluster> choose_held_out(const Observations& all, std::optional<double> wanted) {
  const std::vector<SpeedCluster> clusters = speed_clusters(all);
  if (wanted) {
    for (const SpeedCluster& cluster : clusters)
      for (const std::size_t shot : cluster.shots) {
        MeasuredImpact asked = all.shots[shot];
        asked.impact.speed = *wanted;
        if (same_speed(asked, all.shots[shot])) return cluster;
      }
    throw Error(ExitCode::bad_input, "no shot of the data has the speed to be held out",
                {.key = "hold-out", .value = fmt::format("{:g} m/s", *wanted)});
  }
  if (clusters.size() < fewest_speeds) return std::nullopt;
  return clusters[clusters.size() / 2];
}

PartedShots part_at(const Observations& all, const std::optional<SpeedCluster>& held_out) {
  std::vector<bool> left_out(all.shots.size(), false);
  if (held_out)
    for (const std::size_t shot : held_out->shots) left_out[shot] = true;
  std::vector<bool> fitted = left_out;
  fitted.flip();
  PartedShots parts{.seen = subset(all, fitted), .unseen = subset(all, left_out)};
  parts.unseen.compressions.clear();  // the fit has seen them
  return parts;
}

}  // namespace rebound
