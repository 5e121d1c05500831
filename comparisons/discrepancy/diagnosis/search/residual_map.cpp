#include "comparisons/discrepancy/diagnosis/search/residual_map.hpp"

#include <algorithm>
#include <cmath>

#include "comparisons/discrepancy/diagnosis/search/noise_statistics.hpp"

namespace rebound {
namespace {

constexpr double low = 0.2, high = 0.9;  // of the peak force: where phases meet

/// Phase of every force sample of a shot, from the model's own reported force.
std::vector<Phase> phases_of(const HypothesisFit& fit, std::size_t shot,
                             const std::vector<double>& time) {
  const std::vector<double> force = fit.model->force_at(fit.values, shot, time);
  const auto top = std::max_element(force.begin(), force.end());
  std::vector<Phase> phases;
  for (auto f = force.begin(); f != force.end(); ++f) {
    const double share = *f / *top;
    const bool rising = f <= top;
    phases.push_back(share > high  ? Phase::peak
                     : share > low ? (rising ? Phase::loading : Phase::unloading)
                                   : (rising ? Phase::onset : Phase::release));
  }
  return phases;
}

MapCell& cell_for(ResidualMap& map, std::size_t shot, Phase phase, ObservedQuantity what) {
  for (MapCell& cell : map.cells)
    if (cell.shot == shot && cell.phase == phase && cell.what == what) return cell;
  return map.cells.emplace_back(MapCell{.shot = shot, .phase = phase, .what = what});
}

}  // namespace

std::string name_of(Phase phase) {
  switch (phase) {
    case Phase::onset: return "onset";
    case Phase::loading: return "loading";
    case Phase::peak: return "peak";
    case Phase::unloading: return "unloading";
    case Phase::release: return "release";
    case Phase::whole: return "whole";
  }
  return {};
}

ResidualMap residual_map(const Observations& seen, const HypothesisFit& fit,
                         const EffectSensitivities& around, double level, std::uint64_t seed) {
  std::vector<std::vector<Phase>> phases;
  for (std::size_t i = 0; i < seen.shots.size(); ++i)
    phases.push_back(seen.shots[i].has_history() ? phases_of(fit, i, seen.shots[i].trace.time)
                                                 : std::vector<Phase>{});
  ResidualMap map;
  std::vector<std::vector<std::size_t>> members;
  std::vector<std::size_t> next(seen.shots.size(), 0);
  const auto& rows = fit.model->rows();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::size_t shot = rows[i].shot;
    const Phase phase =
        rows[i].what == ObservedQuantity::force ? phases[shot][next[shot]++] : Phase::whole;
    const MapCell& cell = cell_for(map, shot, phase, rows[i].what);
    const auto index = static_cast<std::size_t>(&cell - map.cells.data());
    if (members.size() < map.cells.size()) members.resize(map.cells.size());
    members[index].push_back(i);
  }

  const auto length = static_cast<Eigen::Index>(fit.residuals.size());
  Eigen::MatrixXd units =
      Eigen::MatrixXd::Zero(length, static_cast<Eigen::Index>(map.cells.size()));
  for (std::size_t c = 0; c < map.cells.size(); ++c) {
    MapCell& cell = map.cells[c];
    cell.rows = static_cast<int>(members[c].size());
    double sum = 0.0;
    Eigen::VectorXd indicator = Eigen::VectorXd::Zero(length);
    for (const std::size_t i : members[c]) {
      sum += fit.residuals[i];
      cell.reduced_chi_square += fit.residuals[i] * fit.residuals[i] / cell.rows;
      indicator[static_cast<Eigen::Index>(i)] = 1.0 / std::sqrt(static_cast<double>(cell.rows));
    }
    const Eigen::VectorXd left = around.project(indicator);
    // Hardly anything left: the fit can make this cell's mean whatever it likes.
    constexpr double absorbed = 1e-3;
    if (left.norm() < absorbed) continue;
    cell.z = sum / std::sqrt(static_cast<double>(cell.rows)) / left.norm();
    units.col(static_cast<Eigen::Index>(c)) = left.normalized();
    map.largest = std::max(map.largest, std::abs(cell.z));
  }
  map.threshold = quantile_of_largest(units, level, seed);
  return map;
}

}  // namespace rebound
