#include "comparisons/discrepancy/diagnosis/search/effect_sensitivities.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "comparisons/discrepancy/diagnosis/search/noise_statistics.hpp"
#include "comparisons/models/parallel/in_parallel.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr double invisible = 1e-3;       // |d| per prior scale: a thousandth of σ in all the data
constexpr double fully_absorbed = 1e-6;  // share of |∂r/∂s|² left over: the fit's own unknown

/// One score a name: that of the parameters at which it gains most.
void keep_best(std::vector<EffectScore>& scores, const EffectScore& score) {
  const auto known = std::find_if(scores.begin(), scores.end(),
                                  [&](const EffectScore& s) { return s.name == score.name; });
  if (known == scores.end())
    scores.push_back(score);
  else if (score.gain_chi_square > known->gain_chi_square)
    *known = score;
}

/// What follows an effect that is added: nothing, or the starts of records, which slopes do not
/// tell where its force jumps at first touch.
enum class Following { nothing, starts };

/// Residuals of the fitted model with one more effect, nothing refitted; empty
/// where the effect has no form for this model, or the impact no answer.
std::optional<Eigen::VectorXd> residuals_with(const HypothesisFit& fit, const EffectChoice& added,
                                              Following following = Following::nothing) {
  Hypothesis with = fit.hypothesis;
  with.effects = fit.effects;
  with.effects.push_back(added);
  try {
    const JointModel model(*fit.model, fit.values, with);
    // Unknowns of the added effect stand as given, all others as fitted.
    std::vector<double> values = values_from(fit, model);
    if (following == Following::starts) values = model.with_settled_starts(std::move(values));
    const std::vector<double> residuals = model.residuals(values);
    return Eigen::Map<const Eigen::VectorXd>(residuals.data(),
                                             static_cast<Eigen::Index>(residuals.size()));
  } catch (const Error& error) {
    if (error.code() != ExitCode::bad_input && error.code() != ExitCode::solver_failed) throw;
    return std::nullopt;
  }
}

/// The Jacobian of the fit by what it may still move: an unknown that the data hold at its bound
/// takes nothing out of what is missing.
Eigen::MatrixXd free_columns(const HypothesisFit& fit) {
  Eigen::MatrixXd columns = jacobian_at(*fit.model, fit.values);
  const auto& estimates = fit.search.estimates;
  for (std::size_t i = 0; i < estimates.size(); ++i)
    if (estimates[i].identifiability == Identifiability::at_bound)
      columns.col(static_cast<Eigen::Index>(i)).setZero();
  return columns;
}

}  // namespace

EffectSensitivities::EffectSensitivities(const Observations& seen, HypothesisFit fit,
                                         std::vector<std::string> effects, GridDetail detail)
    : seen_(seen), fit_(std::move(fit)), effects_(std::move(effects)), of_starts_(detail) {
  const auto rows = static_cast<Eigen::Index>(fit_.residuals.size());
  if (!fit_.values.empty()) {
    jacobian_ = free_columns(fit_);
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(jacobian_);
    basis_ = qr.householderQ() * Eigen::MatrixXd::Identity(rows, qr.rank());
  } else {
    basis_.resize(rows, 0);
  }
  chi_square_left_ = left_of(Eigen::Map<const Eigen::VectorXd>(fit_.residuals.data(), rows));
  if (fit_.model->fem()) detail = GridDetail::coarse;  // every frequency is an impact of each shot
  const std::vector<EffectChoice> choices =
      of_all(effects_, [&](const EffectCard& card) { return small_effects(card, seen_, detail); });
  const auto moved = moved_residuals(choices);
  for (std::size_t i = 0; i < choices.size(); ++i)
    if (moved[i]) add_sensitivity(choices[i], *moved[i]);
}

std::vector<std::optional<Eigen::VectorXd>> EffectSensitivities::moved_residuals(
    const std::vector<EffectChoice>& choices) const {
  run_impacts();
  std::vector<std::optional<Eigen::VectorXd>> moved(choices.size());
  in_parallel(choices.size(), [&](std::size_t i) { moved[i] = residuals_with(fit_, choices[i]); });
  return moved;
}

void EffectSensitivities::run_impacts() const {
  for (std::size_t shot = 0; shot < seen_.shots.size(); ++shot)
    fit_.model->impact(fit_.values, shot);
}

std::vector<EffectChoice> EffectSensitivities::over_its_parameters(const EffectCard& card) const {
  return over_parameters(card, {.name = card.name, .size = card.null, .parameters = {}}, seen_);
}

