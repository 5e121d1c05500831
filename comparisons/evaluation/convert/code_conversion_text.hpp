#pragma once

#include <string>

#include "comparisons/evaluation/convert/code_conversion.hpp"
#include "comparisons/io/results/json.hpp"

namespace rebound {

Json to_json(const OtherCode& code, const CodeConversion& conversion);
/// The lines as they are pasted, then what they hold for and their errors.
std::string to_text(const OtherCode& code, const CodeConversion& conversion);

}  // namespace rebound
