#pragma once

#include "fem/materials/strain_factor.hpp"

namespace rebound::fem {

/// What a material does beside elasticity and convolved branches; plain, for kernels.
struct InelasticConstants {
  bool acts = false;  ///< anything below differs from its null
  bool factor_acts = false;
  bool has_multiplicative = false;
  bool remembers_strain = false;  ///< one number more is carried at each point
  StrainFactor factor;
  double retardation_time = 0.0;  ///< of the viscous stress [s]
  double law_growth_share =
      1.0;  ///< what the law's growth counts for beside multiplicative branches
};

}  // namespace rebound::fem
