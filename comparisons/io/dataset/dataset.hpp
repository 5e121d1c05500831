#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/io/dataset/measured_impact.hpp"
#include "comparisons/io/dataset/trace_channels.hpp"

namespace rebound {

/// The measuring chain. What is absent is unknown, not zero.
struct Instrument {
  std::optional<double> force_noise;             ///< one σ per sample [N]
  std::optional<double> force_gain_uncertainty;  ///< relative, one σ [-]
  std::optional<double> force_bandwidth;         ///< [Hz]
  std::optional<double> force_filter_class;      ///< of SAE J211, applied to the record [Hz]
  std::optional<double> noise_correlation_time;  ///< of the force's noise, first order [s]
  std::optional<double> contact_threshold;       ///< force that starts and ends contact [N]
  std::optional<double> camera_rate;             ///< [Hz]
  DeflectionOrigin deflection = DeflectionOrigin::unknown;
  std::optional<double> deflection_noise;             ///< one σ per sample [m]
  std::optional<double> deflection_gain_uncertainty;  ///< relative, one σ [-]
  /// Scalars, by their keys, that another instrument than the force record gave.
  std::vector<std::string> independent_scalars;
};

/// What the air does to heights and flight times.
enum class AirDrag {
  ignored,   ///< and its size is told among the notes
  corrected  ///< by the closed forms of FreeFall
};
constexpr auto names_of(AirDrag) {
  return names_list<AirDrag>({{"ignored", AirDrag::ignored}, {"corrected", AirDrag::corrected}});
}
struct AirStatement {
  AirDrag drag = AirDrag::ignored;
  std::optional<double> density;           ///< [kg/m³]
  std::optional<double> drag_coefficient;  ///< [-]

  /// With what is usual where nothing is stated.
  Air air() const {
    return {density.value_or(Air{}.density), drag_coefficient.value_or(Air{}.drag_coefficient)};
  }
};

/// Shots in the rows of a table.
struct ShotTable {
  std::string file;
  /// Headings by the key of a shot that the column holds, e.g. {"speed", "inbound_mph"}.
  std::map<std::string, std::string> columns;
  std::string only_column;  ///< rows with `only` in this column; empty: all rows
  std::string only;
  MeasuredImpact common;  ///< what is said of every row alike
  std::optional<double> speed_relative_uncertainty;
  std::optional<double> restitution_relative_uncertainty;
};

/// A slow compression of the whole ball, deflection against force.
struct ForceDeflectionCurve {
  std::vector<double> deflection;  ///< [m]
  std::vector<double> force;       ///< [N]
};

struct Quasistatic {
  /// 1: sphere on one plate; 2: between two platens, deflection is the total.
  int platens = 1;
  std::string trace_file;
  std::optional<ForceDeflectionCurve> curve;
  std::optional<double> force_uncertainty;  ///< relative, of the curve's shape, one σ [-]
  std::optional<double> duration;           ///< of the loading [s]
  Measured stiffness;                       ///< κ of F = κ x^1.5 [N/m^1.5]
};

/// Young's modulus of a block cut from the ball, compressed slowly.
struct BlockTest {
  Measured modulus;  ///< [Pa]
};

/// Peaks said to be typical of several balls together, as in a paper's prose.
/// An order of magnitude, never a measurement of one ball: kept apart from the
/// shots so that nothing can be fitted to it by mistake.
struct PooledPeak {
  double speed = 0.0;             ///< [m/s]
  double force = 0.0;             ///< [N]
  double deflection = 0.0;        ///< [m]
  std::optional<double> scatter;  ///< relative, of balls and readings, one σ [-]
};

/// A ball, an instrument and what was seen with it.
struct Dataset {
  std::string name;
  std::string folder;
  Sphere sphere;
  std::optional<double> mass_uncertainty;      ///< [kg]
  std::optional<double> diameter_uncertainty;  ///< [m]
  Instrument instrument;
  TraceChannels channels;
  AirStatement air;
  std::vector<ShotTable> shot_tables;  ///< emptied once their rows stand among the shots
  std::vector<MeasuredImpact> shots;
  std::vector<Quasistatic> quasistatic;
  std::vector<BlockTest> block_tests;
  std::vector<PooledPeak> pooled_peaks;
  /// Assumptions behind stated numbers, in words, to be shown with results.
  std::vector<std::string> notes;
};

/// A shot with what its data set says of every shot: ball, threshold, bandwidth, noise, where
/// deflections are from.
MeasuredImpact completed(const Dataset& dataset, MeasuredImpact shot);

}  // namespace rebound
