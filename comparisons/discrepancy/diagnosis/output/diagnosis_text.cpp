#include "comparisons/discrepancy/diagnosis/output/diagnosis_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "comparisons/discrepancy/diagnosis/asked_fem/fem_answers.hpp"
#include "comparisons/discrepancy/diagnosis/search/limits_of_memory.hpp"
#include "comparisons/io/text.hpp"
#include "comparisons/io/toml/units.hpp"

namespace rebound {
namespace {

std::string text_of(const std::optional<double>& value) {
  return value ? fmt::format("{:.3g}", *value) : "not computed";
}

}  // namespace

std::string in_said_unit(double value, const std::string& unit) {
  struct Prefix {
    double factor;
    const char* name;
  };
  static constexpr std::array<Prefix, 4> prefixes = {
      {{1.0, ""}, {1e-3, "m"}, {1e-6, "µ"}, {1e-9, "n"}}};
  const bool takes_prefix = unit == "s" || unit == "m";
  if (unit.empty() || !takes_prefix || value == 0.0)
    return fmt::format("{:.3g}{}{}", value, unit.empty() ? "" : " ", unit);
  for (const Prefix& prefix : prefixes)
    if (std::abs(value) >= prefix.factor)
      return fmt::format("{:.3g} {}{}", value / prefix.factor, prefix.name, unit);
  return fmt::format("{:.3g} {}", value, unit);
}

std::vector<FoundNumber> numbers_of(const Diagnosis& d, const NamedEffect& effect) {
  const EffectCard& card = find_effect(effect.effect.name).card;
  std::vector<FoundNumber> numbers;
  const auto size = [&](const std::string& name, const NumberWithInterval& one) {
    numbers.push_back(
        {name, size_text(card, one.value), size_text(card, one.low), size_text(card, one.high)});
  };
  for (std::size_t ball = 0; ball < effect.size_of_balls.size(); ++ball)
    size("size, " + d.seen->balls[ball].name, effect.size_of_balls[ball]);
  if (!card.is_switch && effect.size_of_balls.empty()) size("size", effect.size);
  for (const NumberWithInterval& one : effect.parameters) {
    const std::string unit = parameter_unit(card, one.name);
    numbers.push_back({with_blanks(one.name), in_said_unit(one.value, unit),
                       in_said_unit(one.low, unit), in_said_unit(one.high, unit)});
  }
  return numbers;
}

std::string effect_sentence(const Diagnosis& d, const NamedEffect& effect) {
  const EffectCard& card = find_effect(effect.effect.name).card;
  std::string text = card.name + ". " + card.sentence;
  std::string numbers;
  for (const FoundNumber& one : numbers_of(d, effect)) {
    numbers += fmt::format("{}{} {}", numbers.empty() ? "" : ", ", one.name, one.value);
    if (one.low != one.high) numbers += fmt::format(" [{} to {}]", one.low, one.high);
  }
  if (!numbers.empty()) text += " Found: " + numbers + ".";
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text;
}

std::string size_text(const EffectCard& card, double size) {
  const std::string unit = size_unit(card);
  if (!unit.empty()) return in_said_unit(size, unit);
  const bool share = card.range.highest <= 1.0;
  return share ? fmt::format("{:.3g} %", 100 * size) : fmt::format("{:.3g}", size);
}

std::string parameter_unit(const EffectCard& card, const std::string& parameter) {
  for (const EffectParameterCard& one : card.parameters)
    if (one.name == parameter) return unit_name(one.dimension);
  return {};
}

std::string family_in_words(const Diagnosis& d) {
  if (d.family != EffectFamily::none) return fmt::format("of the family '{}'", name_of(d.family));
  std::vector<std::string> families;
  for (std::size_t k = d.selection.baseline.fit.effects.size(); k < d.best().effects.size(); ++k)
    families.emplace_back(name_of(acting_family(*d.seen, d.best(), k)));
  return fmt::format("of the families '{}'", fmt::join(families, "' and '"));
}

/// Where the best candidate holds the free form of one effect: which that is.
std::string other_laws_in_words(const Diagnosis& d) {
  std::string text;
  for (const std::string& name :
       d.candidates.empty() ? std::vector<std::string>{} : d.candidates.front())
    if (const std::string effect = effect_behind(name); effect != name)
      text += fmt::format(", {} by another law than that of the list", effect);
  return text;
}

std::string headline(const Diagnosis& d) {
  const auto sized = [&] {
    std::string text;
    for (const auto& e : d.effects) {
      const EffectCard& card = find_effect(e.effect.name).card;
      text += fmt::format("{}{}", text.empty() ? "" : ", ", card.name);
      const auto add = [&](const NumberWithInterval& size) {
        text += fmt::format(" {:.3g} [{:.3g}, {:.3g}]{}", size.value, size.low, size.high,
                            size_unit(card).empty() ? "" : " " + size_unit(card));
      };
      for (std::size_t ball = 0; ball < e.size_of_balls.size(); ++ball) {
        add(e.size_of_balls[ball]);
        text += fmt::format(" ({})", d.seen->balls[ball].name);
      }
      if (!card.is_switch && e.size_of_balls.empty()) add(e.size);
    }
    return text;
  };
  switch (d.verdict) {
    case DiagnosisVerdict::agrees:
      return d.law_alone ? fmt::format(
                               "The data follow a ball of finite size with nothing hidden in it. "
                               "The lumped law alone leaves {:.3g} standard deviations: its own "
                               "error, and no effect.",
                               std::sqrt(*d.law_alone->before))
                         : "Model and data agree within the noise.";
    case DiagnosisVerdict::missing: return "Missing from the model: " + sized() + ".";
    case DiagnosisVerdict::measurement_fault:
      return "A fault of the measurement is suspected: " + d.fault + ".";
    case DiagnosisVerdict::unexplained:
      return d.effects.empty()
                 ? fmt::format("Model and data disagree, and nothing in the list explains it{}.",
                               d.withheld.empty() ? "" : ": " + d.withheld)
                 : "Missing from the model: " + sized() +
                       "; what is left then, nothing in the list "
                       "explains.";
    case DiagnosisVerdict::insufficient_data:
      return d.effects.empty() ? std::string("Not enough data for a verdict.")
                               : "Missing from the model: " + sized() +
                                     "; what is left then, these data cannot put to a test.";
    case DiagnosisVerdict::family:
      return fmt::format("Something {} is missing{}; no name: {}.", family_in_words(d),
                         other_laws_in_words(d), d.withheld);
    case DiagnosisVerdict::one_of: {
      std::string sets;
      for (const auto& names : d.candidates) {
        std::string one;
        for (const auto& name : names) one += (one.empty() ? "" : " + ") + name;
        sets += (sets.empty() ? "" : ", ") + one;
      }
      return "One of {" + sets + "}; these data cannot tell which.";
    }
  }
  return {};
}

std::string missing_force_sentence(const Diagnosis& d) {
  if (!d.missing_force) return {};
  const MissingForce& missing = *d.missing_force;
  if (!missing.found())
    return "The missing force was not found: " + missing.not_found_because + ".";
  double largest = 0.0;
  for (const MissingForceCurve& curve : missing.curves)
    for (const double force : curve.force) largest = std::max(largest, std::abs(force));
  std::string words;
  for (const std::string& one : missing.in_words) words += (words.empty() ? "" : "; ") + one;
  std::string text =
      fmt::format("The missing force, up to {:.3g} N without a formula: {}.", largest, words);
  if (missing.unseen_after)
    text += fmt::format(" With it the gap at the unseen speed goes from {:.3g} to {:.3g}.",
                        *missing.unseen_before, *missing.unseen_after);
  return text;
}

std::string to_text(const Diagnosis& d) {
  std::string text;
  for (const DataCheck& one : d.contradictions)
    text += fmt::format(
        "data      {} of {}: {:.4g} {}where {:.4g} is expected, {:+.1f} deviations; "
        "mended by {}\n",
        one.what, one.of, one.measured, one.unit.empty() ? "" : one.unit + " ", one.expected,
        one.deviations(), one.mended_by);
  for (const DataCheck& one : d.checks)
    if (one.compared_only && !one.mended_by.empty())
      text += fmt::format("beside    {} of {}: {:.3g} ± {:.2g} of the impacts': {}\n", one.what,
                          one.of, one.measured, one.error, one.mended_by);
  text += "VERDICT   " + headline(d) + "\n";
  if (d.seen) text += fmt::format("noise     {}\n", d.seen->noise_from);
  if (d.gap.before)
    text +=
        fmt::format("gap       {} -> {} (noise 1)\n", text_of(d.gap.before), text_of(d.gap.after));
  if (d.held_out_speed)
    text += fmt::format("unseen    {:g} m/s: {} -> {}\n", *d.held_out_speed,
                        text_of(d.gap.held_out_before), text_of(d.gap.held_out_after));
  if (d.law_alone)
    text += fmt::format("law alone {}, unseen {}: without what a body of finite size adds\n",
                        text_of(d.law_alone->before), text_of(d.law_alone->held_out_before));
  for (const std::string& ball : fem_balls_in_words(d)) text += fmt::format("FE ball   {}\n", ball);
  for (const ExplainedShare& one : d.nearest)
    text += fmt::format("nearest   {} explains {:.0f} % of the gap by itself\n",
                        one.effects.front(), 100.0 * one.share);
  for (const EffectInFem& one : d.in_fem) {
    if (&one - d.in_fem.data() >= 3) break;
    text += fmt::format("in FE     {} {}, {}: {} -> {}, unseen {} -> {}\n", one.effect.name,
                        size_text(find_effect(one.effect.name).card, one.effect.size), one.fem,
                        text_of(one.gap.before), text_of(one.gap.after),
                        text_of(one.gap.held_out_before), text_of(one.gap.held_out_after));
  }
  if (d.bootstrap.draws > 0) {
    text +=
        fmt::format("repeated  chosen in {} repetitions of the measurement:", d.bootstrap.draws);
    for (const SelectionFrequency& one : d.bootstrap.chosen)
      text += fmt::format(
          "{} {} {:.0f} %", &one == d.bootstrap.chosen.data() ? "" : ",",
          one.effects.empty() ? "no effect" : fmt::format("{}", fmt::join(one.effects, " + ")),
          100.0 * one.share);
    text += "\n";
  }
  for (const auto& cell : d.where) {
    if (&cell - d.where.data() >= 5) break;
    text += fmt::format("where     {:g} m/s, {}, {}: z = {:+.1f}{}\n", d.speed_of(cell),
                        name_of(cell.phase), name_of(cell.what), cell.z,
                        d.maps_the_law_alone() ? " of the law alone" : "");
  }
  if (d.missing_force) text += fmt::format("force     {}\n", missing_force_sentence(d));
  if (!d.withheld.empty()) text += fmt::format("withheld  {}\n", d.withheld);
  for (const auto& needed : d.needed) text += fmt::format("needed    {}\n", needed);
  for (const auto& e : d.next)
    text += fmt::format("next      {}: tells {} from {} with P = {:.2f}\n", e.what, e.separates[0],
                        e.separates[1], e.probability);
  for (const auto& e : d.excluded)
    text +=
        fmt::format("excluded  {} above {}\n", e.name, size_text(find_effect(e.name).card, e.size));
  for (const auto& warning : d.warnings) text += fmt::format("warning   {}\n", warning);
  return text;
}

}  // namespace rebound
