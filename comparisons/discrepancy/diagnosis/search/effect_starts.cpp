// Where searches for effects start: the second part of EffectSensitivities.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <vector>

#include "comparisons/discrepancy/diagnosis/search/effect_sensitivities.hpp"

namespace rebound {
namespace {

bool has_variants(const EffectCard& card) {
  return std::any_of(card.parameters.begin(), card.parameters.end(), makes_variants);
}

/// What tells two variants apart: the numbers as they stay; nothing for one that a fit looks for.
using Variant = std::vector<std::optional<double>>;

Variant variant_of(const EffectCard& card, const EffectChoice& effect) {
  constexpr bool of_fem = false;
  Variant variant;
  for (const EffectParameterCard& one : card.parameters)
    if (makes_variants(one))
      variant.push_back(is_unknown(one, of_fem, effect)
                            ? std::nullopt
                            : std::optional(effect.parameters.at(one.name)));
  return variant;
}

}  // namespace

/// What swings, at the frequencies that gain most.
std::vector<EffectChoice> EffectSensitivities::stronger_where_it_shows(
    const EffectCard& card) const {
  constexpr std::size_t most = 10;
  std::vector<std::pair<double, const EffectChoice*>> gains;
  for (const EffectSensitivity& d : sensitivities_)
    if (d.effect.name == card.name) gains.emplace_back(score_of(d).gain_chi_square, &d.effect);
  if (gains.empty()) return finite_effects(card, seen_, of_starts_);
  std::stable_sort(gains.begin(), gains.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<EffectChoice> all;
  for (std::size_t i = 0; i < std::min(most, gains.size()); ++i)
    for (EffectChoice& one : stronger_effects(*card.oscillator, *gains[i].second, seen_))
      all.push_back(std::move(one));
  return all;
}

/// What is proportional to its size, at the sizes that gain most.
std::vector<EffectChoice> EffectSensitivities::best_to_first_order(const EffectCard& card) const {
  std::vector<EffectChoice> all;
  for (const EffectSensitivity& d : sensitivities_) {
    if (d.effect.name != card.name) continue;
    all.push_back(d.effect);
    all.back().size = std::clamp(score_of(d).size, card.range.lowest, card.range.highest);
  }
  return all;
}

void EffectSensitivities::look_for_starts() {
  const std::vector<EffectChoice> choices = of_all(effects_, [&](const EffectCard& card) {
    return card.is_linear    ? best_to_first_order(card)
           : card.oscillator ? stronger_where_it_shows(card)
                             : finite_effects(card, seen_, of_starts_);
  });
  probes_ = probed(choices);
}

/// The best first.
std::vector<EffectProbe> EffectSensitivities::probed(
    const std::vector<EffectChoice>& choices) const {
  std::vector<EffectProbe> probes;
  const auto moved = moved_residuals(choices);
  for (std::size_t i = 0; i < choices.size(); ++i)
    if (moved[i])
      probes.push_back({.effect = choices[i], .chi_square = project(*moved[i]).squaredNorm()});
  std::stable_sort(probes.begin(), probes.end(), [](const EffectProbe& a, const EffectProbe& b) {
    return a.chi_square < b.chi_square;
  });
  return probes;
}

std::vector<EffectChoice> EffectSensitivities::best_of(const std::vector<EffectChoice>& choices,
                                                       std::size_t count) const {
  std::vector<EffectChoice> best;
  for (EffectProbe& probe : probed(choices))
    if (best.size() < count && probe.chi_square < fit_.chi_square)
      best.push_back(std::move(probe.effect));
  return best;
}

std::vector<double> EffectSensitivities::frequencies_that_show(const std::string& name,
                                                               std::size_t count) const {
  constexpr double line_width = 0.15;  // of a frequency: what one line leaves beside itself
  const auto& oscillator = find_effect(name).card.oscillator;
  const Eigen::Map<const Eigen::VectorXd> r(fit_.residuals.data(),
                                            static_cast<Eigen::Index>(fit_.residuals.size()));
  Eigen::VectorXd left = project(r);
  std::vector<std::pair<double, Eigen::VectorXd>> lines;  // what is taken out of them as of r
  for (const EffectSensitivity& d : sensitivities_)
    if (d.effect.name == name)
      lines.emplace_back(oscillator->frequency_of(d.effect), d.sensitivity.normalized());
  const auto gain = [&](const auto& line) { return std::abs(line.second.dot(left)); };
  std::vector<double> found;
  while (found.size() < count && !lines.empty()) {
    const double frequency =
        std::max_element(lines.begin(), lines.end(), [&](const auto& a, const auto& b) {
          return gain(a) < gain(b);
        })->first;
    found.push_back(frequency);
    const auto beside = std::stable_partition(lines.begin(), lines.end(), [&](const auto& line) {
      return std::abs(std::log(line.first / frequency)) > line_width;
    });
    for (auto taken = beside; taken != lines.end(); ++taken) {
      constexpr double independent = 0.05;  // of a unit vector
      if (taken->second.norm() < independent) continue;
      const Eigen::VectorXd unit = taken->second.normalized();
      left -= unit.dot(left) * unit;
      for (auto other = lines.begin(); other != lines.end(); ++other)
        if (other != taken) other->second -= unit.dot(other->second) * unit;
      taken->second.setZero();
    }
    lines.erase(beside, lines.end());
  }
  return found;
}

std::vector<EffectChoice> EffectSensitivities::starts(const std::string& name,
                                                      std::size_t count) const {
  const EffectCard& card = find_effect(name).card;
  const auto& oscillator = card.oscillator;
  std::vector<EffectChoice> best;
  std::set<Variant> variants;
  for (const EffectProbe& probe : probes_) {
    if (probe.effect.name != name) continue;
    if (has_variants(card)) {
      if (variants.insert(variant_of(card, probe.effect)).second) best.push_back(probe.effect);
      continue;
    }
    if (!oscillator) {
      if (best.size() < count) best.push_back(probe.effect);
      continue;
    }
    constexpr double same = 1e-6;
    if (best.empty() ||
        std::abs(oscillator->frequency_of(probe.effect) / oscillator->frequency_of(best.front()) -
                 1.0) < same)
      best.push_back(probe.effect);
  }
  return best;
}

double EffectSensitivities::best_probe(const std::string& name) const {
  for (const EffectProbe& probe : probes_)
    if (probe.effect.name == name) return probe.chi_square;
  return std::numeric_limits<double>::infinity();
}

}  // namespace rebound
