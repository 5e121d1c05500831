#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/io/dataset/shot_readings.hpp"
#include "lumped/problem/impact.hpp"
#include "lumped/problem/names.hpp"
#include "lumped/problem/result.hpp"
#include "lumped/problem/trace.hpp"

namespace rebound {

/// A measured scalar and one standard deviation of it, where one is stated.
struct Measured {
  std::optional<double> value;
  std::optional<double> uncertainty;
  /// Read off the record that stands beside it: to be compared with it, and no datum of its own.
  bool repeats_record = false;

  bool is_stated() const { return value && uncertainty && *uncertainty > 0.0; }
  /// Can it be weighed against a model?
  bool has_error() const { return is_stated() && !repeats_record; }
};

/// How a deflection was obtained: whether it holds information of its own.
enum class DeflectionOrigin {
  unknown,
  integrated,   ///< double integral of force over mass: the force again
  independent,  ///< measured by another instrument
};
constexpr auto names_of(DeflectionOrigin) {
  return names_list<DeflectionOrigin>({{"unknown", DeflectionOrigin::unknown},
                                       {"integrated", DeflectionOrigin::integrated},
                                       {"independent", DeflectionOrigin::independent}});
}

/// Errors of the samples of a history, of a force [N] or of a deflection [m].
///
///   covariance of a block of N neighbours   σ² R + u² 1 1ᵀ,   R = I for white noise
struct ForceNoise {
  double deviation = 0.0;  ///< σ of one sample; 0: unknown [N]
  /// Of neighbouring samples at lags 1…p, the rest of R by the autoregressive model of order p
  /// that they make; empty: white [-]
  std::vector<double> autocorrelation{};
  /// u, of an error that neighbours share, such as that of a discretised model [N]
  double shared = 0.0;
  std::size_t shared_by = 1;  ///< N
  double zero = 0.0;          ///< mean before contact [N]
  double zero_error = 0.0;    ///< one standard deviation of it; 0: unknown [N]
};

/// One impact as it was measured, in a laboratory or on a solver: the one record from the file
/// to the fit, the diagnosis and the report.
///
/// What is absent is unknown, not zero. In a Dataset a shot holds what its file says of it
/// alone; completed() adds what the data set says of all. contact_alone() brings the trace
/// under the shared definitions: cut to the contact, time from zero, deflection, scalars.
struct MeasuredImpact {
  std::string label{};   ///< as reports name it
  int number = 0;        ///< among all shots of the data, from 1; 0: of no collection
  Sphere sphere{};       ///< the ball that was hit
  std::size_t ball = 0;  ///< index among the balls of a collection; impacts of one ball share it
  Impact impact{};       ///< speed as stated, the rule by which contact ends
  std::optional<double> speed_uncertainty{};  ///< one standard deviation [m/s]
  std::optional<double> contact_threshold{};  ///< force that starts and ends contact [N]
  std::optional<double> force_bandwidth{};    ///< of the force channel, -3 dB [Hz]
  std::optional<double>
      force_filter_class{};  ///< of SAE J211, by which the force was filtered [Hz]

  std::string trace_file{};  ///< as written; empty: none
  std::string channel{};     ///< column of its force, where one file holds several shots
  /// Force over time; deflection where there is one; empty: no history.
  Trace trace{};
  /// Force after the contact, where nothing touches the plate; no part of what models are fitted
  /// to. Empty: not recorded.
  Trace after_contact{};
  DeflectionOrigin deflection = DeflectionOrigin::unknown;
  ForceNoise noise{};
  ForceNoise deflection_noise{};  ///< deviation 0: deflections are no data [m]

  Measured restitution{};      ///< [-]
  Measured contact_time{};     ///< above the threshold where there is one, else by the rule [s]
  Measured peak_force{};       ///< [N]
  Measured peak_deflection{};  ///< [m]
  Measured mean_deflection{};  ///< time mean over the contact [m]

  ShotReadings readings{};  ///< what speed and restitution were found from, where it was read

  ImpactScalars scalars{};             ///< of a trace under the shared definitions
  std::vector<std::string> assumed{};  ///< what nothing states and was assumed, in words

  bool has_history() const { return !trace.time.empty(); }
};

/// What an impact is seen by.
enum class ObservedQuantity {
  force,
  restitution,
  contact_time,
  peak_force,
  peak_deflection,
  mean_deflection,
  deflection,   ///< a history of its own beside that of the force
  quasistatic,  ///< a slow compression
};

/// A scalar of an impact: as measured, and as a model gives it.
struct ScalarQuantity {
  ObservedQuantity what;
  const char* key;  ///< in files
  Measured MeasuredImpact::*measured;
  double ImpactScalars::*modelled;
};

/// All of them: add one here and readers, fits and diagnosis take it up.
inline constexpr std::array<ScalarQuantity, 5> scalar_quantities{{
    {ObservedQuantity::restitution, "restitution", &MeasuredImpact::restitution,
     &ImpactScalars::restitution},
    {ObservedQuantity::contact_time, "contact_time", &MeasuredImpact::contact_time,
     &ImpactScalars::contact_time},
    {ObservedQuantity::peak_force, "peak_force", &MeasuredImpact::peak_force,
     &ImpactScalars::peak_force},
    {ObservedQuantity::peak_deflection, "peak_deflection", &MeasuredImpact::peak_deflection,
     &ImpactScalars::peak_deflection},
    {ObservedQuantity::mean_deflection, "mean_deflection", &MeasuredImpact::mean_deflection,
     &ImpactScalars::mean_deflection},
}};

}  // namespace rebound
