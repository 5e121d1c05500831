#include "comparisons/discrepancy/trials/table_fields.hpp"

#include <fmt/format.h>

#include <charconv>
#include <type_traits>

#include "comparisons/discrepancy/trials/trial_controls.hpp"

namespace rebound {
Fields parts_of(const std::string& text, char separator) {
  Fields parts;
  std::size_t from = 0;
  for (std::size_t to = text.find(separator); to != std::string::npos;
       from = to + 1, to = text.find(separator, from))
    parts.push_back(text.substr(from, to - from));
  parts.push_back(text.substr(from));
  return parts;
}

std::string joined(const Fields& parts, char separator) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i)
    text += (i == 0 ? std::string() : std::string(1, separator)) + parts[i];
  return text;
}

namespace {

template <class Number>
Number number_of(const std::string& text) {
  Number value{};
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failure != std::errc() || end != text.data() + text.size()) throw FieldError{};
  return value;
}

std::string text_of_number(const std::optional<double>& value) {
  return value ? fmt::format("{}", *value) : std::string();
}

std::optional<double> optional_number(const std::string& text) {
  return text.empty() ? std::nullopt : std::optional(number_of<double>(text));
}

std::string sets_text(const std::vector<Fields>& all) {
  Fields sets;
  for (const Fields& one : all) sets.push_back(joined(one, '+'));
  return joined(sets, '|');
}

std::vector<Fields> sets_of(const std::string& text) {
  std::vector<Fields> sets;
  if (text.empty()) return sets;
  for (const std::string& set : parts_of(text, '|')) sets.push_back(parts_of(set, '+'));
  return sets;
}

std::string answer_text(const TrialAnswer& a) {
  return joined({a.verdict, a.family, a.named, sets_text(a.candidates)}, ';');
}

TrialAnswer answer_of(const std::string& text) {
  const Fields parts = parts_of(text, ';');
  if (parts.size() != 4) throw FieldError{};
  return {
      .verdict = parts[0], .family = parts[1], .candidates = sets_of(parts[3]), .named = parts[2]};
}

template <class Part, class Value>
TableField field(const std::string& name, Part TrialRecord::*part, Value Part::*member) {
  return {name, [=](const TrialRecord& record) { return fmt::format("{}", record.*part.*member); },
          [=](const std::string& text, TrialRecord& record) {
            if constexpr (std::is_same_v<Value, std::string>)
              record.*part.*member = text;
            else
              record.*part.*member = number_of<Value>(text);
          },
          !std::is_same_v<Value, std::string>};
}

template <class Part>
TableField field(const std::string& name, Part TrialRecord::*part,
                 std::optional<double> Part::*member) {
  return {name, [=](const TrialRecord& record) { return text_of_number(record.*part.*member); },
          [=](const std::string& text, TrialRecord& record) {
            record.*part.*member = optional_number(text);
          }};
}

/// One part of the hidden effects, parted by '|'.
TableField effect_field(const std::string& name, std::string (*write)(const TrialEffect&),
                        void (*read)(const std::string&, TrialEffect&)) {
  return {name,
          [=](const TrialRecord& record) {
            Fields parts;
            for (const TrialEffect& effect : record.truth.effects) parts.push_back(write(effect));
            return joined(parts, '|');
          },
          [=](const std::string& text, TrialRecord& record) {
            auto& effects = record.truth.effects;
            if (text.empty() && effects.empty()) return;  // a null
            const Fields parts = parts_of(text, '|');
            if (effects.empty()) effects.resize(parts.size());
            if (parts.size() != effects.size()) throw FieldError{};
            for (std::size_t i = 0; i < parts.size(); ++i) read(parts[i], effects[i]);
          }};
}

