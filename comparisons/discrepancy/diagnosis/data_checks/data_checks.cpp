#include "comparisons/discrepancy/diagnosis/data_checks/data_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparisons/discrepancy/diagnosis/data_checks/checked_shots.hpp"
#include "comparisons/discrepancy/diagnosis/data_checks/repeat_checks.hpp"
#include "comparisons/discrepancy/diagnosis/data_checks/scalar_checks.hpp"
#include "comparisons/inference/calibration/distributions.hpp"

namespace rebound {
namespace {

double share_of(double error, double value) {
  return error / std::abs(value);
}

/// A ratio that should be one, as a check.
DataCheck ratio_check(const std::string& what, const std::string& of, const Ratio& ratio) {
  return {.what = what,
          .of = of,
          .unit = {},
          .measured = ratio.value,
          .expected = 1.0,
          .error = ratio.error};
}

/// Speed and mass of a shot, the first alone its own.
double own_speed_share(const MeasuredImpact& shot) {
  return share_of(shot.speed_uncertainty.value_or(0.0), shot.impact.speed);
}

double mass_share(const Observations& seen, const MeasuredImpact& shot) {
  const Ball& ball = seen.balls[shot.ball];
  return share_of(ball.mass_uncertainty, ball.sphere.mass);
}

/// ∫ F dt over m v (1 + e); the error is the shot's own, without gain and mass.
Ratio impulse_ratio(const CheckedShot& one) {
  const MeasuredImpact& shot = *one.shot;
  const RecordReading& impulse = one.reading(RecordNumber::impulse);
  const double restitution = *shot.restitution.value;
  const double value = impulse.value / (shot.sphere.mass * shot.impact.speed * (1.0 + restitution));
  const double share =
      std::hypot(share_of(std::hypot(impulse.error(), gravity_impulse(one)), impulse.value),
                 own_speed_share(shot), share_of(*shot.restitution.uncertainty, 1.0 + restitution));
  return {value, share * value};
}

bool has_impulse_balance(const CheckedShot& one) {
  return one.reading(RecordNumber::impulse).is_known() && one.shot->restitution.has_error();
}

std::vector<DataCheck> impulse_checks(const Observations& seen,
                                      const std::vector<CheckedShot>& all) {
  std::vector<DataCheck> checks;
  for (std::size_t ball = 0; ball < seen.balls.size(); ++ball) {
    std::vector<const CheckedShot*> shots;
    std::vector<Ratio> ratios;
    for (const CheckedShot& one : all)
      if (one.shot->ball == ball && has_impulse_balance(one)) {
        shots.push_back(&one);
        ratios.push_back(impulse_ratio(one));
      }
    if (ratios.empty()) continue;
    const OddOnes odd = set_odd_ones_apart(ratios);
    const double mass = mass_share(seen, *shots.front()->shot);
    const double common = std::hypot(seen.gain_uncertainty, mass) * odd.mean.value;
    Ratio mean = odd.mean;
    mean.error = std::hypot(mean.error, common);
    DataCheck check = ratio_check(
        "impulse", fmt::format("{} shots of {}", ratios.size(), seen.balls[ball].name), mean);
    check.mended_by = fmt::format(
        "a force gain of {:.4g} ± {:.2g}, or a mass or all speeds of {:.4g} ± {:.2g} times what is "
        "stated",
        mean.value, odd.mean.error, mean.value, odd.mean.error);
    checks.push_back(check);
    for (std::size_t i = 0; ratios.size() > 1 && i < ratios.size(); ++i) {
      const MeasuredImpact& shot = *shots[i]->shot;
      const double e = *shot.restitution.value;
      const Ratio rest = odd.mean_of_others[i];
      const double share = ratios[i].value / rest.value;
      const double error = share * std::hypot(share_of(ratios[i].error, ratios[i].value),
                                              share_of(rest.error, rest.value));
      checks.push_back({.what = "restitution",
                        .of = shot.label,
                        .unit = {},
                        .measured = e,
                        .expected = share * (1.0 + e) - 1.0,
                        .error = error * (1.0 + e),
                        .mended_by = fmt::format("in this shot alone a gain of {:.4g} ± {:.2g}, "
                                                 "another speed, or a restitution of {:.3g}",
                                                 share, error, share * (1.0 + e) - 1.0)});
    }
  }
  return checks;
}

/// 0 within the range, else how far outside: what lies inside contradicts nothing.
DataCheck range_check(const std::string& of, double restitution, double error) {
  return {.what = "restitution-range",
          .of = of,
          .unit = {},
          .measured = restitution,
          .expected = std::clamp(restitution, 0.0, 1.0),
          .error = error,
          .mended_by = restitution > 1.0   ? "less gain, a heavier ball or a faster approach"
                       : restitution < 0.0 ? "more gain, a lighter ball or a slower approach"
                                           : ""};
}

std::vector<DataCheck> range_checks(const Observations& seen, const std::vector<CheckedShot>& all) {
  std::vector<DataCheck> checks;
  for (const CheckedShot& one : all) {
    const MeasuredImpact& shot = *one.shot;
    if (shot.restitution.is_stated())
      checks.push_back(range_check(shot.label + ", as stated", *shot.restitution.value,
                                   *shot.restitution.uncertainty));
    const RecordReading& impulse = one.reading(RecordNumber::impulse);
    if (!impulse.is_known()) continue;
    const double ratio = impulse.value / (shot.sphere.mass * shot.impact.speed);
    const double share = std::hypot(
        std::hypot(share_of(std::hypot(impulse.error(), gravity_impulse(one)), impulse.value),
                   own_speed_share(shot)),
        seen.gain_uncertainty, mass_share(seen, shot));
    checks.push_back(range_check(shot.label + ", from the impulse", ratio - 1.0, share * ratio));
  }
  return checks;
}

/// Checks that need a deflection of its own.
std::vector<DataCheck> deflection_checks(const Observations& seen,
                                         const std::vector<CheckedShot>& all) {
  std::vector<DataCheck> checks;
  for (const CheckedShot& one : all) {
    const MeasuredImpact& shot = *one.shot;
    const RecordReading& scale = one.reading(RecordNumber::force_over_inertia);
    const RecordReading& speed = one.reading(RecordNumber::approach_speed);
    const RecordReading& work = one.reading(RecordNumber::work);
    const double gauge = seen.deflection_gain_uncertainty;
    const double gain = seen.gain_uncertainty, mass = mass_share(seen, shot);
    if (scale.is_known()) {
      // s is (true force over force) times (deflection over true deflection).
      const double error = std::hypot(scale.error(), scale.value * std::hypot(gain, mass, gauge));
      DataCheck check = ratio_check("force-over-inertia", shot.label, {scale.value, error});
      check.mended_by = fmt::format(
          "a force gain of {:.4g} ± {:.2g}, a mass of {:.4g} or a deflection scale of "
          "{:.4g} times what is stated",
          1.0 / scale.value, scale.error() / (scale.value * scale.value), 1.0 / scale.value,
          scale.value);
      checks.push_back(check);
      const double ratio = speed.value / shot.impact.speed;
      DataCheck approach =
          ratio_check("approach-speed", shot.label,
                      {ratio, std::hypot(speed.error() / shot.impact.speed,
                                         ratio * std::hypot(own_speed_share(shot), gauge))});
      approach.mended_by =
          fmt::format("a speed or a deflection scale of {:.4g} times what is stated", ratio);
      checks.push_back(approach);
    }
    if (!work.is_known() || !shot.restitution.is_stated()) continue;
    const double e = *shot.restitution.value;
    const double lost = 0.5 * shot.sphere.mass * std::pow(shot.impact.speed, 2) * (1.0 - e * e);
    const double own = std::hypot(work.error(), work.value * std::hypot(gain, gauge));
    const double of_lost =
        std::hypot(lost * std::hypot(mass, 2.0 * own_speed_share(shot)),
                   lost * 2.0 * e * *shot.restitution.uncertainty / (1.0 - e * e));
    checks.push_back({.what = "energy",
                      .of = shot.label,
                      .unit = "J",
                      .measured = work.value,
                      .expected = lost,
                      .error = std::hypot(own, of_lost),
                      .mended_by = fmt::format("a force gain or a deflection scale of {:.4g}, or a "
                                               "deflection that comes late or early",
                                               work.value / lost)});
  }
  return checks;
}

}  // namespace

std::vector<DataCheck> check_data(const Observations& seen) {
  const std::vector<CheckedShot> shots = checked_shots(seen);
  std::vector<DataCheck> checks;
  for (const auto& found :
       {impulse_checks(seen, shots), range_checks(seen, shots), deflection_checks(seen, shots),
        scalar_checks(seen, shots), repeat_checks(shots)})
    checks.insert(checks.end(), found.begin(), found.end());
  return checks;
}

double contradiction_limit(std::size_t checks) {
  constexpr double plain = 4.0, by_noise = 0.005;
  const auto count = static_cast<double>(std::max<std::size_t>(1, checks));
  return std::max(plain, normal_quantile(1.0 - 0.5 * by_noise / count));
}

std::vector<DataCheck> contradictions_among(const std::vector<DataCheck>& checks) {
  const double limit = contradiction_limit(checks.size());
  std::vector<DataCheck> found;
  for (const DataCheck& check : checks)
    if (!check.compared_only && std::abs(check.deviations()) > limit) found.push_back(check);
  std::stable_sort(found.begin(), found.end(), [](const DataCheck& a, const DataCheck& b) {
    return std::abs(a.deviations()) > std::abs(b.deviations());
  });
  return found;
}

}  // namespace rebound
