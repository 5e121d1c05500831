// What a joint model says of the impacts: a part of JointModel.
#include "comparisons/discrepancy/diagnosis/fits/joint_model.hpp"
#include "comparisons/discrepancy/diagnosis/fits/record_of_impact.hpp"

#include <algorithm>
#include <cmath>

#include "comparisons/inference/calibration/effective_residuals.hpp"
#include "comparisons/inference/calibration/residual_slopes.hpp"
#include "comparisons/inference/calibration/whitening.hpp"
#include "comparisons/io/dataset/contact_window.hpp"
#include "comparisons/models/instrument/reported_deflection.hpp"
#include "comparisons/models/instrument/reported_force.hpp"
#include "comparisons/models/instrument/sample_step.hpp"

namespace rebound {
namespace {

/// Deflections outside the contact say what happens to a ball in free flight.
SampleRange deflection_range(const Trace& trace) {
  const double peak = *std::max_element(trace.force.begin(), trace.force.end());
  return contact_window(trace.force, clearly_in_contact * peak);
}

/// Where a contact ends the force bends. Once the colour of smooth noise is taken out, a sample at
/// the bend is a wall to a search by slopes, which stops there and believes more than it knows:
/// over this share of a sample the reading goes from one side to the other.
constexpr double share_of_a_sample = 0.05;

double aperture_of(const MeasuredImpact& shot) {
  const std::vector<double>& time = shot.trace.time;
  if (shot.noise.autocorrelation.empty() || time.size() < 2) return 0.0;
  return share_of_a_sample * mean_sample_step(time);
}

}  // namespace

void JointModel::add_rows() {
  std::vector<std::size_t> force_rows;
  for (std::size_t i = 0; i < seen_.shots.size(); ++i) {
    const MeasuredImpact& shot = seen_.shots[i];
    force_rows.push_back(rows_.size());
    for (const double time : shot.trace.time) rows_.push_back({i, ObservedQuantity::force, time});
    if (shot.deflection_noise.deviation > 0.0) {
      const SampleRange range = deflection_range(shot.trace);
      for (std::size_t k = range.first; k <= range.last; ++k)
        rows_.push_back({i, ObservedQuantity::deflection, shot.trace.time[k]});
    }
    for (const ScalarQuantity& scalar : scalar_quantities)
      if ((shot.*scalar.measured).has_error()) rows_.push_back({i, scalar.what, 0.0});
  }
  common_error_.emplace(seen_, force_rows, rows_.size());
}

MeasurementChain JointModel::chain_at(const std::vector<double>& values, std::size_t shot) const {
  MeasurementChain chain = stated_chain(seen_.shots[shot]);
  if (reaches_the_measurement_) apply_effects(effects_of_shot(values, shot), chain);
  nuisances_.apply(values, shot, chain);
  chain.aperture = aperture_of(seen_.shots[shot]);
  return chain;
}

double JointModel::first_touch(const std::vector<double>& values, std::size_t shot) const {
  const auto found = starts_.find(shot);
  return found == starts_.end() ? 0.0 : values[found->second];
}

std::vector<double> JointModel::force_at(const std::vector<double>& values, std::size_t shot,
                                         const std::vector<double>& time) const {
  const ModelledImpact& result = impact(values, shot);
  const MeasurementChain chain = chain_at(values, shot);
  if (!result.plate.moves() && !hypothesis_.model_discrepancy)
    return reported_force(result.trace, chain, time);
  Trace force = contact_and_after(result, chain, time);
  if (hypothesis_.model_discrepancy)
    force = hypothesis_.model_discrepancy->added_to(force, result.scalars, seen_.shots[shot].ball,
                                                    seen_.shots[shot].impact.speed);
  return reported_force(force, chain, time);
}

std::vector<double> JointModel::deflection_at(const std::vector<double>& values, std::size_t shot,
                                              const std::vector<double>& time) const {
  return reported_deflection(impact(values, shot).trace, chain_at(values, shot), time);
}

double JointModel::scalar_at(const std::vector<double>& values, std::size_t shot,
                             const ScalarQuantity& scalar) const {
  const ModelledImpact& result = impact(values, shot);
  const auto& fem = hypothesis_.model_discrepancy;
  const MeasuredImpact& measured = seen_.shots[shot];
  const double ratio = fem ? fem->ratio_of(scalar, measured.ball, measured.impact.speed) : 1.0;
  const double itself = result.scalars.*scalar.modelled;
  if (scalar.what == ObservedQuantity::contact_time)
    return ratio *
           reported_contact_time(result.trace, itself, chain_at(values, shot).contact_threshold);
  if (scalar.what == ObservedQuantity::peak_force)
    return reported(ratio * itself, chain_at(values, shot));
  return ratio * itself;
}

MeasuredImpact JointModel::as_seen(const std::vector<double>& values, std::size_t shot) const {
  MeasuredImpact seen = seen_.shots[shot];
  if (seen.has_history()) seen.trace.force = force_at(values, shot, seen.trace.time);
  if (seen.deflection_noise.deviation > 0.0)
    seen.trace.deflection = deflection_at(values, shot, seen.trace.time);
  for (const ScalarQuantity& scalar : scalar_quantities)
    if (Measured& one = seen.*scalar.measured; one.value)
      one.value = scalar_at(values, shot, scalar);
  seen.noise.zero = 0.0;
  return seen;
}

std::vector<double> JointModel::without_nuisances(std::vector<double> values) const {
  for (std::size_t shot = 0; shot < seen_.shots.size(); ++shot)
    for (const NuisancePlace& place : nuisances_.places(shot))
      if (const auto& prior = unknowns_[place.unknown].prior) values[place.unknown] = prior->mean;
  return values;
}

std::vector<double> JointModel::block_at(const std::vector<double>& values,
                                         std::size_t shot) const {
  const MeasuredImpact& measured = seen_.shots[shot];
  std::vector<double> block;
  if (measured.has_history())
    block = whitened(measured, force_at(values, shot, measured.trace.time));
  if (measured.deflection_noise.deviation > 0.0) {
    const SampleRange range = deflection_range(measured.trace);
    const auto& time = measured.trace.time;
    const std::vector<double> contact(time.begin() + static_cast<std::ptrdiff_t>(range.first),
                                      time.begin() + static_cast<std::ptrdiff_t>(range.last) + 1);
    const auto own = whitened_deflections(measured, range, deflection_at(values, shot, contact));
    block.insert(block.end(), own.begin(), own.end());
  }
  for (const ScalarQuantity& scalar : scalar_quantities)
    if (const Measured& one = measured.*scalar.measured; one.has_error())
      block.push_back((scalar_at(values, shot, scalar) - *one.value) / *one.uncertainty);
  return block;
}

const std::vector<double>& JointModel::block_of(const std::vector<double>& values,
                                                std::size_t shot) const {
  constexpr std::size_t most_blocks = 4;
  std::vector<double> key;
  for (const std::size_t factor : unknowns_of_ball(seen_.shots[shot].ball))
    key.push_back(values[factor]);
  for (std::size_t k = 0; k < effects_.count(); ++k)
    for (const std::size_t index : effects_.places_of_ball(k, seen_.shots[shot].ball))
      key.push_back(values[index]);
  for (const NuisancePlace& place : nuisances_.places(shot)) key.push_back(values[place.unknown]);
  auto& kept = blocks_[shot];
  for (const Block& block : kept)
    if (block.key == key) return block.residuals;
  if (kept.size() == most_blocks) kept.erase(kept.begin());
  kept.push_back({std::move(key), block_at(values, shot)});
  return kept.back().residuals;
}

std::vector<double> JointModel::data_residuals(const std::vector<double>& values) const {
  std::vector<double> residuals;
  residuals.reserve(rows_.size() + unknowns_.size());
  if (fem()) run_fem_ahead(values);
  for (std::size_t i = 0; i < seen_.shots.size(); ++i) {
    const std::vector<double>& block = block_of(values, i);
    residuals.insert(residuals.end(), block.begin(), block.end());
  }
  common_error_->take_out(residuals);
  const std::vector<double> slow = slow_rows_at(values);
  residuals.insert(residuals.end(), slow.begin(), slow.end());
  return residuals;
}

std::vector<double> JointModel::residuals(const std::vector<double>& values) const {
  std::vector<double> residuals = data_residuals(values);
  append_priors(unknowns_, values, residuals);
  return residuals;
}

std::optional<ResidualParts> JointModel::parts() const {
  if (fem() || !common_error_->is_none() || shot_nuisances_.empty()) return std::nullopt;
  ResidualParts all;
  all.parts.resize(seen_.shots.size() + (slow_factors_.empty() ? 0 : 1));
  for (const DataRow& row : rows_) ++all.parts[std::min(row.shot, seen_.shots.size())].rows;
  for (std::size_t shot = 0; shot < seen_.shots.size(); ++shot)
    for (const NuisancePlace& place : nuisances_.places(shot))
      if (std::find(shot_nuisances_.begin(), shot_nuisances_.end(), place.unknown) !=
          shot_nuisances_.end())
        all.parts[shot].own.push_back(place.unknown);
  all.residuals = [this](const std::vector<double>& x, std::size_t part) {
    return part < seen_.shots.size() ? block_of(x, part) : slow_rows_at(x);
  };
  return all;
}

CalibrationProblem JointModel::problem() const {
  return {.parameters = unknowns_,
          .residuals = [this](const std::vector<double>& x) { return data_residuals(x); },
          .parts = parts(),
          .noise = NoiseKnowledge::known,
          .controls = {}};
}

}  // namespace rebound
