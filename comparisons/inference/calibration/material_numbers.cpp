#include "comparisons/inference/calibration/material_numbers.hpp"

#include <algorithm>

#include "lumped/problem/error.hpp"

namespace rebound {

double& number_of(Material& material, const FreeMaterialNumber& number) {
  if (number.what == MaterialUnknown::youngs_modulus) return material.youngs_modulus;
  auto& branch = material.branches.at(static_cast<std::size_t>(number.branch));
  return number.what == MaterialUnknown::branch_ratio ? branch.ratio : branch.relaxation_time;
}

std::string name_of(const FreeMaterialNumber& number) {
  const std::string branch = "branch " + std::to_string(number.branch + 1);
  switch (number.what) {
    case MaterialUnknown::youngs_modulus: return "Young's modulus";
    case MaterialUnknown::branch_ratio: return branch + " ratio";
    case MaterialUnknown::branch_time: return branch + " relaxation time";
  }
  return {};
}

std::string key_of(const FreeMaterialNumber& number) {
  const std::string branch = "branch[" + std::to_string(number.branch) + "].";
  switch (number.what) {
    case MaterialUnknown::youngs_modulus: return "youngs_modulus";
    case MaterialUnknown::branch_ratio: return branch + "ratio";
    case MaterialUnknown::branch_time: return branch + "relaxation_time";
  }
  return {};
}

const char* unit_of(MaterialUnknown what) {
  switch (what) {
    case MaterialUnknown::youngs_modulus: return "Pa";
    case MaterialUnknown::branch_ratio: return "1";
    case MaterialUnknown::branch_time: return "s";
  }
  return "";
}

std::vector<FreeMaterialNumber> material_numbers(const Material& material, double reach) {
  std::vector<FreeMaterialNumber> numbers{{.what = MaterialUnknown::youngs_modulus}};
  for (int i = 0; i < static_cast<int>(material.branches.size()); ++i)
    for (const auto what : {MaterialUnknown::branch_ratio, MaterialUnknown::branch_time})
      numbers.push_back({.what = what, .branch = i});
  Material copy = material;
  double taken = 0.0;
  for (const auto& branch : material.branches) taken += branch.ratio;
  // Shares of an instantaneous modulus sum below 1: what is left is dealt out evenly.
  constexpr double most = 0.97;  // differences step a little beyond a bound
  const double left = (most - taken) / std::max(1.0, static_cast<double>(material.branches.size()));
  const bool shares = material.modulus == ModulusBasis::instantaneous;
  for (auto& number : numbers) {
    const double value = number_of(copy, number);
    number.lowest = value / reach;
    number.highest = value * reach;
    if (shares && number.what == MaterialUnknown::branch_ratio)
      number.highest = std::min(number.highest, std::max(value, value + left));
  }
  return numbers;
}

FreeMaterialNumber find_material_number(const std::vector<FreeMaterialNumber>& numbers,
                                        const std::string& key_or_name) {
  std::string allowed;
  for (const auto& number : numbers) {
    if (key_of(number) == key_or_name || name_of(number) == key_or_name) return number;
    allowed += (allowed.empty() ? "" : " | ") + key_of(number);
  }
  throw Error(ExitCode::bad_input, "the material has no such number to fit",
              {.key = "free", .value = key_or_name, .allowed = allowed});
}

}  // namespace rebound
