#include "comparisons/inference/selection/selection_text.hpp"

#include <fmt/format.h>

namespace rebound {
namespace {

Json labels(const Selection& s, const std::vector<std::size_t>& members) {
  Json list = Json::array();
  for (std::size_t i : members) list.push_back(s.candidates[i].label);
  return list;
}

Json to_json(const LeftOut& out, Observable observable) {
  if (out.failure.empty() && observable == Observable::scalars)
    return {{"speed_m_s", out.speed}, {"failure", nullptr}, {"scalars_rms", out.force_rms}};
  if (!out.failure.empty()) return {{"speed_m_s", out.speed}, {"failure", out.failure}};
  return {{"speed_m_s", out.speed},
          {"failure", nullptr},
          {"force_rms", out.force_rms},
          {"restitution_error", out.restitution_error},
          {"contact_time_error", out.contact_time_error}};
}

Json to_json(const CandidateScore& c, Observable observable) {
  if (!c.failure.empty()) return {{"label", c.label}, {"failure", c.failure}};
  Json left_out = Json::array();
  for (const auto& out : c.left_out) left_out.push_back(to_json(out, observable));
  return {{"label", c.label},
          {"failure", nullptr},
          {"law", c.fitted.model.law},
          {"parameters", c.parameters},
          {"misfit", c.misfit},
          {"aicc", number_or_null(c.aicc)},
          {"bic", c.bic},
          {"residual_autocorrelation", c.fitted.fit.residual_autocorrelation},
          {"prediction_error", number_or_null(c.prediction_error)},
          {"left_out", left_out}};
}

}  // namespace

Json to_json(const Selection& selection) {
  Json candidates = Json::array();
  for (const auto& c : selection.candidates) candidates.push_back(to_json(c, selection.observable));
  return {{"schema", 1},
          {"observable", name_of(selection.observable)},
          {"candidates", candidates},
          {"effective_data", selection.effective_data},
          {"best_by_criterion", labels(selection, selection.best_by_criterion)},
          {"best_by_prediction", labels(selection, selection.best_by_prediction)},
          {"chosen", labels(selection, selection.chosen)},
          {"told_apart", selection.chosen.size() == 1},
          {"verdict", selection.verdict}};
}

std::string to_text(const Selection& selection) {
  const bool scalars = selection.observable == Observable::scalars;
  const double scale = scalars ? 1.0 : 100.0;
  const char* unit = scalars ? "sigma" : "%";
  std::string text = fmt::format("{:<28}{:>4}{:>12}{:>12}{:>16}  left-out speeds ({} rms)\n", "law",
                                 "M", "BIC", "AICc", "prediction", scalars ? "scalars," : "force");
  for (const auto& c : selection.candidates) {
    if (!c.failure.empty()) {
      text += fmt::format("{:<28}none: {}\n", c.label, c.failure);
      continue;
    }
    text += fmt::format("{:<28}{:>4}{:>12.1f}{:>12.1f}", c.label, c.parameters, c.bic, c.aicc);
    text += c.prediction_error ? fmt::format("{:>10.2f} {:<5}", scale * *c.prediction_error, unit)
                               : fmt::format("{:>16}", "-");
    for (const auto& out : c.left_out)
      text += out.failure.empty()
                  ? fmt::format("  {:.4g} m/s: {:.2f} {}", out.speed, scale * out.force_rms, unit)
                  : fmt::format("  {:g} m/s: none", out.speed);
    text += "\n";
  }
  return text + fmt::format("{:.0f} independent data\nverdict: {}\n", selection.effective_data,
                            selection.verdict);
}

}  // namespace rebound
