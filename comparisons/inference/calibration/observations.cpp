#include "comparisons/inference/calibration/observations.hpp"

namespace rebound {

Observations subset(const Observations& all, const std::vector<bool>& keep) {
  Observations part = all;
  part.shots.clear();
  for (std::size_t i = 0; i < all.shots.size(); ++i)
    if (keep[i]) part.shots.push_back(all.shots[i]);
  return part;
}

std::string name_of(ObservedQuantity observable) {
  switch (observable) {
    case ObservedQuantity::force: return "force";
    case ObservedQuantity::restitution: return "restitution";
    case ObservedQuantity::contact_time: return "contact-time";
    case ObservedQuantity::peak_force: return "peak-force";
    case ObservedQuantity::peak_deflection: return "deflection";
    case ObservedQuantity::mean_deflection: return "mean-deflection";
    case ObservedQuantity::deflection: return "deflection-history";
    case ObservedQuantity::quasistatic: return "quasistatic";
  }
  return {};
}

}  // namespace rebound
