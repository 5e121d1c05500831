#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparisons/discrepancy/diagnosis/data_checks/data_checks.hpp"
#include "comparisons/discrepancy/diagnosis/data_checks/record_numbers.hpp"
#include "comparisons/inference/calibration/observations.hpp"
#include "comparisons/io/dataset/dataset.hpp"

namespace rebound {

/// A number of a shot, and where it is from.
struct InspectedNumber {
  std::string key;  ///< with its unit, as in results: "peak_force_N"
  double value = 0.0;
  std::optional<double> uncertainty;  ///< one standard deviation; absent: nothing tells it
  enum class Source { stated, record } source = Source::stated;
};

/// What a filter of a channel class does to the peak of a record.
struct FilteredPeak {
  double channel_class = 0.0;
  double change = 0.0;  ///< of the peak, as a share of it; below zero: lower
};

struct InspectedShot {
  std::string label;
  double speed = 0.0;                       ///< [m/s]
  std::optional<double> speed_uncertainty;  ///< as stated [m/s]
  std::size_t samples = 0;                  ///< of its record; 0: it has none
  std::size_t samples_in_contact = 0;       ///< above a tenth of the peak
  double interval = 0.0;                    ///< between samples [s]
  double noise = 0.0;                       ///< of one recorded sample [N]; 0: unknown
  double rounding_step = 0.0;               ///< of the recorder; 0: none is seen [N]
  std::vector<InspectedNumber> numbers;
  std::vector<FilteredPeak> filters;    ///< classes that the sampling allows
  std::vector<std::string> too_coarse;  ///< what this record is no good for, in words
};

/// Noise of the force, from the baseline before contact of all records together.
struct InspectedNoise {
  std::string from;                     ///< in words
  double deviation = 0;                 ///< of one recorded sample [N]; 0: nothing tells
  int samples = 0;                      ///< before contact, that told it
  std::vector<double> autocorrelation;  ///< of neighbours at lags 1…p; empty: white
  double interval = 0.0;                ///< of those samples [s]
};

/// Shots at one speed, within 2 %.
struct RepeatedSpeed {
  double speed = 0.0;  ///< mean [m/s]
  std::string key;     ///< of the number that was repeated
  std::size_t count = 0;
  double mean = 0.0;
  double scatter = 0.0;                 ///< standard deviation of one
  std::optional<double> typical_error;  ///< root mean square of what the shots state
};

/// A data set, looked at without any model of the contact.
struct Inspection {
  std::string name;
  std::vector<InspectedShot> shots;
  InspectedNoise noise;
  std::vector<RepeatedSpeed> repeats;
  std::vector<DataCheck> checks;
  std::vector<DataCheck> contradictions;
  double contradiction_limit = 0.0;   ///< deviations beyond which a check is one
  std::vector<std::string> warnings;  ///< what was assumed or left out
  std::vector<std::string> missing;   ///< what would have been needed for more
};

/// Looks at a data set: numbers of every record with their uncertainties, noise and its colour,
/// checks of the data against themselves, repeats, and what is too coarse to be used.
///
/// The numbers, the noise and the checks are those of the diagnosis (record_numbers.hpp,
/// autocorrelation.hpp, data_checks.hpp): what is said here is what it will work with.
///
///   too coarse   fewer than 20 samples a contact: the contact time is known to half a sample,
///                2.5 % or worse; noise of a sample or a step of the recorder above a twentieth
///                of the peak; a stated bandwidth below 2 over the contact time, which lowers a
///                half sine by 2 %; fewer than 20 samples before contact, which tell no noise
///
/// Beside the checks of data_checks.hpp a stated restitution is held against the straight line
/// between its neighbours in speed (restitution-over-speed): that of a ball is smooth. A bend of
/// |v² d²e/dv²| = 0.5 counts as an error; the one that is furthest out is set apart first.
///
/// Limit:   numbers of a half sine are its closed forms -> test InspectionTest.
Inspection inspect(const Dataset& dataset);

}  // namespace rebound
