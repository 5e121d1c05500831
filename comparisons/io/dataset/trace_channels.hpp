#pragma once

#include <string>

#include "lumped/problem/names.hpp"
#include "lumped/problem/trace.hpp"

namespace rebound {

/// What is taken out of a recorded force.
enum class Baseline {
  as_recorded,
  before_contact,   ///< the mean before contact
  before_and_after  ///< the straight line through the means before and after contact
};
constexpr auto names_of(Baseline) {
  return names_list<Baseline>({{"as-recorded", Baseline::as_recorded},
                               {"before-contact", Baseline::before_contact},
                               {"before-and-after", Baseline::before_and_after}});
}

/// How much of a record is kept.
enum class KeptRecord {
  whole,
  around_contact  ///< five contact lengths before contact and two after
};
constexpr auto names_of(KeptRecord) {
  return names_list<KeptRecord>(
      {{"whole", KeptRecord::whole}, {"around-contact", KeptRecord::around_contact}});
}

/// Which columns of a trace file are what, where its headings are not time, force and deflection.
struct TraceChannels {
  std::string time;             ///< heading; empty: "time"
  std::string force;            ///< empty: "force"
  std::string acceleration;     ///< of the ball: times its mass it is the force
  std::string deflection;       ///< empty: "deflection", where there is one
  std::string time_unit;        ///< of a heading that states none
  std::string force_unit;       ///< of force or acceleration
  std::string deflection_unit;  ///< likewise
  bool reversed = false;        ///< a force, or deceleration, recorded with the other sign
  Baseline baseline = Baseline::as_recorded;
  KeptRecord keep = KeptRecord::whole;
};

/// Takes the baseline out, then cuts.
///
///   contact   from the first to the last force above a tenth of the largest
///   quiet     what lies more than a quarter of the contact before it, and more than one whole
///             contact after it: ten samples or more are needed
///
/// Limit:   a half sine on an offset, or a slope, comes back -> test TraceChannelsTest.
/// Caution: a force that lasts after contact (a ringing plate) bends the line of before-and-after.
/// Errors:  Error(bad_input) with the key where the force is negative where it is largest, or
///          where there is too little quiet for the baseline.
void settle_record(const TraceChannels& channels, Trace& trace);

}  // namespace rebound
