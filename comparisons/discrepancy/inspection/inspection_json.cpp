#include "comparisons/discrepancy/inspection/inspection_output.hpp"
#include "comparisons/models/instrument/channel_filter.hpp"

namespace rebound {
namespace {

/// Zero stands for unknown.
Json known(double value) {
  return value > 0.0 ? Json(value) : Json(nullptr);
}

Json check_json(const DataCheck& check) {
  return {{"what", check.what},
          {"of", check.of},
          {"measured", check.measured},
          {"expected", check.expected},
          {"error", check.error},
          {"unit", check.unit.empty() ? "1" : check.unit},
          {"deviations", check.deviations()},
          {"mended_by", check.mended_by}};
}

Json shot_json(const InspectedShot& shot) {
  Json numbers = Json::object();
  for (const InspectedNumber& number : shot.numbers)
    numbers[number.key] = {
        {"value", number.value},
        {"uncertainty", number_or_null(number.uncertainty)},
        {"source", number.source == InspectedNumber::Source::stated ? "stated" : "record"}};
  return {{"label", shot.label},
          {"speed_m_s", shot.speed},
          {"speed_uncertainty_m_s", number_or_null(shot.speed_uncertainty)},
          {"samples", shot.samples},
          {"samples_in_contact", shot.samples_in_contact},
          {"interval_s", known(shot.interval)},
          {"noise_N", known(shot.noise)},
          {"rounding_step_N", known(shot.rounding_step)},
          {"numbers", numbers},
          {"filters", list_of(shot.filters,
                              [](const FilteredPeak& one) {
                                return Json{{"class", one.channel_class},
                                            {"corner_Hz", class_corner(one.channel_class)},
                                            {"peak_change", one.change}};
                              })},
          {"too_coarse", shot.too_coarse}};
}

Json repeat_json(const RepeatedSpeed& repeat) {
  return {{"speed_m_s", repeat.speed}, {"number", repeat.key},
          {"count", repeat.count},     {"mean", repeat.mean},
          {"scatter", repeat.scatter}, {"typical_error", number_or_null(repeat.typical_error)}};
}

}  // namespace

Json to_json(const Inspection& found) {
  return {{"schema", 1},
          {"name", found.name},
          {"shots", list_of(found.shots, shot_json)},
          {"noise",
           {{"from", found.noise.from},
            {"deviation_N", known(found.noise.deviation)},
            {"samples", found.noise.samples},
            {"interval_s", known(found.noise.interval)},
            {"autocorrelation", found.noise.autocorrelation}}},
          {"repeats", list_of(found.repeats, repeat_json)},
          {"checks", list_of(found.checks, check_json)},
          {"contradictions", list_of(found.contradictions, check_json)},
          {"contradiction_limit", found.contradiction_limit},
          {"warnings", found.warnings},
          {"missing", found.missing}};
}

}  // namespace rebound
