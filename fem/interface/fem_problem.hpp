#pragma once

#include <string>

#include "fem/interface/adhesive_traction.hpp"
#include "fem/interface/material.hpp"
#include "lumped/problem/impact.hpp"
#include "lumped/problem/plate.hpp"

namespace rebound {

/// Resolution and recording of one FE impact. Zero means "choose".
struct FemControls {
  double step_safety = 0.9;  ///< step over the stable step (implicit: over a 180th of the Hertz
                             ///< contact time), in (0, 1]
  /// No step longer than this: below every stable step it fixes the step, as
  /// differences between impacts want it (explicit); 0: no such limit [s].
  double largest_step = 0.0;
  double output_interval = 0.0;  ///< trace spacing [s]; 0: a 200th of the Hertz contact time
  double end_time = 0.0;         ///< give up after this much contact [s]; 0: 20 Hertz contact times
  int shape_frames = 0;          ///< shapes kept in the result, over the contact; 0: none
  int field_frames = 0;          ///< number of field outputs over the contact; 0: none
  std::string field_directory;   ///< where VTU and PVD go; empty: nowhere

  static constexpr auto limits() {
    constexpr Range frames = from_to(0.0, 10000.0);
    return std::tuple{Limit{&FemControls::step_safety, "step_safety", "", above_up_to(0.0, 1.0)},
                      Limit{&FemControls::largest_step, "largest_step", "us", at_least(0.0)},
                      Limit{&FemControls::output_interval, "output_interval", "us", at_least(0.0)},
                      Limit{&FemControls::end_time, "end_time", "ms", at_least(0.0)},
                      Limit{&FemControls::shape_frames, "shape_frames", "", frames},
                      Limit{&FemControls::field_frames, "field_frames", "", frames}};
  }
  friend bool operator==(const FemControls&, const FemControls&) = default;
};

/// How the FE tier is cut into cells and steps. Two ways that share no algorithm.
enum class FemScheme {
  explicit_steps,  ///< central differences, bilinear cells, kinematic contact
  implicit_steps   ///< generalised-α, nine-node cells, active set
};
constexpr auto names_of(FemScheme) {
  return names_list<FemScheme>(
      {{"explicit", FemScheme::explicit_steps}, {"implicit", FemScheme::implicit_steps}});
}

/// One impact of the FE tier.
struct FemProblem {
  FemScheme scheme = FemScheme::explicit_steps;
  Sphere sphere;
  Impact impact;
  Material material;
  Plate plate;
  AdhesiveTraction adhesion;
  double gravity = 0.0;   ///< towards the plate; 0: left out [m/s²]
  int cells = 1000;       ///< about; when no mesh file is given, or one of a geometry alone
  std::string mesh_file;  ///< a user's own mesh; empty: generate
  FemControls controls;

  static constexpr auto limits() {
    return std::tuple{Limit{&FemProblem::cells, "cells", "", from_to(20.0, 1e6)}};
  }
  friend bool operator==(const FemProblem&, const FemProblem&) = default;
};

}  // namespace rebound
