#include "comparisons/calibration/nuisances.hpp"

#include <fmt/format.h>

namespace rebound {

namespace {

constexpr double reach = 6.0;  // bounds, in standard deviations of the prior

CalibrationParameter unknown(const std::string& name, const char* unit, const Prior& prior) {
  return {.name = name, .unit = unit, .start = prior.mean,
          .lowest = prior.mean - reach * prior.deviation,
          .highest = prior.mean + reach * prior.deviation,
          .scale = prior.deviation, .prior = prior};
}

}  // namespace

NuisanceUnknowns::NuisanceUnknowns(const Nuisances& nuisances, std::size_t shots)
    : nuisances_(nuisances), shots_(shots) {
  if (nuisances.gain > 0.0) parameters_.push_back(unknown("gain", "", {1.0, nuisances.gain}));
  const auto each = [&](const char* name, const char* unit, const Prior& prior) {
    if (!(prior.deviation > 0.0)) return;
    for (std::size_t i = 0; i < shots; ++i)
      parameters_.push_back(unknown(fmt::format("{} of shot {}", name, i + 1), unit, prior));
  };
  each("trigger", "s", {0.0, nuisances.trigger});
  each("baseline", "N", {0.0, nuisances.baseline});
  each("speed factor", "", {1.0, nuisances.speed});
}

NuisancePlaces NuisanceUnknowns::places(std::size_t unknowns, std::size_t shot) const {
  std::size_t at = unknowns - parameters_.size();
  NuisancePlaces places;
  if (nuisances_.gain > 0.0) places.gain = at++;
  const auto each = [&](double deviation, std::optional<std::size_t>& place) {
    if (!(deviation > 0.0)) return;
    place = at + shot;
    at += shots_;
  };
  each(nuisances_.trigger, places.trigger);
  each(nuisances_.baseline, places.baseline);
  each(nuisances_.speed, places.speed_factor);
  return places;
}

RecordErrors NuisanceUnknowns::errors(const std::vector<double>& x, std::size_t shot) const {
  const NuisancePlaces at = places(x.size(), shot);
  RecordErrors errors;
  if (at.gain) errors.gain = x[*at.gain];
  if (at.trigger) errors.trigger = x[*at.trigger];
  if (at.baseline) errors.baseline = x[*at.baseline];
  if (at.speed_factor) errors.speed_factor = x[*at.speed_factor];
  return errors;
}

}  // namespace rebound
