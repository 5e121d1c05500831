#include "comparisons/app/print_result.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>

#include "comparisons/accuracy/numerical_error/reference_impact.hpp"
#include "comparisons/app/interruption.hpp"
#include "comparisons/app/terminal.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {

namespace {

std::string text_of(const Json& value) {
  return value.is_number_float() ? fmt::format("{:.6g}", value.get<double>())
         : value.is_string()     ? value.get<std::string>()
                                 : value.dump();
}

/// A share is read in per cent; the number stays beside it for whoever reads by key.
std::string with_per_cent(const std::string& key, const Json& value) {
  std::string text = text_of(value);
  if (key.ends_with("_share") && value.is_number())
    text = fmt::format("{:<12}{:.3g} %", text, 100.0 * value.get<double>());
  return text;
}

/// Value and half width, the latter also as a share of the value.
std::string with_error(double value, double uncertainty) {
  const std::string share =
      value == 0.0 ? "" : fmt::format("  ({:.2g} %)", 100.0 * std::abs(uncertainty / value));
  return fmt::format("{:<12.6g} +- {:.2g}{}", value, uncertainty, share);
}

/// Whether error bars make the result a reference, in a sentence.
std::string reference_sentence(const Json& reference) {
  const auto beyond = reference["beyond"].get<std::vector<std::string>>();
  return (beyond.empty() ? "yes: " : "no: ") + words_of_reference(beyond);
}

}  // namespace

void print_result(const Session& session, const Json& result) {
  if (session.json()) {
    fmt::print("{}", dump(result));
    return;
  }
  std::string lines;
  // Of a result with error bars the shares of the bars and the runs behind them are in
  // the JSON alone.
  const Json uncertainty = result.value("uncertainty", Json::object());
  for (const auto& [key, value] : result.items()) {
    if (key == "schema" || key == "uncertainty" || key == "uncertainty_basis") continue;
    std::string text = with_per_cent(key, value);
    if (key == "reference") text = reference_sentence(value);
    if (key == "family") text = fmt::format("{} runs", value.size());
    if (uncertainty.contains(key))
      text = with_error(value.get<double>(), uncertainty[key].get<double>());
    lines += fmt::format("{:<28}{}\n", key, text);
  }
  print_text(lines);
}

std::vector<EffectChoice> without_measurement(const std::vector<EffectChoice>& effects) {
  for (const EffectChoice& effect : effects)
    if (is_measurement(effect.name))
      fmt::print(stderr,
                 "rebound: {} is a fault of the measurement and does not act on the impact; "
                 "'rebound synthesize' applies it\n",
                 effect.name);
  return physical_effects(effects);
}

void require_complete(const Session& session, const std::string& file,
                      const std::string& incomplete_because) {
  if (incomplete_because.empty()) return;
  const std::string kept =
      session.out.empty() ? "" : fmt::format("; what is known is in {}", session.out.string());
  throw Error(interrupted() ? ExitCode::interrupted : ExitCode::solver_failed,
              incomplete_because + kept, {.file = file});
}

}  // namespace rebound
