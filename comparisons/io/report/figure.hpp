#pragma once

#include <string>
#include <vector>

namespace rebound::report {

/// Where a number comes from; every mark and column of a report is labelled with it.
enum class Origin {
  measured,   ///< read by an instrument, or published as such
  derived,    ///< computed from measured numbers alone, e.g. a mean of the force history
  fitted,     ///< a model's number that was adjusted to the data beside it
  predicted,  ///< a model's number that was not
};

/// A quantity along an axis. The numbers are in `unit`; "1" is dimensionless.
struct Axis {
  std::string quantity;  ///< e.g. "deflection"
  std::string unit;      ///< e.g. "mm"
  enum class Spacing { linear, logarithmic } spacing = Spacing::linear;
};

/// One line or one set of points. Vectors are as long as `x`, or empty where optional.
/// Caution: a measured series is drawn as points only, so that no drawn line can be
///          taken for a measurement; check_report refuses a measured line.
struct Series {
  enum class Style { line, points };
  enum class Role { candidate, reference };  ///< a reference is drawn in ink, not in colour

  std::string name;  ///< the same name has the same colour all over the report
  Origin origin = Origin::predicted;
  Style style = Style::line;
  Role role = Role::candidate;
  std::vector<double> x{};
  std::vector<double> y{};
  std::vector<double> x_error{};  ///< half-width of the error bar (optional)
  std::vector<double> y_error{};  ///< half-width of the error bar (optional)
  std::vector<double> y_low{};    ///< lower edge of the uncertainty band (optional)
  std::vector<double> y_high{};   ///< upper edge, given with y_low
};

inline constexpr double milli = 1e3;  ///< m to mm, s to ms

/// The numbers in the unit of an axis.
inline std::vector<double> scaled(std::vector<double> values, double factor) {
  for (double& value : values) value *= factor;
  return values;
}

/// A drawn picture of one or more series over the same two axes.
struct Figure {
  std::string title;
  std::string caption;  ///< what to see in it, and what bars and bands mean
  Axis x;
  Axis y;
  std::vector<Series> series{};
};

}  // namespace rebound::report
