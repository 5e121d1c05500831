#pragma once

#include "fem/interface/material_laws.hpp"

namespace rebound {

/// The materials of the FE tier, loaded as fem_tier() is. Errors: the same.
const MaterialLaws& material_laws();

}  // namespace rebound
