#include "comparisons/report/half_section.hpp"

#include <cmath>

#include "lumped/problem/error.hpp"

namespace rebound::report {
namespace {

double rounded_millimetres(double metres) { return std::round(metres * 1e6) / 1e3; }

}  // namespace

Animation half_section(const ShapeHistory& shapes, const std::string& title,
                       const std::string& caption) {
  if (shapes.time.empty()) {
    throw Error(ExitCode::bad_input, "the impact kept no shapes (controls.shape_frames is 0)");
  }
  Animation animation;
  animation.title = title;
  animation.caption = caption;
  animation.origin = Origin::predicted;
  animation.length_unit = "mm";
  animation.time_unit = "ms";
  animation.cells = shapes.cells;
  for (std::size_t i = 0; i < shapes.time.size(); ++i) {
    AnimationFrame frame{.time = 1e3 * shapes.time[i], .radius = {}, .height = {}};
    for (const auto& [radius, height] : shapes.positions[i]) {
      frame.radius.push_back(rounded_millimetres(radius));
      frame.height.push_back(rounded_millimetres(height));
    }
    animation.frames.push_back(std::move(frame));
  }
  return animation;
}

}  // namespace rebound::report
