#pragma once

#include "fem/interface/element_checks.hpp"

namespace rebound {

/// The cells of the FE tier without an impact, loaded as fem_tier() is. Errors: the same.
const ElementChecks& element_checks();

}  // namespace rebound
