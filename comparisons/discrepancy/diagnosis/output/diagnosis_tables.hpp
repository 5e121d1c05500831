#pragma once

#include <string>
#include <vector>

#include "comparisons/discrepancy/diagnosis/diagnosis.hpp"
#include "comparisons/io/report/table.hpp"

namespace rebound {

/// The numbers of what is missing, with their 95 % intervals in units that one says.
report::Table found_table(const Diagnosis& diagnosis);

/// Every set of effects that was fitted, with what it leaves.
report::Table candidate_table(const Diagnosis& diagnosis);

/// Sizes that the data leave possible.
report::Table excluded_table(const Diagnosis& diagnosis);

/// Checks of the data, each with its deviation.
report::Table check_table(const std::string& title, const std::string& caption,
                          const std::vector<DataCheck>& checks);

/// The choice made again on repeated data.
report::Table bootstrap_table(const SelectionBootstrap& bootstrap);

/// Which experiment would tell the candidates apart.
report::Table next_table(const Diagnosis& diagnosis);

}  // namespace rebound
