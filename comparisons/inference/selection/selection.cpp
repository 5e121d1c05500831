#include "comparisons/inference/selection/selection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "comparisons/inference/selection/left_out.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr double not_told_apart = 6.0;  // in BIC; above is called strong evidence
constexpr double clearly_worse = 1.1;   // ratio of prediction errors

CandidateScore fitted(const Candidate& candidate, const std::vector<MeasuredImpact>& shots,
                      const LawCalibrationOptions& options, const RunControl& control) {
  CandidateScore score;
  score.label = candidate.label;
  try {
    score.fitted = calibrate(candidate.request, shots, options, control);
    score.parameters = static_cast<int>(score.fitted.fit.estimates.size());
    if (!score.fitted.fit.converged) score.failure = "its calibration did not converge";
  } catch (const Error& error) {
    if (error.code() == ExitCode::interrupted) throw;
    score.failure = error.what();
  }
  return score;
}

double effective_data(const std::vector<CandidateScore>& candidates) {
  const CandidateScore* best = nullptr;
  for (const auto& c : candidates)
    if (c.failure.empty() && (!best || c.fitted.fit.cost_after < best->fitted.fit.cost_after))
      best = &c;
  if (!best) return 0.0;
  const double rho = std::clamp(best->fitted.fit.residual_autocorrelation, 0.0, 0.999);
  return best->fitted.fit.data * (1.0 - rho) / (1.0 + rho);
}

void score_by_criteria(CandidateScore& c, double effective) {
  const double n = effective, m = c.parameters, data = c.fitted.fit.data;
  const double squares = std::max(2.0 * c.fitted.fit.cost_after, 1e-300);
  c.misfit = c.fitted.fit.noise == NoiseKnowledge::known ? squares * n / data
                                                         : n * std::log(squares / data);
  c.bic = c.misfit + m * std::log(n);
  const double rest = n - m - 1.0;
  c.aicc = rest > 0.0 ? c.misfit + 2.0 * m + 2.0 * m * (m + 1.0) / rest
                      : std::numeric_limits<double>::infinity();
}

std::vector<std::size_t> best_by_criterion(const std::vector<CandidateScore>& all) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const auto& c : all)
    if (c.failure.empty()) lowest = std::min(lowest, c.bic);
  std::vector<std::size_t> best;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i].failure.empty() && all[i].bic <= lowest + not_told_apart) best.push_back(i);
  return best;
}

bool is_clearly_worse(const CandidateScore& c, const CandidateScore& best) {
  if (!(*c.prediction_error > clearly_worse * *best.prediction_error)) return false;
  for (std::size_t k = 0; k < c.left_out.size(); ++k)
    if (!(c.left_out[k].force_rms > clearly_worse * best.left_out[k].force_rms)) return false;
  return true;
}

std::vector<std::size_t> best_by_prediction(const std::vector<CandidateScore>& all) {
  const CandidateScore* best = nullptr;
  for (const auto& c : all)
    if (c.prediction_error && (!best || *c.prediction_error < *best->prediction_error)) best = &c;
  std::vector<std::size_t> kept;
  if (!best) return kept;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i].prediction_error && !is_clearly_worse(all[i], *best)) kept.push_back(i);
  return kept;
}

std::string names(const Selection& s, const std::vector<std::size_t>& members) {
  std::string text;
  for (std::size_t i : members) text += (text.empty() ? "" : ", ") + s.candidates[i].label;
  return text;
}

void choose(Selection& s) {
  const auto &a = s.best_by_criterion, &b = s.best_by_prediction;
  if (b.empty()) {
    s.chosen = a;
  } else {
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(s.chosen));
    if (s.chosen.empty())
      std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(s.chosen));
  }
  const char* basis = b.empty()
                          ? "by information criterion alone (a left-out speed needs two speeds "
                            "and a law that can predict)"
                          : "by information criterion and left-out speeds";
  if (s.chosen.empty())
    s.verdict = "no candidate could be fitted";
  else if (s.chosen.size() == 1)
    s.verdict = fmt::format("{}, {}", names(s, s.chosen), basis);
  else
    s.verdict = fmt::format("cannot be told apart: {}; {}", names(s, s.chosen), basis);
}

}  // namespace

Selection select_law(const std::vector<Candidate>& candidates,
                     const std::vector<MeasuredImpact>& references,
                     const LawCalibrationOptions& options, const RunControl& control) {
  if (candidates.size() < 2)
    throw Error(ExitCode::bad_input, "a selection needs two candidates or more");
  if (references.empty()) throw Error(ExitCode::bad_input, "a selection needs references");
  Selection selection;
  selection.observable = options.observable;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    auto& score =
        selection.candidates.emplace_back(fitted(candidates[i], references, options, control));
    if (score.failure.empty()) predict_left_out(candidates[i], references, options, control, score);
    if (control.progress)
      control.progress(static_cast<double>(i + 1) / static_cast<double>(candidates.size()));
  }
  selection.effective_data = effective_data(selection.candidates);
  for (auto& c : selection.candidates)
    if (c.failure.empty()) score_by_criteria(c, selection.effective_data);
  selection.best_by_criterion = best_by_criterion(selection.candidates);
  selection.best_by_prediction = best_by_prediction(selection.candidates);
  choose(selection);
  return selection;
}

}  // namespace rebound
