#pragma once

#include "fem/interface/element_checks.hpp"

namespace rebound::fem {

/// The checks of this room behind the interface of the module.
const ElementChecks& element_checks();

}  // namespace rebound::fem
