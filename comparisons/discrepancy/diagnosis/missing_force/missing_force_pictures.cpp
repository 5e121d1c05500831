#include "comparisons/discrepancy/diagnosis/missing_force/missing_force_pictures.hpp"

#include <fmt/format.h>

#include <functional>

namespace rebound {
namespace {

using report::milli;
using Keeps = std::function<bool(double velocity)>;

report::Series line_of(const MissingForceCurve& curve, const std::vector<double>& over,
                       double factor, const Keeps& keeps) {
  report::Series line{.name = fmt::format("{:.3g} m/s", curve.speed),
                      .origin = report::Origin::fitted};
  for (std::size_t i = 0; i < over.size(); ++i) {
    if (!keeps(curve.velocity[i])) continue;
    line.x.push_back(factor * over[i]);
    line.y.push_back(curve.force[i]);
    line.y_low.push_back(curve.low[i]);
    line.y_high.push_back(curve.high[i]);
  }
  return line;
}

report::Figure figure_of(const MissingForce& missing, const std::string& title,
                         const report::Axis& x, std::vector<double> MissingForceCurve::*over,
                         double factor, const Keeps& keeps) {
  report::Figure figure{
      .title = title,
      .caption =
          "What has to be added to the force of the law, one line a speed, with its 95 % "
          "band. It stands beside the numbers of the law at which it is smallest; the band "
          "holds the noise and what it did to the motion.",
      .x = x,
      .y = {"missing force", "N"}};
  for (const MissingForceCurve& curve : missing.curves)
    figure.series.push_back(line_of(curve, curve.*over, factor, keeps));
  return figure;
}

}  // namespace

std::vector<report::Figure> missing_force_figures(const MissingForce& missing) {
  if (!missing.found()) return {};
  const report::Axis deflection{"deflection", "mm"}, velocity{"velocity, closing positive", "m/s"};
  return {figure_of(missing, "The missing force while loading", deflection,
                    &MissingForceCurve::deflection, milli, [](double v) { return v > 0.0; }),
          figure_of(missing, "The missing force while unloading", deflection,
                    &MissingForceCurve::deflection, milli, [](double v) { return v <= 0.0; }),
          figure_of(missing, "The missing force over velocity", velocity,
                    &MissingForceCurve::velocity, 1.0, [](double) { return true; })};
}

}  // namespace rebound
