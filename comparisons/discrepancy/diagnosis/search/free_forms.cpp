#include "comparisons/discrepancy/diagnosis/search/free_forms.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <optional>

#include "comparisons/discrepancy/diagnosis/fits/curve_numbers.hpp"
#include "comparisons/discrepancy/diagnosis/search/assessed_fit.hpp"
#include "comparisons/discrepancy/diagnosis/search/effect_grid.hpp"

namespace rebound {
namespace {

/// Largest deflection over the radius and largest speed of the shots, by the fitted model.
struct Reach {
  double deflection = 0.0;  ///< [-]
  double rate = 0.0;        ///< [m/s]
};

Reach reach_of(const Observations& seen, const HypothesisFit& fit) {
  Reach reach;
  for (std::size_t i = 0; i < seen.shots.size(); ++i) {
    const MeasuredImpact& shot = seen.shots[i];
    const double deflection = fit.model->impact(fit.values, i).scalars.peak_deflection;
    reach.deflection = std::max(reach.deflection, 2.0 * deflection / shot.sphere.diameter);
    reach.rate = std::max(reach.rate, shot.impact.speed);
  }
  return reach;
}

double mean_contact_time(const Observations& seen, const HypothesisFit& fit) {
  double sum = 0.0;
  for (std::size_t i = 0; i < seen.shots.size(); ++i)
    sum += fit.model->impact(fit.values, i).scalars.contact_time;
  return sum / static_cast<double>(seen.shots.size());
}

/// Of all unknowns, priors counted.
Eigen::MatrixXd covariance_of(const HypothesisFit& fit) {
  const Eigen::MatrixXd slopes = jacobian_at(*fit.model, fit.values);
  return (slopes.transpose() * slopes).completeOrthogonalDecomposition().pseudoInverse();
}

/// A band over its own mean, with the errors of that ratio: what another level would change is no
/// error of the shape.
void keep_shape(FactorBand& band, const std::vector<std::size_t>& unknowns,
                const std::vector<double>& sign, const Eigen::MatrixXd& covariance) {
  constexpr double deviations = 1.959964;  // 95 %
  const auto count = static_cast<Eigen::Index>(unknowns.size());
  Eigen::MatrixXd own(count, count);
  for (Eigen::Index i = 0; i < count; ++i)
    for (Eigen::Index j = 0; j < count; ++j) {
      const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
      own(i, j) = sign[a] * sign[b] *
                  covariance(static_cast<Eigen::Index>(unknowns[a]),
                             static_cast<Eigen::Index>(unknowns[b]));
    }
  const Eigen::Map<const Eigen::VectorXd> factor(band.factor.data(), count);
  const double mean = factor.mean();
  const Eigen::VectorXd shape = factor / mean;
  for (Eigen::Index k = 0; k < count; ++k) {
    Eigen::VectorXd weight =
        Eigen::VectorXd::Constant(count, -shape(k) / static_cast<double>(count));
    weight(k) += 1.0;
    const double error = std::sqrt(std::max(0.0, weight.dot(own * weight))) / mean;
    const auto i = static_cast<std::size_t>(k);
    band.factor[i] = shape(k);
    band.low[i] = shape(k) - deviations * error;
    band.high[i] = shape(k) + deviations * error;
  }
}

}  // namespace

std::vector<std::string> free_forms(const std::vector<EffectChoice>& present,
                                    bool after_single_effects) {
  std::vector<std::string> names;
  for (const Effect& effect : all_effects())
    if (effect.card.is_free_form && effect.card.after_single_effects == after_single_effects)
      names.push_back(effect.card.name);
  return absent_from(present, names);
}

std::vector<EffectChoice> starts_of_free_form(const EffectCard& card, const Observations& seen,
                                              const HypothesisFit& fit) {
  const Reach reach = reach_of(seen, fit);
  EffectChoice start{.name = card.name, .size = card.null, .parameters = {}};
  for (const EffectParameterCard& parameter : card.parameters) {
    double& value = start.parameters[parameter.name];
    value = parameter.default_value;
    if (parameter.kind == ParameterKind::largest_deflection) value = reach.deflection;
    if (parameter.kind == ParameterKind::largest_rate) value = reach.rate;
    value = std::clamp(value, parameter.range.lowest, parameter.range.highest);
  }
  std::vector<EffectChoice> starts{start};
  if (!card.begins_from.empty()) {
    EffectChoice& other = starts.emplace_back(start);
    for (const auto& [name, value] : card.begins_from) other.parameters[name] = value;
  }
  for (const EffectParameterCard& parameter : card.parameters) {
    if (!is_unknown(parameter, fit.model->fem() != nullptr, start)) continue;
    std::vector<double> places = parameter.tried;
    if (parameter.dimension == dimension::time) {
      const double contact = mean_contact_time(seen, fit);
      places.insert(places.end(), {0.2 * contact, contact});
    }
    if (places.empty()) continue;
    // A place or a time says nothing at no size; a large one puts a search far off its valley.
    start.size = 0.03 * card.prior_scale;
    starts = with_each({start}, parameter.name, places);
  }
  return starts;
}

std::vector<EffectChoice> starts_of_a_pair(const EffectCard& card, const Observations& seen,
                                           const EffectSensitivities& around) {
  constexpr std::size_t lines = 3, searches = 3;
  const std::vector<double> shown = around.frequencies_that_show(card.contains, lines);
  const double ball = seen.shots.front().sphere.mass;
  std::vector<EffectChoice> all;
  for (std::size_t i = 0; i < shown.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (const double share : {0.1, 0.25, 0.4, 0.55, 0.7, 0.85})
        for (const double strength : {0.03, 0.1, 0.3})
          all.push_back(card.oscillator_pair->with(
              std::min(shown[i], shown[j]), std::max(shown[i], shown[j]), share, strength, ball));
  return around.best_of(all, searches);
}

std::vector<EffectChoice> starts_around_a_part(const EffectCard& card, const EffectChoice& part,
                                               const Observations& seen,
                                               const EffectSensitivities& around) {
  constexpr std::size_t searches = 3;
  const OscillatorCard& oscillator = *find_effect(part.name).card.oscillator;
  const double ball = seen.shots.front().sphere.mass, own = oscillator.frequency_of(part);
  const double strength = ball / part.parameters.at("mass");
  std::vector<EffectChoice> all;
  for (const double ratio : {0.2, 0.3, 0.4, 0.55, 0.75})
    for (const double slow : {own, own * ratio})
      for (const double share : {0.2, 0.4, 0.6, 0.8})
        for (const double factor : {0.5, 1.0, 2.0}) {
          all.push_back(
              card.oscillator_pair->with(slow, slow / ratio, share, factor * strength, ball));
          all.back().parameters.at("damping_ratio") = part.parameters.at("damping_ratio");
        }
  return around.best_of(all, searches);
}

std::vector<FactorBand> bands_of(const HypothesisFit& fit, std::size_t k) {
  std::vector<FactorBand> bands;
  std::optional<Eigen::MatrixXd> covariance;
  for (const CurveCard& curve : find_effect(fit.effects[k].name).card.curves) {
    FactorBand& band = bands.emplace_back(FactorBand{.of = curve.of, .quantity = curve.quantity});
    const double reach = curve.reach.empty() ? 1.0 : fit.effects[k].parameters.at(curve.reach);
    const double nothing = curve.quantity == "factor" ? 1.0 : 0.0;
    std::vector<std::size_t> unknowns;
    std::vector<double> sign;
    for (const CurveCard::Point& point : curve.points) {
      const auto unknown = unknown_of(fit, k, point.number);
      if (!unknown) continue;
      const Estimate& value = fit.search.estimates[*unknown];
      unknowns.push_back(*unknown);
      sign.push_back(point.sign);
      band.x.push_back(reach * point.place);
      const double low = nothing + point.sign * value.low;
      const double high = nothing + point.sign * value.high;
      band.factor.push_back(nothing + point.sign * value.value);
      band.low.push_back(std::min(low, high));
      band.high.push_back(std::max(low, high));
    }
    if (!curve.level_is_the_laws) continue;
    if (!covariance) covariance = covariance_of(fit);
    keep_shape(band, unknowns, sign, *covariance);
  }
  return bands;
}

}  // namespace rebound
