#include "comparisons/discrepancy/diagnosis/observations/whole_impact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparisons/io/dataset/contact_window.hpp"

namespace rebound {
namespace {

/// Index before which a record has to end for its first impact alone; its size where there is one.
/// Between the two levels lies more than noise.
std::size_t end_of_first_impact(const std::vector<double>& force, double peak) {
  const auto high = [=](double f) { return f > well_in_contact * peak; };
  const auto low = [=](double f) { return f < clearly_in_contact * peak; };
  const auto touch = std::find_if(force.begin(), force.end(), high);
  for (auto from = touch; from != force.end();) {
    const auto left = std::find_if(from, force.end(), low);
    const auto again = std::find_if(left, force.end(), high);
    if (again != force.end() && 2 * (again - left) > left - touch)
      return static_cast<std::size_t>(left - force.begin() + (again - left) / 2);
    from = again;
  }
  return force.size();
}

/// The longest step of time in the contact where it is a gap; 0: none [s].
double gap_of(const std::vector<double>& time, const SampleRange& contact) {
  std::vector<double> steps;
  for (std::size_t i = contact.first + 1; i <= contact.last; ++i)
    steps.push_back(time[i] - time[i - 1]);
  if (steps.empty()) return 0.0;
  const auto middle = steps.begin() + std::ssize(steps) / 2;
  std::nth_element(steps.begin(), middle, steps.end());
  const double usual = *middle, longest = *std::max_element(steps.begin(), steps.end());
  const bool gap =
      longest > 3.0 * usual && longest > 0.02 * (time[contact.last] - time[contact.first]);
  return gap ? longest : 0.0;
}

}  // namespace

void keep_whole_impact(MeasuredImpact& shot, std::vector<std::string>& warnings) {
  Trace& trace = shot.trace;
  const double peak = *std::max_element(trace.force.begin(), trace.force.end());
  if (!(peak > 0.0)) return;
  const std::size_t end = end_of_first_impact(trace.force, peak);
  if (end < trace.force.size()) {
    warnings.push_back(
        fmt::format("{}: the record holds a second impact; what lies beyond {:.4g} ms is left out",
                    shot.label, 1e3 * trace.time[end]));
    trace.time.resize(end);
    trace.force.resize(end);
    if (!trace.deflection.empty()) trace.deflection.resize(end);
  }
  const SampleRange contact = contact_window(trace.force, clearly_in_contact * peak);
  std::string defect;
  if (contact.first == 0)
    defect = fmt::format("starts in the contact, at {:.2g} of the peak force",
                         trace.force.front() / peak);
  else if (contact.last + 1 == trace.force.size())
    defect = fmt::format("is cut in the contact, at {:.2g} of the peak force",
                         trace.force.back() / peak);
  else if (const double gap = gap_of(trace.time, contact); gap > 0.0)
    defect = fmt::format("has a gap of {:.3g} ms in the contact", 1e3 * gap);
  if (defect.empty()) return;
  warnings.push_back(shot.label + ": the record " + defect + " and is not used");
  trace = {};
}

}  // namespace rebound
