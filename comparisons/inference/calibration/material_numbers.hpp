#pragma once

#include <string>
#include <vector>

#include "comparisons/inference/calibration/calibration_problem.hpp"
#include "fem/interface/material.hpp"

namespace rebound {

/// A number of the material that may move.
enum class MaterialUnknown { youngs_modulus, branch_ratio, branch_time };

struct FreeMaterialNumber {
  MaterialUnknown what = MaterialUnknown::branch_ratio;
  int branch = 0;       ///< which branch, from 0; of no account for the modulus
  double lowest = 0.0;  ///< SI
  double highest = 0.0;
};

/// As estimates and reports name it, e.g. "branch 1 ratio".
std::string name_of(const FreeMaterialNumber& number);
/// As a file names it, e.g. "branch[0].ratio".
std::string key_of(const FreeMaterialNumber& number);
const char* unit_of(MaterialUnknown what);

/// The number itself, in a material that has the branch.
double& number_of(Material& material, const FreeMaterialNumber& number);

/// Every number that may move, bounded to `reach` times its value either way;
/// shares of an instantaneous modulus also so that they sum below 1.
std::vector<FreeMaterialNumber> material_numbers(const Material& material, double reach);

/// The one of that key or name.
/// Errors: Error(bad_input) listing what there is.
FreeMaterialNumber find_material_number(const std::vector<FreeMaterialNumber>& numbers,
                                        const std::string& key_or_name);

}  // namespace rebound
