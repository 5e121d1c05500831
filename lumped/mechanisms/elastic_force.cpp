#include "lumped/mechanisms/elastic_force.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <limits>
#include <string>

#include "lumped/mechanisms/elastic_factors.hpp"
#include "lumped/mechanisms/unloading_memory.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {

namespace {

using Gauss = boost::math::quadrature::gauss<double, 30>;

double law_force(const AnyLaw& law, double x) {
  return std::visit([x](const auto& l) { return l.elastic_force(x); }, law);
}

/// Where the factors change their formula, as deflections [m].
struct Corners {
  double onset = std::numeric_limits<double>::infinity();  ///< of densification; infinite: none
  double curve_end = 0.0;  ///< the cubics of a curve meet up to here; 0: no curve
};

Corners corners_of(const ElasticFactors& factors, double radius) {
  Corners corners{.curve_end = factors.curve.end * radius};
  if (factors.densification != 0.0) corners.onset = factors.densification_onset * radius;
  return corners;
}

/// ∫ force dx from 0 to `last`, with x = u² for the power law at its start. Pieces end at corners.
template <class Force>
double integral_to(double last, const Corners& corners, const Force& force) {
  const auto part = [&](double from, double to) {
    return Gauss::integrate([&](double u) { return 2.0 * u * force(u * u); }, std::sqrt(from),
                            std::sqrt(to));
  };
  // Halves, for other factors may have a corner of their own within a piece.
  const auto piece = [&](double from, double to) {
    const double middle = 0.5 * (from + to);
    return part(from, middle) + part(middle, to);
  };
  if (corners.curve_end <= 0.0) {
    const double onset = std::min(last, corners.onset);
    return part(0.0, onset) + (onset < last ? part(onset, last) : 0.0);
  }
  double sum = 0.0, from = 0.0;
  for (std::size_t k = 1; k < FactorCurve::points && from < last; ++k) {
    const double to = std::min(last, corners.curve_end * static_cast<double>(k) /
                                         static_cast<double>(FactorCurve::points - 1));
    sum += piece(from, to);
    from = to;
  }
  return from < last ? sum + piece(from, last) : sum;
}

/// ∫ force dη from 0 to `last` ≤ `largest` on an unloading curve: over v, η/x_max = 1 − (1 − v²)²,
/// in which both the power law at its start and the curve at its end are smooth.
template <class Force>
double unloading_integral_to(double last, double largest, const Force& force) {
  const auto part = [&](double from, double to) {
    return Gauss::integrate(
        [&](double v) {
          const double left = 1.0 - v * v;
          return 4.0 * largest * left * v * force(largest * (1.0 - left * left));
        },
        from, to);
  };
  const double end = std::sqrt(unloading_place(last / largest));
  double sum = 0.0, from = 0.0;
  for (std::size_t k = 1; k < FactorCurve::points && from < end; ++k) {
    const double point =
        std::sqrt(static_cast<double>(k) / static_cast<double>(FactorCurve::points - 1));
    const double to = std::min(end, point), middle = 0.5 * (from + to);
    sum += part(from, middle) + part(middle, to);
    from = to;
  }
  return sum;
}

bool depends_on_deflection(ElasticFactors factors) {
  factors.rate_exponent = 0.0;
  return factors != ElasticFactors{};
}

}  // namespace

ElasticForce::ElasticForce(const AnyLaw& law, const Mechanisms& mechanisms, const Setting& setting)
    : law_(law),
      factors_(mechanisms.elastic),
      memory_(mechanisms.memory),
      radius_(setting.radius),
      rate_factor_(rate_factor(mechanisms.elastic, setting.speed)),
      varying_(depends_on_deflection(mechanisms.elastic)) {
  if (factors_.exponent >= 0.0) return;
  const double x = 1e-9 * radius_;  // small enough for a power law to show its exponent
  const double exponent = std::log2(law_force(law_, 2.0 * x) / law_force(law_, x));
  if (!(exponent + factors_.exponent > 0.0))
    throw Error(ExitCode::bad_input,
                "the elastic force would not vanish at first touch: the law's exponent is " +
                    std::to_string(exponent),
                {.key = "model.effect.size",
                 .value = std::to_string(factors_.exponent),
                 .allowed = "a sum of both above 0"});
}

double ElasticForce::elastic_force(double x) const {
  const double bare = rate_factor_ * law_force(law_, x);
  if (!varying_ || x == 0.0) return bare;
  return bare * elastic_factor(factors_, std::abs(x) / radius_);
}

double ElasticForce::elastic_energy(double x) const {
  if (!varying_)
    return rate_factor_ * std::visit([x](const auto& l) { return l.elastic_energy(x); }, law_);
  return integral_to(std::abs(x), corners_of(factors_, radius_),
                     [this](double at) { return elastic_force(at); });
}

double ElasticForce::acting(const ContactPhase& phase, double x) const {
  if (phase.kind == ContactPhase::Kind::loading) return elastic_force(x);
  const double remaining = remaining_deflection(memory_, x, phase.largest);
  if (remaining < 0.0 && memory_.permanent_set > 0.0) return 0.0;
  return unloading_force(remaining, phase.largest);
}

double ElasticForce::unloading_force(double remaining, double largest) const {
  const double force = elastic_force(remaining) * hysteresis_factor(memory_, remaining, largest);
  if (memory_.curve.end == 0.0) return force;
  return force + elastic_force(largest) * unloading_share_of_force(memory_, remaining, largest);
}

double ElasticForce::stiffness(const ContactPhase& phase, double x) const {
  const double h = 1e-3 * std::abs(x);
  if (h == 0.0) return 0.0;
  const auto force = [&](double at) { return acting(phase, at); };
  return (8.0 * (force(x + h) - force(x - h)) - (force(x + 2.0 * h) - force(x - 2.0 * h))) /
         (12.0 * h);
}

double ElasticForce::unloading_integral(double remaining, double largest) const {
  const double share = 1.0 - memory_.permanent_set;  // dx = (1 − p) dη
  if (!memory_.weakens()) return share * elastic_energy(remaining);
  const auto force = [&](double at) { return unloading_force(at, largest); };
  return share * (memory_.curve.end == 0.0
                      ? integral_to(std::abs(remaining), corners_of(factors_, radius_), force)
                      : unloading_integral_to(std::abs(remaining), largest, force));
}

double ElasticForce::recoverable_energy(const ContactPhase& phase, double x) const {
  if (phase.kind == ContactPhase::Kind::loading) return unloading_integral(x, x);
  const double remaining = remaining_deflection(memory_, x, phase.largest);
  if (remaining < 0.0 && memory_.permanent_set > 0.0) return 0.0;
  return unloading_integral(remaining, phase.largest);
}

double ElasticForce::lost_energy(const ContactPhase& phase, double x) const {
  if (memory_ == UnloadingMemory{}) return 0.0;
  const double largest = phase.kind == ContactPhase::Kind::loading ? x : phase.largest;
  // Both by the same pieces, so that what quadrature misses at a corner is missed by both.
  const double brought = memory_.curve.end == 0.0
                             ? elastic_energy(largest)
                             : unloading_integral_to(std::abs(largest), largest, [this](double at) {
                                 return elastic_force(at);
                               });
  return brought - unloading_integral(largest, largest);
}

}  // namespace rebound
