#pragma once

#include <string>

#include "comparisons/io/report/animation.hpp"
#include "fem/interface/fem_result.hpp"

namespace rebound::report {

/// An FE impact's shapes as an animation in millimetres and milliseconds, positions
/// rounded to a micrometre (a picture shows less, and the file stays small), with the
/// fields of its cells over ranges that no frame changes, and the contact pressure;
/// the caption then also says what the colours mean.
/// Errors: Error(bad_input) when `shapes` is empty (see FemControls::shape_frames).
Animation half_section(const ShapeHistory& shapes, const std::string& title,
                       const std::string& caption);

}  // namespace rebound::report
