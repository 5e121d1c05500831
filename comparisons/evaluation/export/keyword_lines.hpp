#pragma once

#include <string>
#include <vector>

#include "comparisons/evaluation/export/solid_card.hpp"

/// Pieces of text that CalculiX and Abaqus read alike.
namespace rebound {

/// "1, 2, …" in lines of sixteen; node numbers from 0 become numbers from 1.
std::string number_lines(const std::vector<int>& nodes);

/// *HYPERELASTIC or *HYPERFOAM with its constants of the given state; `options` are added to
/// the keyword, as ", MODULI=INSTANTANEOUS". What is different goes to `differences`.
std::string hyperelastic_lines(const SolidCard& solid, const std::string& options,
                               std::vector<std::string>& differences);

}  // namespace rebound
