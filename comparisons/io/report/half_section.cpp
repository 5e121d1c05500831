#include "comparisons/io/report/half_section.hpp"

#include <algorithm>
#include <cmath>

#include "lumped/problem/error.hpp"

namespace rebound::report {
namespace {

double rounded_millimetres(double metres) {
  return std::round(metres * 1e6) / 1e3;
}

/// Four digits, which is more than a drawn curve shows.
double rounded(double value) {
  if (value == 0.0) return 0.0;
  const double scale = std::pow(10.0, 3.0 - std::floor(std::log10(std::abs(value))));
  return std::round(value * scale) / scale;
}

struct Wording {
  const char* name;
  const char* unit;
  double per_si;  ///< number in `unit` of one in SI
};

Wording wording_of(ShapeQuantity quantity) {
  switch (quantity) {
    case ShapeQuantity::von_mises: return {"von Mises stress", "MPa", 1e-6};
    case ShapeQuantity::pressure: return {"pressure, compression positive", "MPa", 1e-6};
    case ShapeQuantity::stored: return {"stored energy density", "kJ/m³", 1e-3};
    case ShapeQuantity::dissipated: return {"dissipated energy density", "kJ/m³", 1e-3};
    case ShapeQuantity::dissipated_or_held:
      return {"energy density dissipated or held in branches", "kJ/m³", 1e-3};
    case ShapeQuantity::speed: return {"speed", "m/s", 1.0};
  }
  __builtin_unreachable();
}

/// The colours end at the values that one in a thousand is beyond: one cell at the edge of
/// the contact would take them from all others.
AnimationField field_of(const ShapeField& field) {
  const Wording wording = wording_of(field.quantity);
  AnimationField shown{.name = wording.name, .unit = wording.unit, .values = field.values};
  std::vector<float> all;
  for (auto& row : shown.values)
    for (float& value : row) all.push_back(value *= static_cast<float>(wording.per_si));
  std::sort(all.begin(), all.end());
  const std::size_t beyond = all.size() / 1000;
  const double low = all[beyond], high = all[all.size() - 1 - beyond];
  const double rounding = 1e-6 * std::max(std::abs(low), std::abs(high));
  shown.low = low < -rounding ? rounded(low) : 0.0;
  shown.high = high > rounding ? rounded(high) : 0.0;
  if (!(shown.high > shown.low)) shown.high = shown.low + 1.0;
  return shown;
}

constexpr const char* meaning_of_fields =
    " Each cell has the colour of its mean: Cauchy stress, energies per volume at rest. The "
    "colours "
    "are the same in all frames and end where one value in a thousand is beyond. Contact pressure "
    "is "
    "a mean over the last hundredth to fiftieth of the contact.";

AnimationContact contact_of(const ShapeHistory& shapes) {
  AnimationContact contact{.vertices = shapes.contact_vertices, .unit = "MPa", .pressure = {}};
  for (const auto& row : shapes.contact_pressure) {
    std::vector<double> pressure;
    pressure.reserve(row.size());
    for (const float value : row) pressure.push_back(rounded(1e-6 * static_cast<double>(value)));
    contact.pressure.push_back(std::move(pressure));
  }
  return contact;
}

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
  for (const ShapeField& field : shapes.fields) animation.fields.push_back(field_of(field));
  if (!shapes.fields.empty()) animation.caption += meaning_of_fields;
  if (!shapes.contact_vertices.empty()) animation.contact = contact_of(shapes);
  return animation;
}

}  // namespace rebound::report
