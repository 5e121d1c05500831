#include "comparisons/inference/calibration/material_factors.hpp"

#include <algorithm>
#include <cmath>

namespace rebound {
namespace {

constexpr double reach = 20.0;  // a factor, either way
/// Of a branch over the long-term modulus. Beyond, a shorter time makes of it what the product of
/// both does already, and a contact takes the more steps the stiffer the ball is at once.
constexpr double most_ratio = 5.0;

std::vector<FreeMaterialNumber> free_numbers(Material material) {
  auto numbers = material_numbers(material, reach);
  for (FreeMaterialNumber& number : numbers)
    if (number.what == MaterialUnknown::branch_ratio)
      number.highest = std::min(number.highest, std::max(most_ratio, number_of(material, number)));
  return numbers;
}

}  // namespace

MaterialFactors::MaterialFactors(std::vector<Material> believed, const std::vector<Ball>& balls,
                                 std::vector<CalibrationParameter>& unknowns)
    : believed_(std::move(believed)) {
  for (std::size_t ball = 0; ball < balls.size(); ++ball) {
    auto& own = places_.emplace_back();
    for (const FreeMaterialNumber& number :
         numbers_.emplace_back(free_numbers(believed_.at(ball)))) {
      const double value = number_of(believed_[ball], number);
      own.push_back(unknowns.size());
      unknowns.push_back(
          {.name = balls.size() > 1 ? name_of(number) + " of " + balls[ball].name : name_of(number),
           .unit = "ln of factor",
           .start = 0.0,
           .lowest = std::log(number.lowest / value),
           .highest = std::log(number.highest / value),
           .scale = 1.0});
    }
  }
}

Material MaterialFactors::at(const std::vector<double>& values, std::size_t ball) const {
  Material material = believed_[ball];
  for (std::size_t k = 0; k < numbers_[ball].size(); ++k)
    number_of(material, numbers_[ball][k]) *= std::exp(values[places_[ball][k]]);
  return material;
}

}  // namespace rebound
