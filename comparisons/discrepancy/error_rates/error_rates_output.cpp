#include "comparisons/discrepancy/error_rates/error_rates_output.hpp"

#include <fmt/format.h>

#include <utility>

#include "comparisons/discrepancy/diagnosis/output/diagnosis_json.hpp"
#include "comparisons/discrepancy/error_rates/error_rates.hpp"
#include "comparisons/discrepancy/trials/trial_text.hpp"

namespace rebound {
namespace {

/// Nothing where no trial is like it: the believed model of a trial is a lumped law.
std::vector<ErrorRates> rates_of(const Diagnosis& d) {
  const bool fem_believed = d.numerical_uncertainty.has_value();
  if (d.verdict == DiagnosisVerdict::insufficient_data || fem_believed) return {};
  return error_rates_of(d.design, std::string(name_of(d.verdict)));
}

std::string bodies_of(const ErrorRates& rates) {
  return rates.in_fem ? "balls in finite elements" : "balls that obey a law";
}

/// "65 with 1 % of noise and 4 to 7 speeds".
std::string design_of(const ErrorRates& rates) {
  std::string text = std::to_string(rates.trials);
  if (rates.noise_share > 0.0)
    text += fmt::format(" with {:.3g} % of noise and", 100.0 * rates.noise_share);
  else
    text += " with";
  return text + (rates.fewest_speeds == rates.most_speeds
                     ? fmt::format(" {} speeds", rates.most_speeds)
                     : fmt::format(" {} to {} speeds", rates.fewest_speeds, rates.most_speeds));
}

std::string verdict_sentence(const Diagnosis& d, const ErrorRates& rates) {
  return fmt::format("\"{}\" said and true", name_of(d.verdict)) + ": " +
         share_text(rates.verdict_true);
}

}  // namespace

Json json_with_error_rates(const Diagnosis& d) {
  Json json = to_json(d);
  Json& list = json["error_rates"] = Json::array();
  for (const ErrorRates& one : rates_of(d))
    list.push_back({{"balls", one.in_fem ? "fem" : "law"},
                    {"trials", one.trials},
                    {"noise_share", one.noise_share > 0.0 ? Json(one.noise_share) : Json(nullptr)},
                    {"speeds", {one.fewest_speeds, one.most_speeds}},
                    {"false_alarm", share_json(one.false_alarm)},
                    {"effect_seen", share_json(one.effect_seen)},
                    {"verdict_true", share_json(one.verdict_true)},
                    {"true_means", one.true_means}});
  return json;
}

std::string error_rates_text(const Diagnosis& d) {
  std::string text;
  for (const ErrorRates& one : rates_of(d))
    text += fmt::format("trials    {}, {}: {}; a gap where nothing is hidden: {}\n", bodies_of(one),
                        design_of(one), verdict_sentence(d, one), share_text(one.false_alarm));
  return text;
}

MeasuredErrorRates error_rates_on_page(const Diagnosis& d) {
  const std::vector<ErrorRates> rates = rates_of(d);
  if (rates.empty()) {
    if (!d.gap.before) return {};
    return {.sentence = {},
            .blocks = {report::Paragraph{
                "How often such a verdict is right was not measured: in "
                "blind trials a lumped law is believed, and force was recorded."}}};
  }
  std::string sentence = "In blind trials of such experiments";
  for (const ErrorRates& one : rates)
    sentence +=
        fmt::format("{} with {} {}", &one == rates.data() ? "" : ", and", bodies_of(one),
                    one.verdict_true.of == 0
                        ? fmt::format("no verdict was '{}'", name_of(d.verdict))
                        : fmt::format("a verdict '{}' was true in {} of {}", name_of(d.verdict),
                                      one.verdict_true.count, one.verdict_true.of));
  sentence += ".";
  report::Table table{
      .title = "How often such a verdict is right",
      .caption = fmt::format(
          "Blind trials of experiments like this one, which has {:.2g} % of noise over its "
          "smallest peak force and {} speeds. A verdict '{}' is true where {}. In brackets: 95 % "
          "interval.",
          100.0 * d.design.noise_share, d.design.speeds, name_of(d.verdict),
          rates.front().true_means),
      .columns = {{"balls"},
                  {"trials"},
                  {fmt::format("'{}' said and true", name_of(d.verdict))},
                  {"a gap said, nothing hidden"},
                  {"a gap said, an effect shows"}},
      .rows = {}};
  for (const ErrorRates& one : rates)
    table.rows.push_back({report::text_cell(bodies_of(one)), report::text_cell(design_of(one)),
                          report::text_cell(share_text(one.verdict_true)),
                          report::text_cell(share_text(one.false_alarm)),
                          report::text_cell(share_text(one.effect_seen))});
  return {.sentence = std::move(sentence), .blocks = {std::move(table)}};
}

}  // namespace rebound
