#include "comparisons/accuracy/verification/refinement.hpp"

#include <fmt/format.h>

#include <cmath>

#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

/// log(error) = order · log(size) + level.
struct PowerFit {
  double order = 0.0, level = 0.0;
};

PowerFit fit(const Refinement& refinement) {
  const std::size_t first = refinement.left_out, last = refinement.size.size();
  const double count = static_cast<double>(last) - static_cast<double>(first);
  bool sound = count >= 2.0 && refinement.error.size() == last;
  double x_mean = 0.0, y_mean = 0.0;
  for (std::size_t i = first; sound && i < last; ++i) {
    sound =
        refinement.error[i] > 0.0 && std::isfinite(refinement.error[i]) && refinement.size[i] > 0.0;
    x_mean += std::log(refinement.size[i]) / count;
    y_mean += std::log(refinement.error[i]) / count;
  }
  if (!sound)
    throw Error(ExitCode::bad_input, "no order can be fitted to the errors of " + refinement.name);
  double xx = 0.0, xy = 0.0;
  for (std::size_t i = first; i < last; ++i) {
    const double x = std::log(refinement.size[i]) - x_mean;
    xx += x * x;
    xy += x * (std::log(refinement.error[i]) - y_mean);
  }
  return {xy / xx, y_mean - xy / xx * x_mean};
}

}  // namespace

double fitted_order(const Refinement& refinement) {
  return fit(refinement).order;
}

VerificationRow order_row(const std::string& case_id, const Refinement& refinement,
                          const std::string& source) {
  const double order = fitted_order(refinement);
  return {.case_id = case_id,
          .quantity = "order of " + refinement.name,
          .unit = "",
          .target = refinement.expected_order,
          .result = order,
          .tolerance = refinement.tolerance,
          .scale = ToleranceScale::absolute,
          .order = order,
          .source = source};
}

report::Figure refinement_figure(const RefinementAxes& axes,
                                 const std::vector<Refinement>& refinements) {
  using report::Series;
  report::Figure figure{
      .title = axes.title, .caption = axes.caption, .x = axes.size, .y = axes.error};
  figure.x.spacing = figure.y.spacing = report::Axis::Spacing::logarithmic;
  for (const Refinement& refinement : refinements) {
    const PowerFit line = fit(refinement);
    figure.series.push_back({.name = fmt::format("{}: order {:.2f}", refinement.name, line.order),
                             .origin = axes.origin,
                             .style = Series::Style::points,
                             .x = refinement.size,
                             .y = refinement.error});
    Series fitted{.name = "fit, " + refinement.name,
                  .origin = report::Origin::fitted,
                  .role = Series::Role::reference};
    for (const double size : {refinement.size[refinement.left_out], refinement.size.back()}) {
      fitted.x.push_back(size);
      fitted.y.push_back(std::exp(line.level + line.order * std::log(size)));
    }
    figure.series.push_back(std::move(fitted));
  }
  return figure;
}

}  // namespace rebound
