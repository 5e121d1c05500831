#include "comparisons/discrepancy/trials/trial_text.hpp"

#include <fmt/format.h>

#include <set>

#include "comparisons/discrepancy/trials/trial_controls.hpp"

namespace rebound {
namespace {

Json shares_json(const std::map<std::string, Share>& shares) {
  Json json = Json::object();
  for (const auto& [name, share] : shares) json[name] = share_json(share);
  return json;
}

Json met_json(GateAnswer answer) {
  if (answer == GateAnswer::met) return true;
  return answer == GateAnswer::missed ? Json(false) : Json(nullptr);
}

Json gates_json(const std::vector<TrialGate>& gates) {
  Json json = Json::array();
  for (const TrialGate& gate : gates) {
    Json one = share_json(gate.share);
    one["what"] = gate.what;
    one["asked"] = asked_text(gate);
    one["met"] = met_json(gate.answer());
    json.push_back(std::move(one));
  }
  return json;
}

Json rates_json(const std::vector<RateTable>& tables) {
  Json json = Json::object();
  for (const RateTable& table : tables) {
    Json rows = Json::array();
    for (const RateRow& row : table.rows) {
      Json one = {{"label", row.label}};
      if (!table.unit.empty()) one["range"] = {row.low, row.high};
      one["effects"] = row.trials;
      one["detected"] = share_json(row.detected);
      one["family_right"] = share_json(row.family_right);
      one["family_at_best"] = number_or_null(row.family_at_best);
      one["name_right"] = share_json(row.name_right);
      one["wrong_name"] = share_json(row.wrong_name);
      one["false_alarm"] = share_json(row.false_alarm);
      rows.push_back(std::move(one));
    }
    json[table.by] = {{"what", table.what}, {"unit", table.unit}, {"rows", rows}};
  }
  return json;
}

const char* met_text(GateAnswer answer) {
  switch (answer) {
    case GateAnswer::not_asked: return "";
    case GateAnswer::no_trial: return "  no such trial";
    case GateAnswer::too_few: return "  too few trials";
    case GateAnswer::met: return "  met";
    case GateAnswer::missed: return "  NOT MET";
  }
  return "";
}

std::string gate_lines(const TrialScores& scores) {
  std::string text;
  for (const TrialGate& gate : scores.gates)
    text += fmt::format("{:<52}{:<36}{}{}\n", gate.what, share_text(gate.share), asked_text(gate),
                        met_text(gate.answer()));
  return text;
}

std::string short_share(const Share& share) {
  return share.of == 0 ? "none" : fmt::format("{} of {}", share.count, share.of);
}

std::string control_lines(const TrialScores& scores) {
  std::string text = fmt::format("\n{:<52}{:<14}", "on the same trials", "diagnosis");
  for (const ControlName& control : control_names) text += fmt::format("{:<28}", control.words);
  text += "\n";
  for (std::size_t i = 0; i < scores.gates.size(); ++i) {
    text += fmt::format("{:<52}{:<14}", scores.gates[i].what, short_share(scores.gates[i].share));
    for (const ControlName& control : control_names)
      text += fmt::format("{:<28}", short_share(scores.controls.at(control.key)[i].share));
    text += "\n";
  }
  return text;
}

std::string confusion_lines(const std::string& heading, const ConfusionMatrix& confusion) {
  std::string text = "\n" + heading + "\n";
  for (const auto& [row, cells] : confusion) {
    text += fmt::format("  {:<26}", row);
    for (const auto& [column, count] : cells) text += fmt::format("{} {}  ", column, count);
    text += "\n";
  }
  return text;
}

std::string percent_text(const std::optional<double>& share) {
  return share ? fmt::format("{:.0f} %", 100.0 * *share) : "-";
}

std::string rate_lines(const RateTable& table) {
  std::string text =
      fmt::format("\n  {:<22}{:<16}{:<16}{:<10}{:<16}{:<16}{}\n", "", "gap said", "family right",
                  "at best", "name or set", "wrong name", "false alarms");
  for (const RateRow& row : table.rows)
    text += fmt::format("  {:<22}{:<16}{:<16}{:<10}{:<16}{:<16}{}\n", row.label,
                        short_share(row.detected), short_share(row.family_right),
                        percent_text(row.family_at_best), short_share(row.name_right),
                        short_share(row.wrong_name), short_share(row.false_alarm));
  return fmt::format("\nby {}{}", table.what,
                     table.unit.empty() || table.unit == "1" ? "" : " in " + table.unit) +
         text;
}

}  // namespace

Json share_json(const Share& share) {
  return {{"count", share.count},
          {"of", share.of},
          {"share", share.of == 0 ? Json(nullptr) : Json(share.value())},
          {"interval", {share.low(), share.high()}}};
}

std::string share_text(const Share& share) {
  if (share.of == 0) return "none";
  return fmt::format("{} of {} = {:.1f} % [{:.1f}, {:.1f}]", share.count, share.of, share.percent(),
                     share.percent_low(), share.percent_high());
}

std::string asked_text(const TrialGate& gate) {
  std::string text;
  if (gate.least > 0.0) text += fmt::format("at least {:.0f} %", 100.0 * gate.least);
  if (gate.most < 1.0)
    text += fmt::format("{}at most {:.0f} %", text.empty() ? "" : ", ", 100.0 * gate.most);
  if (gate.most_of_upper_bound < 1.0)
    text += fmt::format(", upper bound {:.1f} %", 100.0 * gate.most_of_upper_bound);
  return gate.is_asked() ? text : "-";
}

std::vector<std::string> columns_of(const ConfusionMatrix& confusion) {
  std::set<std::string> columns;
  for (const auto& [row, cells] : confusion)
    for (const auto& [column, count] : cells) columns.insert(column);
  return {columns.begin(), columns.end()};
}

namespace {

/// All but what trials of other balls say.
Json of_one_kind(const TrialScores& scores) {
  Json controls = Json::object(), protocols = Json::array();
  for (const ControlName& control : control_names)
    controls[control.key] = gates_json(scores.controls.at(control.key));
  for (const auto& [digest, protocol] : scores.protocols) {
    Json one = {{"digest", digest}};
    one.update(protocol);
    protocols.push_back(std::move(one));
  }
  return {{"schema", 1},
          {"complete", true},
          {"trials", scores.trials},
          {"origins", scores.origins},
          {"not_visible", scores.not_visible},
          {"without_answer", scores.without_answer},
          {"protocols", protocols},
          {"gates", gates_json(scores.gates)},
          {"controls", controls},
          {"confusion", scores.confusion},
          {"confusion_by_name", scores.confusion_by_name},
          {"rates", rates_json(scores.rates)},
          {"mean_candidates", scores.mean_candidates},
          {"false_alarms_by_noise", shares_json(scores.false_alarms_by_noise)},
          {"not_wrong_by_form", shares_json(scores.not_wrong_by_form)},
          {"seconds", {{"median", scores.median_seconds}, {"longest", scores.longest_seconds}}}};
}

std::string text_of_one_kind(const TrialScores& scores) {
  std::string text = fmt::format(
      "{} trials, {} of them with an effect that does not show; a diagnosis took {:.2g} s, at most "
      "{:.2g} s\n",
      scores.trials, scores.not_visible, scores.median_seconds, scores.longest_seconds);
  if (scores.without_answer > 0)
    text += fmt::format("warning   {} of them ended in an error, without an answer\n",
                        scores.without_answer);
  if (scores.mean_candidates > 0.0)
    text += fmt::format("sets      {:.2g} in the answer on average, where any is said\n",
                        scores.mean_candidates);
  for (const auto& [origin, count] : scores.origins)
    text += fmt::format("trials    {}: {}\n", origin, count);
  for (const auto& [digest, protocol] : scores.protocols)
    text += fmt::format("protocol  {}: {}\n", digest, describe_protocol(protocol));
  if (scores.protocols.size() > 1)
    text += "warning   outcomes of more than one protocol: these are not one error rate\n";
  text += "\n" + gate_lines(scores) + control_lines(scores);
  text += confusion_lines("hidden: what was said", scores.confusion);
  text += confusion_lines("nearest effect of the list: the name that was said",
                          scores.confusion_by_name);
  if (!scores.false_alarms_by_ball.empty()) {
    text += "\nnothing hidden: a gap is said of\n";
    for (const auto& [ball, share] : scores.false_alarms_by_ball)
      text += fmt::format("  {:<50}{}\n", ball, short_share(share));
  }
  for (const RateTable& table : scores.rates) text += rate_lines(table);
  return text;
}

}  // namespace

Json to_json(const TrialScores& scores) {
  Json json = of_one_kind(scores);
  const auto apart = [](const std::shared_ptr<const TrialScores>& some) -> Json {
    if (!some) return nullptr;
    Json own = of_one_kind(*some);
    for (const char* shared : {"schema", "complete", "protocols"}) own.erase(shared);
    own["false_alarms_by_ball"] = shares_json(some->false_alarms_by_ball);
    return own;
  };
  json["in_fem"] = apart(scores.in_fem);
  json["fem_believed"] = apart(scores.fem_believed);
  return json;
}

std::string to_text(const TrialScores& scores) {
  std::string text;
  const auto append = [&text](const std::string& title, const TrialScores& some) {
    text += (text.empty() ? "" : "\n") + title + text_of_one_kind(some);
  };
  if (scores.trials > 0 || (!scores.in_fem && !scores.fem_believed)) append("", scores);
  if (scores.in_fem) append("IN FINITE ELEMENTS\n\n", *scores.in_fem);
  if (scores.fem_believed)
    append("IN FINITE ELEMENTS, AND FINITE ELEMENTS BELIEVED\n\n", *scores.fem_believed);
  return text;
}

}  // namespace rebound