std::optional<double> EffectSensitivities::rise(const EffectChoice& effect) const {
  const bool jumps = find_effect(effect.name).card.jumps_at_touch;
  const auto moved = residuals_with(fit_, effect, jumps ? Following::starts : Following::nothing);
  if (!moved) return std::nullopt;
  return left_of(*moved) - chi_square_left_;
}

void EffectSensitivities::add_sensitivity(const EffectChoice& small, const Eigen::VectorXd& moved) {
  const EffectCard& card = find_effect(small.name).card;
  const Eigen::Map<const Eigen::VectorXd> r(fit_.residuals.data(), moved.size());
  const double reach = std::isfinite(card.null) ? small.size - card.null : small.size;
  const Eigen::VectorXd change = (moved - r) / reach;
  EffectSensitivity sensitivity{.effect = small, .sensitivity = project(change)};
  const double whole = change.squaredNorm(), left = sensitivity.sensitivity.squaredNorm();
  if (!(std::sqrt(left) * card.prior_scale > invisible) || !(left > fully_absorbed * whole)) return;
  sensitivity.absorbed = 1.0 - left / whole;
  sensitivity.noise_freedom = noise_freedom_at(seen_, frequency_of(sensitivity.sensitivity));
  sensitivities_.push_back(std::move(sensitivity));
}

double EffectSensitivities::left_of(const Eigen::VectorXd& rows) const {
  return rows.squaredNorm() - (basis_.transpose() * rows).squaredNorm();
}

Eigen::VectorXd EffectSensitivities::project(const Eigen::VectorXd& column) const {
  return column - basis_ * (basis_.transpose() * column);
}

EffectScore EffectSensitivities::score_of(const EffectSensitivity& d) const {
  const Eigen::Map<const Eigen::VectorXd> r(fit_.residuals.data(),
                                            static_cast<Eigen::Index>(fit_.residuals.size()));
  const EffectCard& card = find_effect(d.effect.name).card;
  const double square = d.sensitivity.squaredNorm();
  EffectScore score{
      .name = d.effect.name, .size = -d.sensitivity.dot(r) / square, .size_error = d.size_error()};
  if (card.is_switch) {
    // It is there or not: what it gains is that of its one size, whatever size would fit best.
    score.size = 1.0;
    score.gain_chi_square = std::max(0.0, -2.0 * d.sensitivity.dot(r) - square);
  } else {
    const double sign = card.null <= card.range.lowest    ? 1.0
                        : card.null >= card.range.highest ? -1.0
                                                          : 0.0;
    const bool wrong_side = sign * score.size < 0.0 && std::isfinite(card.null);
    score.gain_chi_square = wrong_side ? 0.0 : score.size * score.size * square;
  }
  score.gain_of_known_noise = square_of_known_noise(score.gain_chi_square, d.noise_freedom);
  return score;
}

std::vector<EffectScore> EffectSensitivities::scores() const {
  std::vector<EffectScore> scores;
  for (const EffectSensitivity& d : sensitivities_) keep_best(scores, score_of(d));
  return scores;
}

double EffectSensitivities::threshold(double level, std::uint64_t seed) const {
  const auto count = static_cast<Eigen::Index>(sensitivities_.size());
  if (count == 0) return 0.0;
  Eigen::MatrixXd units(sensitivities_.front().sensitivity.size(), count);
  for (Eigen::Index j = 0; j < count; ++j)
    units.col(j) = sensitivities_[static_cast<std::size_t>(j)].sensitivity.normalized();
  const double largest = quantile_of_largest(units, level, seed);
  return largest * largest;
}

EffectSensitivities::Cosines EffectSensitivities::cosines() const {
  std::vector<const EffectSensitivity*> chosen;
  for (const EffectSensitivity& d : sensitivities_) {
    const auto known = std::find_if(chosen.begin(), chosen.end(), [&](const EffectSensitivity* c) {
      return c->effect.name == d.effect.name;
    });
    if (known == chosen.end())
      chosen.push_back(&d);
    else if (d.absorbed < (*known)->absorbed)
      *known = &d;
  }
  Cosines result;
  const auto count = static_cast<Eigen::Index>(chosen.size());
  result.cosine = Eigen::MatrixXd::Identity(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    result.names.push_back(chosen[static_cast<std::size_t>(i)]->effect.name);
    for (Eigen::Index j = 0; j < i; ++j)
      result.cosine(i, j) = result.cosine(j, i) =
          chosen[static_cast<std::size_t>(i)]->sensitivity.normalized().dot(
              chosen[static_cast<std::size_t>(j)]->sensitivity.normalized());
  }
  return result;
}

}  // namespace rebound
