#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "comparisons/discrepancy/diagnosis/observations/quantisation.hpp"
#include "comparisons/inference/calibration/observations.hpp"
#include "comparisons/io/dataset/contact_window.hpp"

/// Records of force as a diagnosis takes them: how fine they are, and where their contact is.
namespace rebound {

constexpr std::size_t fewest_quiet = 20;  ///< samples before contact that make a scatter

/// How fine the readings of a record are.
struct Recorder {
  double step = 0.0;     ///< of rounding; 0: none is seen [N]
  double scatter = 0.0;  ///< of readings in the quiet, or what is stated [N]

  double rounding() const { return quantisation_noise(step); }
  /// Up to twice the scatter errors of rounding are noise of their own, whatever else there is.
  bool is_coarse() const { return step > 2.0 * scatter; }
};

/// A whole record, made coarse enough, and where its contact is.
struct PreparedRecord {
  std::size_t shot = 0;  ///< index among the observations
  Trace trace;
  SampleRange contact;
  Recorder recorder;

  std::span<const double> quiet() const { return {trace.force.data(), contact.first}; }
};

/// The scatter is that while nothing happens, or else what is stated; 0: neither is known.
Recorder recorder_of(const MeasuredImpact& shot);

/// Samples of a contact that a coarse recorder tells: as many as it has steps on the way up and
/// down, for errors within one step are alike.
std::size_t samples_told(const MeasuredImpact& shot, const Recorder& recorder);

/// Interval between samples that leaves so many of a contact, on average over these shots [s]. One
/// for all: noise has another colour where it is averaged over more samples.
double coarse_interval(const Observations& seen, const std::vector<std::size_t>& shots,
                       std::size_t samples);

/// The record of a shot in intervals no longer than `interval`, taken out of the shot; rounding
/// that is worth a word counts as noise.
PreparedRecord prepare_record(std::size_t index, double interval, const Recorder& recorder,
                              Observations& seen);

}  // namespace rebound
