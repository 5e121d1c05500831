#include "comparisons/evaluation/atlas/atlas_maps.hpp"

#include <algorithm>
#include <cmath>

namespace rebound {

const std::vector<AtlasQuantity>& atlas_quantities() {
  static const std::vector<AtlasQuantity> list = {
      {"force over time, RMS of peak", [](const AtlasCell& c) { return c.force_rms; }},
      {"restitution", [](const AtlasCell& c) { return std::abs(c.restitution); }},
      {"contact time", [](const AtlasCell& c) { return std::abs(c.contact_time); }},
      {"peak force", [](const AtlasCell& c) { return std::abs(c.peak_force); }},
      {"peak deflection", [](const AtlasCell& c) { return std::abs(c.peak_deflection); }},
  };
  return list;
}

AtlasSpread spread_of(const Atlas& atlas, const AtlasQuantity& quantity, std::size_t law,
                      std::size_t from, std::size_t to) {
  std::vector<double> sizes;
  AtlasSpread spread;
  for (const auto& entry : atlas.entries) {
    const AtlasCell& cell = entry.cells[law][from][to];
    if (cell.failure.empty())
      sizes.push_back(quantity.size(cell));
    else
      ++spread.failures;
  }
  spread.cells = static_cast<int>(sizes.size());
  if (sizes.empty()) return spread;
  std::sort(sizes.begin(), sizes.end());
  const auto at = [&](double share) {
    return sizes[static_cast<std::size_t>(
        std::lround(share * static_cast<double>(sizes.size() - 1)))];
  };
  spread.median = at(0.5);
  spread.ninetieth = at(0.9);
  return spread;
}

AtlasAdvice advice_of(const AtlasEntry& entry, std::size_t from, std::size_t to) {
  AtlasAdvice advice;
  for (std::size_t law = 0; law < entry.cells.size(); ++law) {
    const AtlasCell& cell = entry.cells[law][from][to];
    if (!cell.failure.empty() || (advice.law >= 0 && cell.force_rms >= advice.force_rms)) continue;
    advice = {
        .law = static_cast<int>(law), .force_rms = cell.force_rms, .restitution = cell.restitution};
  }
  return advice;
}

}  // namespace rebound
