#include "comparisons/discrepancy/diagnosis/asked_fem/fem_answers.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "comparisons/discrepancy/diagnosis/asked_fem/model_discrepancy.hpp"
#include "comparisons/discrepancy/diagnosis/output/diagnosis_text.hpp"
#include "fem/interface/elastic_models.hpp"

namespace rebound {
namespace {

using report::text_cell;
using Kind = report::TableColumn::Kind;
using Verdict = report::TableCell::Verdict;

constexpr std::size_t most_rows = 4;

std::string deviations(const std::optional<double>& reduced_chi_square) {
  if (!reduced_chi_square) return "–";
  constexpr double many = 100.0;
  const double root = std::sqrt(*reduced_chi_square);
  return root < many ? fmt::format("{:.2f}", root) : fmt::format("{:.0f}", root);
}

std::string before_and_after(const EffectInFem& one) {
  return fmt::format("{} standard deviations without it and {} with it", deviations(one.gap.before),
                     deviations(one.gap.after));
}

std::string sentence_of_a_name(const EffectInFem& one) {
  const std::string& name = one.effect.name;
  if (one.fem == "supported")
    return fmt::format("FE was asked of {} and supports it: it leaves {}.", name,
                       before_and_after(one));
  if (one.fem == "rejected")
    return fmt::format("FE was asked of {} and rejects it, so that the tiers differ: it leaves {}.",
                       name, before_and_after(one));
  return fmt::format("FE was asked of {} and cannot say: it leaves {}, more than its errors do.",
                     name, before_and_after(one));
}

/// Where names did not stand by themselves, or there were none.
std::string sentence_of_the_search(const Diagnosis& d) {
  std::string text = fmt::format(
      "FE was asked of effects: with nothing hidden it leaves {} standard deviations, where the "
      "lumped model leaves {}",
      deviations(d.fem_with_nothing_hidden->before),
      deviations(d.selection.baseline.fit.reduced_chi_square()));
  if (d.verdict == DiagnosisVerdict::agrees)
    return text + ". The tiers differ: the gap is what a lumped model leaves of a sound ball.";
  if (d.in_fem.empty()) return text + ". No effect of FE came nearer.";
  const EffectInFem& best = d.in_fem.front();
  if (best.fem != "supported")
    return text + fmt::format(
                      "; no effect that was tried in FE explains them, {} comes nearest "
                      "with {}.",
                      best.effect.name, deviations(best.gap.after));
  text += fmt::format("; with {} FE leaves {}.", best.effect.name, deviations(best.gap.after));
  if (best.lumped == "supported") return text + " The lumped law needs more beside it.";
  return text + (best.lumped == "no-form"
                     ? " That effect has no lumped form."
                     : " The tiers differ: beside the lumped law it does not do that.");
}

Verdict verdict_of(const std::string& together) {
  if (together == "agree") return Verdict::good;
  return together == "differ" ? Verdict::bad : Verdict::doubtful;
}

}  // namespace

std::string fem_sentence(const Diagnosis& d) {
  if (!d.fem_alone) return {};
  if (d.fem_with_nothing_hidden) return sentence_of_the_search(d);
  std::string text;
  for (const EffectInFem& one : d.in_fem)
    text += (text.empty() ? "" : " ") + sentence_of_a_name(one);
  if (!text.empty()) return text;
  return d.model_discrepancy
             ? "FE was asked what a body of finite size does by itself; that stands in the model, "
               "and FE was asked of no effect."
             : "FE was asked what a body of finite size does by itself; that does not explain the "
               "data as well, and FE was asked of no effect.";
}

std::string fem_ball_in_words(const FittedFem& ball) {
  const Material& material = ball.material;
  std::string text = fmt::format("{}, E {:.3g} MPa, ν {:.3g}", name_of(material.elastic),
                                 1e-6 * material.youngs_modulus, material.poisson_ratio);
  for (const PronyBranch& branch : material.branches)
    text += fmt::format(", branch{} {:.3g} in {}",
                        branch.relaxes == Relaxes::deviator ? " of the deviator" : "", branch.ratio,
                        in_said_unit(branch.relaxation_time, "s"));
  for (const EffectChoice& effect : ball.effects)
    text +=
        fmt::format(", {} {}", effect.name, size_text(find_effect(effect.name).card, effect.size));
  return text;
}

std::vector<std::string> fem_balls_in_words(const Diagnosis& d) {
  std::vector<std::string> sentences;
  if (!d.fem_alone) return sentences;
  const std::vector<FittedFem>& balls = d.fem_alone->balls;
  for (std::size_t ball = 0; ball < balls.size(); ++ball)
    if (balls[ball].samples > 0)
      sentences.push_back((balls.size() > 1 ? d.seen->balls[ball].name + ": " : "") +
                          fem_ball_in_words(balls[ball]));
  return sentences;
}

std::string tiers_together(const EffectInFem& one) {
  if (one.fem == "no-fit") return "FE cannot say";
  if (one.lumped == "no-form") return one.fem == "supported" ? "FE alone" : "agree";
  return one.lumped == one.fem ? "agree" : "differ";
}

report::Table tiers_table(const Diagnosis& d) {
  report::Table table{
      .title = "What each tier says",
      .caption =
          "What each tier leaves over without the effect → with it, all else fitted: root mean "
          "square residuals in standard deviations of the data, the roots of the gaps; noise alone "
          "leaves 1. no-form: that tier has no such effect; no-fit: FE follows the data neither "
          "way.",
      // Verdicts first: a narrow screen shows no more.
      .columns = {{"effect", "", Kind::text, {}},
                  {"the tiers", "", Kind::text, {}},
                  {"lumped", "", Kind::text, {}},
                  {"FE", "", Kind::text, {}},
                  {"lumped leaves", "σ", Kind::number, report::Origin::derived},
                  {"FE leaves", "σ", Kind::number, report::Origin::derived},
                  {"FE, unseen speed", "σ", Kind::number, report::Origin::predicted},
                  {"size in FE", "as named", Kind::number, report::Origin::fitted}},
      .rows = {}};
  const auto pair = [](const std::optional<double>& before, const std::optional<double>& after) {
    return text_cell(deviations(before) + " → " + deviations(after));
  };
  for (const EffectInFem& one : d.in_fem) {
    if (table.rows.size() == most_rows) break;
    const std::string together = tiers_together(one);
    table.rows.push_back(
        {text_cell(one.effect.name), text_cell(together, verdict_of(together)),
         text_cell(one.lumped), text_cell(one.fem), pair(one.lumped_before, one.lumped_after),
         pair(one.gap.before, one.gap.after), pair(one.gap.held_out_before, one.gap.held_out_after),
         text_cell(size_text(find_effect(one.effect.name).card, one.effect.size))});
  }
  if (d.in_fem.size() > most_rows)
    table.caption += fmt::format(" The best {} of {} that were tried.", most_rows, d.in_fem.size());
  return table;
}

}  // namespace rebound
