#pragma once

#include <vector>

#include "fem/interface/material.hpp"

namespace rebound {

/// One state of a bar under uniaxial stress, sides free.
struct UniaxialState {
  double stretch = 1.0;          ///< λ along the bar [-]
  double lateral_stretch = 1.0;  ///< across it [-]
  double nominal_stress = 0.0;   ///< force over the area at rest, tension positive [Pa]
};

/// The FE tier's materials without a body; in module "rebound_fem".
class MaterialLaws {
 public:
  virtual ~MaterialLaws() = default;

  /// Slow uniaxial stress: branches relaxed, first loading.
  /// Errors: Error(bad_input) for a material out of range or a stretch that is not
  ///         positive, Error(solver_failed) where no lateral stretch frees the sides.
  virtual std::vector<UniaxialState> uniaxial(const Material& material,
                                              const std::vector<double>& stretches) const = 0;
};

/// Entry point beside fem_entry_point, with the same stamp.
inline constexpr const char* material_entry_point = "rebound_material_laws";

}  // namespace rebound