void append_truth(std::vector<TableField>& fields) {
  const auto truth = &TrialRecord::truth;
  fields.push_back(field("set", truth, &TrialTruth::set));
  fields.push_back(field("seed", truth, &TrialTruth::seed));
  fields.push_back(field("trial", truth, &TrialTruth::trial));
  // The first of them says how many effects there are: a family is never empty.
  fields.push_back(effect_field(
      "hidden_family", [](const TrialEffect& e) { return e.family; },
      [](const std::string& text, TrialEffect& e) { e.family = text; }));
  fields.push_back(effect_field(
      "hidden_form", [](const TrialEffect& e) { return e.form; },
      [](const std::string& text, TrialEffect& e) { e.form = text; }));
  fields.push_back(effect_field(
      "hidden_name", [](const TrialEffect& e) { return e.registry_name; },
      [](const std::string& text, TrialEffect& e) { e.registry_name = text; }));
  fields.push_back(effect_field(
      "hidden_exact_form",
      [](const TrialEffect& e) { return std::to_string(e.in_registry ? 1 : 0); },
      [](const std::string& text, TrialEffect& e) { e.in_registry = number_of<int>(text) != 0; }));
  fields.push_back(effect_field(
      "hidden_size", [](const TrialEffect& e) { return text_of_number(e.registry_size); },
      [](const std::string& text, TrialEffect& e) { e.registry_size = optional_number(text); }));
  fields.push_back(field("visible_chi_square", truth, &TrialTruth::visible_chi_square));
  fields.push_back(field("nearest_family_cosine", truth, &TrialTruth::nearest_family));
  fields.push_back(field("nearest_name_cosine", truth, &TrialTruth::nearest_name));
  fields.push_back(field("noise_colour", truth, &TrialTruth::noise_colour));
  fields.push_back(field("noise_stated", truth, &TrialTruth::noise_stated));
  fields.push_back(field("noise_share", truth, &TrialTruth::noise_share));
  fields.push_back(field("ball", truth, &TrialTruth::ball));
  fields.back().may_be_absent = true;
  fields.push_back(field("believed", truth, &TrialTruth::believed));
  fields.back().may_be_absent = true;
}

TableField said_field(const std::string& name, std::string TrialAnswer::*member) {
  return {
      name, [=](const TrialRecord& record) { return record.outcome.said.*member; },
      [=](const std::string& text, TrialRecord& record) { record.outcome.said.*member = text; }};
}

TableField sets_field(const std::string& name, std::vector<Fields> TrialAnswer::*member) {
  return {name, [=](const TrialRecord& record) { return sets_text(record.outcome.said.*member); },
          [=](const std::string& text, TrialRecord& record) {
            record.outcome.said.*member = sets_of(text);
          }};
}

void append_outcome(std::vector<TableField>& fields) {
  const auto outcome = &TrialRecord::outcome;
  fields.push_back(field("speeds", outcome, &TrialOutcome::speeds));
  fields.push_back(field("shots", outcome, &TrialOutcome::shots));
  fields.push_back(said_field("verdict", &TrialAnswer::verdict));
  fields.push_back(said_field("family", &TrialAnswer::family));
  fields.push_back(said_field("named", &TrialAnswer::named));
  fields.push_back(sets_field("candidates", &TrialAnswer::candidates));
  fields.push_back(sets_field("candidate_families", &TrialAnswer::candidate_families));
  fields.back().may_be_absent = true;
  fields.push_back({"nearest",
                    [](const TrialRecord& r) { return joined(r.outcome.said.nearest, '|'); },
                    [](const std::string& text, TrialRecord& r) {
                      if (!text.empty()) r.outcome.said.nearest = parts_of(text, '|');
                    }});
  fields.push_back(field("size", outcome, &TrialOutcome::size));
  fields.push_back(field("size_low", outcome, &TrialOutcome::size_low));
  fields.push_back(field("size_high", outcome, &TrialOutcome::size_high));
  fields.push_back(field("unseen_before", outcome, &TrialOutcome::held_out_before));
  fields.push_back(field("unseen_after", outcome, &TrialOutcome::held_out_after));
  fields.push_back(field("unseen_noise", outcome, &TrialOutcome::held_out_noise));
  fields.push_back(field("seconds", outcome, &TrialOutcome::seconds));
  for (const ControlName& name : control_names)
    fields.push_back(
        {name.key,
         [key = name.key](const TrialRecord& r) { return answer_text(r.outcome.controls.at(key)); },
         [key = name.key](const std::string& text, TrialRecord& r) {
           r.outcome.controls[key] = answer_of(text);
         }});
  fields.push_back(field("protocol", outcome, &TrialOutcome::protocol));
}

}  // namespace

std::vector<TableField> table_fields() {
  std::vector<TableField> fields;
  append_truth(fields);
  append_outcome(fields);
  return fields;
}

std::vector<TableField> outcome_fields() {
  std::vector<TableField> fields;
  append_outcome(fields);
  return fields;
}

}  // namespace rebound
