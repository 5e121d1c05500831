#include "comparisons/discrepancy/diagnosis/free_forms.hpp"

#include <algorithm>
#include <cmath>

#include "lumped/mechanisms/unloading_memory.hpp"

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

/// A point of a curve: parameter "PREFIX_K", or the size for the one that is left.
struct Point {
  std::string number;  ///< of the parameter; empty: the size
  double place = 0.0;  ///< over the reach
  double sign = 1.0;   ///< of g in the number
};

struct Curve {
  std::string of;
  std::string reach;  ///< parameter; empty: one
  std::vector<Point> points;
};

std::vector<Point> points_of(const std::string& prefix, std::size_t size_at) {
  std::vector<Point> points;
  for (std::size_t k = 0; k < FactorCurve::points; ++k)
    points.push_back({k == size_at ? "" : prefix + "_" + std::to_string(k),
                      static_cast<double>(k) / static_cast<double>(FactorCurve::points - 1)});
  return points;
}

std::vector<Curve> curves_of(const std::string& name) {
  constexpr std::size_t none = FactorCurve::points;
  if (name == "elastic-curve")
    return {{"deflection_over_radius", "reach", points_of("at", FactorCurve::points - 1)}};
  if (name == "damping-curves")
    return {{"deflection_over_radius", "deflection_reach", points_of("deflection", none)},
            {"rate_m_s", "rate_reach", points_of("rate", 2)}};
  if (name == "unloading-curve") {
    std::vector<Point> points = points_of("at", 2);
    points.pop_back();  // held at one
    points[2].sign = -1.0;
    for (Point& point : points) point.place = unloading_share(point.place);
    return {{"share_of_largest_deflection", "", std::move(points)}};
  }
  return {};
}

const Estimate* estimate_of(const HypothesisFit& fit, std::size_t k, const std::string& number) {
  const std::string name = fit.effects[k].name + (number.empty() ? "" : " " + number);
  for (const std::size_t unknown : fit.model->unknowns_of_effect(k))
    if (fit.search.estimates[unknown].name == name) return &fit.search.estimates[unknown];
  return nullptr;
}

}  // namespace

std::vector<std::string> free_forms(const std::vector<EffectChoice>& present) {
  std::vector<std::string> names;
  for (const Effect& effect : all_effects()) {
    const bool known = std::any_of(present.begin(), present.end(), [&](const EffectChoice& one) {
      return one.name == effect.card.name;
    });
    if (effect.card.is_free_form && !known) names.push_back(effect.card.name);
  }
  return names;
}

std::vector<EffectChoice> starts_of_free_form(const EffectCard& card, const Observations& seen,
                                              const HypothesisFit& fit) {
  const Reach reach = reach_of(seen, fit);
  EffectChoice start{.name = card.name, .size = card.null, .parameters = {}};
  bool has_time = false;
  for (const EffectParameterCard& parameter : card.parameters) {
    double& value = start.parameters[parameter.name];
    value = parameter.default_value;
    if (parameter.kind == ParameterKind::largest_deflection) value = reach.deflection;
    if (parameter.kind == ParameterKind::largest_rate) value = reach.rate;
    value = std::clamp(value, parameter.range.lowest, parameter.range.highest);
    has_time = has_time || parameter.dimension == dimension::time;
  }
  if (!has_time) return {start};
  std::vector<EffectChoice> starts;
  const double contact_time = mean_contact_time(seen, fit);
  for (const double share : {0.2, 1.0}) {
    starts.push_back(start);
    starts.back().size = 0.3 * card.prior_scale;
    for (const EffectParameterCard& parameter : card.parameters)
      if (parameter.dimension == dimension::time)
        starts.back().parameters[parameter.name] = share * contact_time;
  }
  return starts;
}

std::vector<FactorBand> bands_of(const HypothesisFit& fit, std::size_t k) {
  std::vector<FactorBand> bands;
  for (const Curve& curve : curves_of(fit.effects[k].name)) {
    FactorBand& band = bands.emplace_back(FactorBand{.of = curve.of});
    const double reach = curve.reach.empty() ? 1.0 : fit.effects[k].parameters.at(curve.reach);
    for (const Point& point : curve.points) {
      const Estimate* value = estimate_of(fit, k, point.number);
      if (!value) continue;
      band.x.push_back(reach * point.place);
      const double low = 1.0 + point.sign * value->low, high = 1.0 + point.sign * value->high;
      band.factor.push_back(1.0 + point.sign * value->value);
      band.low.push_back(std::min(low, high));
      band.high.push_back(std::max(low, high));
    }
  }
  return bands;
}

}  // namespace rebound
