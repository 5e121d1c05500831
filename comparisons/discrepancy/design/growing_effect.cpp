#include "comparisons/discrepancy/design/growing_effect.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rebound {
namespace {

/// The share that is seen falls with the size; it is measured between half and nearly all found.
constexpr double share_of_rise = 0.7;

/// Between two sizes, as far as their chances go; chances of Φ grow about evenly with √Δχ², so with
/// the size.
SizeOfChance between(const SizeOfChance& a, const SizeOfChance& b, double chance) {
  const double share = (chance - a.gap) / (b.gap - a.gap);
  SizeOfChance one = b;
  one.size = a.size + share * (b.size - a.size);
  one.hidden.size = a.hidden.size + share * (b.hidden.size - a.hidden.size);
  one.gap = chance;
  one.named = a.named + share * (b.named - a.named);
  return one;
}

}  // namespace

GrowingEffect::GrowingEffect(const PlannedData& data, const RefittedChange& refitted,
                             const PlannedPairs* pairs, std::string name, double rise)
    : data_(data), refitted_(refitted), name_(std::move(name)) {
  const EffectCard& card = find_effect(name_).card;
  const bool is_dear = data.fit->model->fem() && !is_measurement(name_);
  least_ = is_dear ? least_visible_to_first_order(*data.around, *data.seen, card, rise)
                   : least_visible(*data.around, card, rise);
  if (!least_) return;
  const std::optional<Eigen::VectorXd> change = refitted.by(least_->effect);
  if (!change) {
    least_.reset();
    return;
  }
  if (is_dear) linear_ = change;
  if (pairs) measure(*pairs, share_of_rise * rise);
}

void GrowingEffect::measure(const PlannedPairs& pairs, double rise) {
  const auto size = size_of(rise);
  const auto change = size ? refitted_.by(at(*size)) : std::nullopt;
  if (change) share_ = pairs.share_seen(at(*size), *change).value_or(1.0);
}

EffectChoice GrowingEffect::at(double size) const {
  EffectChoice one = least_->effect;
  one.size = find_effect(name_).card.null + least_->sign * size;
  return one;
}

std::optional<Eigen::VectorXd> GrowingEffect::change(double size) const {
  if (linear_) return *linear_ * (size / least_->size);
  const std::optional<Eigen::VectorXd> left = refitted_.by(at(size));
  if (!left) return std::nullopt;
  return std::max(1.0, share_) * *left;
}

std::optional<double> GrowingEffect::size_of(double rise) const {
  if (linear_) return least_->size * std::sqrt(rise) / data_.around->project(*linear_).norm();
  return smallest_size(find_effect(name_).card, least_->sign, [&](double size) {
    const auto risen = refitted_.rise(at(size));
    return risen && *risen >= rise;
  });
}

std::vector<SizeOfChance> chances_over_size(const PredictedDiagnosis& predicted,
                                            const GrowingEffect& effect) {
  constexpr double smallest_step = 1.0, step = 0.6, most_steps = 12.0;  // of √Δχ²
  constexpr double surely = 0.98;
  std::vector<SizeOfChance> all;
  for (double root = smallest_step; root < most_steps; root += step) {
    const auto size = effect.size_of(root * root);
    if (!size) break;
    const auto change = effect.change(*size);
    if (!change) break;
    const DiagnosisChances said = predicted.with(effect.name(), *change, effect.share_seen());
    // No effect that is larger is found less often but for the noise of the draws.
    all.push_back({.hidden = effect.at(*size),
                   .size = *size,
                   .gap = all.empty() ? said.gap : std::max(said.gap, all.back().gap),
                   .named = said.named});
    if (all.back().gap >= surely) break;
  }
  return all;
}

std::vector<SizeOfChance> sizes_of_chances(const std::vector<SizeOfChance>& over_size) {
  std::vector<SizeOfChance> sizes;
  for (const double chance : design_chances)
    for (std::size_t i = 1; i < over_size.size(); ++i)
      if (over_size[i - 1].gap < chance && over_size[i].gap >= chance) {
        sizes.push_back(between(over_size[i - 1], over_size[i], chance));
        break;
      }
  return sizes;
}

}  // namespace rebound
