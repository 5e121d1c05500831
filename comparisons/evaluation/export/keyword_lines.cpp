#include "comparisons/evaluation/export/keyword_lines.hpp"

#include <fmt/format.h>

#include "fem/interface/elastic_models.hpp"

namespace rebound {
namespace {

constexpr const char* other_volume =
    "volumetric energy K/2 (J - 1)^2 where Rebound has K/4 (J^2 - 1 - 2 ln J): alike to the first "
    "order in the change of volume";

std::string ogden(const SolidCard& solid, const std::string& options) {
  std::string text = fmt::format("*HYPERELASTIC, OGDEN, N={}{}\n", solid.terms.size(), options);
  // All μᵢ, αᵢ and then all Dᵢ, eight numbers a line.
  std::vector<double> numbers;
  for (const StretchCard& term : solid.terms) {
    numbers.push_back(term.shear);
    numbers.push_back(term.exponent);
  }
  // (J - 1)^(2i)/Dᵢ: CalculiX puts a stiff default where a zero stands, 1 Pa is nothing.
  numbers.push_back(solid.d1);
  numbers.resize(3 * solid.terms.size(), 1.0);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    text +=
        fmt::format("{:.12g}{}", numbers[i], i % 8 == 7 || i + 1 == numbers.size() ? "\n" : ", ");
  return text;
}

/// Codes ask for νᵢ: βᵢ = νᵢ/(1 − 2νᵢ).
std::string hyperfoam(const SolidCard& solid, const std::string& options) {
  std::string text = fmt::format("*HYPERFOAM, N={}{}\n", solid.terms.size(), options);
  std::vector<double> numbers;
  for (const StretchCard& term : solid.terms) {
    numbers.push_back(term.shear);
    numbers.push_back(term.exponent);
  }
  for (const StretchCard& term : solid.terms)
    numbers.push_back(term.beta / (1.0 + 2.0 * term.beta));
  for (std::size_t i = 0; i < numbers.size(); ++i)
    text +=
        fmt::format("{:.12g}{}", numbers[i], i % 8 == 7 || i + 1 == numbers.size() ? "\n" : ", ");
  return text;
}

}  // namespace

std::string number_lines(const std::vector<int>& nodes) {
  std::string text;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    text += fmt::format("{}{}", nodes[i] + 1, i % 16 == 15 || i + 1 == nodes.size() ? "\n" : ", ");
  return text;
}

std::string hyperelastic_lines(const SolidCard& solid, const std::string& options,
                               std::vector<std::string>& differences) {
  if (solid.elastic == ElasticModel::hyperfoam) return hyperfoam(solid, options);
  if (solid.elastic == ElasticModel::neo_hookean)
    differences.push_back(
        "elastic = \"neo-hookean\" is written as mu/2 (J^(-2/3) I1 - 3) + K/2 (J - 1)^2, which the "
        "code has: the same moduli, another energy at finite strain; take "
        "\"neo-hookean-isochoric\" on both sides");
  else if (solid.elastic != ElasticModel::neo_hookean_isochoric)
    differences.push_back(other_volume);
  if (solid.elastic == ElasticModel::ogden) return ogden(solid, options);
  if (solid.elastic == ElasticModel::mooney_rivlin)
    return fmt::format("*HYPERELASTIC, MOONEY-RIVLIN{}\n{:.12g}, {:.12g}, {:.12g}\n", options,
                       solid.c10, solid.c01, solid.d1);
  return fmt::format("*HYPERELASTIC, NEO HOOKE{}\n{:.12g}, {:.12g}\n", options, solid.c10,
                     solid.d1);
}

}  // namespace rebound
