#include "comparisons/io/dataset/published_values.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <string_view>

#include "comparisons/io/toml/describe_impact.hpp"
#include "comparisons/io/toml/reader.hpp"
#include "comparisons/io/toml/units.hpp"

namespace rebound {
namespace {

/// Half a unit of the last digit of a decimal number.
double half_last_digit(std::string_view number) {
  const auto e = number.find_first_of("eE");
  const std::string_view mantissa = number.substr(0, e);
  const auto point = mantissa.find('.');
  const auto decimals =
      point == std::string_view::npos ? 0 : static_cast<int>(mantissa.size() - point) - 1;
  int exponent = 0;
  if (e != std::string_view::npos) {
    std::string_view digits = number.substr(e + 1);
    if (digits.starts_with('+')) digits.remove_prefix(1);
    std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
  }
  return 0.5 * std::pow(10.0, exponent - decimals);
}

/// One printed number by one declaration.
void visit_printed(Visitor& visit, const Key& key, PrintedNumber& number) {
  visit.number(key, number.value);
}

void add_widths(const Document& document, PublishedValues& values) {
  const auto add = [&](const std::string& key, PrintedNumber& number) {
    number = printed_number(document, key);
  };
  add("poisson_ratio", values.poisson_ratio);
  add("hertz_stiffness", values.hertz_stiffness);
  add("hunt_crossley_stiffness", values.hunt_crossley_stiffness);
  for (std::size_t i = 0; i < values.at_speed.size(); ++i) {
    PublishedAtSpeed& at = values.at_speed[i];
    const auto path = [&](const char* name) { return fmt::format("at_speed[{}].{}", i, name); };
    add(path("hunt_crossley_damping"), at.hunt_crossley_damping);
    add(path("linear_damping"), at.linear_damping);
    add(path("linear_stiffness"), at.linear_stiffness);
    add(path("damping_factor"), at.damping_factor);
    add(path("linear_contact_time"), at.linear_contact_time);
    add(path("linear_restitution"), at.linear_restitution);
  }
}

}  // namespace

void describe(Visitor& visit, PublishedAtSpeed& at) {
  visit.number(
      {.name = "speed", .sentence = "Nominal approach speed.", .unit = "m/s", .range = above(0.0)},
      at.speed);
  visit_printed(visit,
                {.name = "hunt_crossley_damping",
                 .sentence = "Lambda of Eq. (8) with the measured restitution.",
                 .unit = "N.s/m^2.5",
                 .range = above(0.0)},
                at.hunt_crossley_damping);
  visit_printed(visit,
                {.name = "linear_damping",
                 .sentence = "c_eq of Eq. (15).",
                 .unit = "N.s/m",
                 .range = above(0.0)},
                at.linear_damping);
  visit_printed(visit,
                {.name = "linear_stiffness",
                 .sentence = "k_eq of Eq. (15).",
                 .unit = "N/m",
                 .range = above(0.0)},
                at.linear_stiffness);
  visit_printed(
      visit, {.name = "damping_factor", .sentence = "Xi of Eq. (16).", .range = from_to(0.0, 1.0)},
      at.damping_factor);
  visit_printed(visit,
                {.name = "linear_contact_time",
                 .sentence = "Model contact time, Eq. (12).",
                 .unit = "ms",
                 .range = above(0.0)},
                at.linear_contact_time);
  visit_printed(visit,
                {.name = "linear_restitution",
                 .sentence = "Model restitution, Eq. (13).",
                 .range = from_to(0.0, 1.0)},
                at.linear_restitution);
}

void describe(Visitor& visit, PublishedValues& values) {
  describe_schema(visit);
  visit.text({.name = "name", .sentence = "The ball."}, values.name);
  visit.text({.name = "source", .sentence = "Where the values are printed."}, values.source);
  visit_printed(
      visit,
      {.name = "poisson_ratio", .sentence = "Assumed by the authors.", .range = between(-1.0, 0.5)},
      values.poisson_ratio);
  visit_printed(visit,
                {.name = "hertz_stiffness",
                 .sentence = "Computed by the authors from the block modulus, Eq. (10).",
                 .unit = "N/m^1.5",
                 .range = above(0.0)},
                values.hertz_stiffness);
  visit_printed(visit,
                {.name = "hunt_crossley_stiffness",
                 .sentence = "Fitted by the authors to the impacts at all speeds.",
                 .unit = "N/m^1.5",
                 .range = above(0.0)},
                values.hunt_crossley_stiffness);
  visit.list({.name = "at_speed", .sentence = "Values of one speed; repeat for more."},
             values.at_speed);
}

PrintedNumber printed_number(const Document& document, const std::string& key) {
  const auto node = toml::at_path(document.root(), key);
  if (!node || !(node.is_string() || node.is_number()))
    throw document.error_at(key, "a printed number is needed here");
  if (const auto text = node.value<std::string>(); text && node.is_string()) {
    const auto space = text->find(' ');
    const Unit unit = space == std::string::npos ? Unit{} : parse_unit(text->substr(space + 1));
    return {parse_quantity(*text, unit.dimension),
            half_last_digit(std::string_view(*text).substr(0, space)) * unit.factor()};
  }
  const std::string text = document.error_at(key, "").location().value;  // as written
  return {node.value<double>().value_or(0.0), half_last_digit(text)};
}

PublishedValues read_published_values(const std::filesystem::path& folder) {
  const Document document = Document::load(folder / "published_model_values.toml");
  PublishedValues values;
  read_document(document, values);
  add_widths(document, values);
  return values;
}

}  // namespace rebound
