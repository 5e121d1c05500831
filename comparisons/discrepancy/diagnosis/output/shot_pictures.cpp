#include "comparisons/discrepancy/diagnosis/output/shot_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "comparisons/discrepancy/diagnosis/fits/held_out_gap.hpp"
#include "comparisons/discrepancy/diagnosis/output/residual_pictures.hpp"

namespace rebound {
namespace {

using report::milli;
using report::Origin;
using report::Series;

Series line(const std::string& name, Origin origin, const std::vector<double>& time,
            const std::vector<double>& force) {
  Series series{.name = name, .origin = origin, .role = Series::Role::candidate, .y = force};
  for (const double t : time) series.x.push_back(milli * t);
  return series;
}

/// The measured history: points with their noise, thinned so that lines stay visible.
Series measured_points(const MeasuredImpact& shot) {
  Series series{.name = "measured",
                .origin = Origin::measured,
                .style = Series::Style::points,
                .role = Series::Role::reference};
  constexpr std::size_t shown = 120;
  const Trace& history = shot.trace;
  const std::size_t stride = std::max<std::size_t>(1, history.time.size() / shown);
  for (std::size_t i = 0; i < history.time.size(); i += stride) {
    series.x.push_back(milli * history.time[i]);
    series.y.push_back(history.force[i]);
    series.y_error.push_back(shot.noise.deviation);
  }
  return series;
}

/// A shot with a force history, and the force of the models at its instants.
struct DrawnShot {
  const MeasuredImpact* shot = nullptr;
  bool unseen = false;
  Origin origin = Origin::fitted;
  std::vector<double> before, after;  ///< [N]; after: empty where nothing was added

  const std::vector<double>* force_after() const { return after.empty() ? nullptr : &after; }
  std::string title(const std::string& what) const {
    return fmt::format("{}{}: {}", what, unseen ? " at the unseen speed" : "", shot->label);
  }
};

std::vector<DrawnShot> drawn_shots(const Diagnosis& d) {
  std::vector<DrawnShot> drawn;
  for (std::size_t i = 0; i < d.unseen->shots.size() && d.unseen_before; ++i)
    if (const MeasuredImpact& shot = d.unseen->shots[i]; shot.has_history())
      drawn.push_back({&shot, true, Origin::predicted, d.unseen_before->force[i],
                       d.unseen_after ? d.unseen_after->force[i] : std::vector<double>{}});
  const HypothesisFit& before = d.believed.fit;
  const HypothesisFit* after = d.extended() ? &d.best() : nullptr;
  for (std::size_t i = 0; i < d.seen->shots.size(); ++i) {
    const MeasuredImpact& shot = d.seen->shots[i];
    if (!shot.has_history()) continue;
    drawn.push_back({&shot, false, Origin::fitted,
                     before.model->force_at(before.values, i, shot.trace.time),
                     after ? after->model->force_at(after->values, i, shot.trace.time)
                           : std::vector<double>{}});
  }
  return drawn;
}

report::Figure history_figure(const DrawnShot& drawn) {
  const std::vector<double>& time = drawn.shot->trace.time;
  report::Figure figure{.title = drawn.title("Force"),
                        .caption = "Points with one standard deviation of the noise.",
                        .x = {"time", "ms"},
                        .y = {"force", "N"}};
  figure.series.push_back(measured_points(*drawn.shot));
  figure.series.push_back(line(before_name, drawn.origin, time, drawn.before));
  if (drawn.force_after())
    figure.series.push_back(line(after_name, drawn.origin, time, drawn.after));
  return figure;
}

Series points_of(const std::string& name, Origin origin) {
  return {.name = name, .origin = origin, .style = Series::Style::points};
}

/// A gap of thousands beside one of the noise.
void space_by_decades_where_they_are_many(report::Figure& figure) {
  constexpr double many = 30.0;
  double largest = 0.0;
  for (const Series& one : figure.series)
    largest = std::max(largest, *std::max_element(one.y.begin(), one.y.end()));
  if (largest > many) figure.y.spacing = report::Axis::Spacing::logarithmic;
}

}  // namespace

report::Figure gap_figure(const Diagnosis& d) {
  report::Figure figure{
      .title = "The gap at each speed, before and after",
      .caption =
          "Mean squared residual in variances of the noise: 1 is nothing missing, the band "
          "holds nineteen in twenty such shots. A point a shot." +
          std::string(d.maps_the_law_alone()
                          ? " Points of the believed model are of the lumped law alone, without "
                            "what a body of finite size adds."
                          : ""),
      .x = {"approach speed", "m/s"},
      .y = {"reduced χ²", "1"}};
  Series noise = points_of("noise", Origin::derived);
  noise.style = Series::Style::line;
  noise.role = Series::Role::reference;
  const auto add = [&](const std::string& name, Origin origin, const Observations& shots,
                       const std::vector<ShotGap>& gaps) {
    Series series = points_of(name, origin);
    for (std::size_t i = 0; i < shots.shots.size() && i < gaps.size(); ++i) {
      if (gaps[i].rows == 0) continue;
      series.x.push_back(shots.shots[i].impact.speed);
      series.y.push_back(gaps[i].reduced_chi_square);
      noise.x.push_back(shots.shots[i].impact.speed);
      noise.y_high.push_back(1.0 + 1.96 * gaps[i].deviation());
    }
    if (!series.x.empty()) figure.series.push_back(std::move(series));
  };
  add(before_name, Origin::fitted, *d.seen, gaps_of_shots(d.believed.fit));
  if (d.extended()) add(after_name, Origin::fitted, *d.seen, gaps_of_shots(d.best()));
  if (d.unseen_before)
    add("unseen speed, " + std::string(before_name), Origin::predicted, *d.unseen,
        d.unseen_before->of_shots);
  if (d.unseen_after)
    add("unseen speed, " + std::string(after_name), Origin::predicted, *d.unseen,
        d.unseen_after->of_shots);
  if (const auto& fem = d.shots_in_fem) {
    const std::string alone = "FE with nothing hidden", with = "FE with " + fem->effect;
    add(alone, Origin::fitted, *d.seen, fem->before);
    add("unseen speed, " + alone, Origin::predicted, *d.unseen, fem->unseen_before);
    add(with, Origin::fitted, *d.seen, fem->after);
    add("unseen speed, " + with, Origin::predicted, *d.unseen, fem->unseen_after);
  }
  if (figure.series.empty()) return figure;
  space_by_decades_where_they_are_many(figure);
  const auto [slowest, fastest] = std::minmax_element(noise.x.begin(), noise.x.end());
  const double widest = *std::max_element(noise.y_high.begin(), noise.y_high.end());
  noise.x = {0.9 * *slowest, 1.05 * *fastest};
  noise.y = {1.0, 1.0};
  constexpr double least_of_decades = 0.05;  // a logarithm has no zero
  const double least =
      figure.y.spacing == report::Axis::Spacing::logarithmic ? least_of_decades : 0.0;
  noise.y_low.assign(2, std::max(least, 2.0 - widest));
  noise.y_high.assign(2, widest);
  figure.series.insert(figure.series.begin(), std::move(noise));
  return figure;
}

ShotFigures shot_figures(const Diagnosis& d) {
  ShotFigures figures;
  for (const DrawnShot& one : drawn_shots(d)) {
    report::Figure residuals =
        residual_figure(*one.shot, one.before, one.force_after(), one.origin);
    residuals.title = one.title("Residuals");
    figures.residuals.push_back(std::move(residuals));
    figures.histories.push_back(history_figure(one));
  }
  return figures;
}

}  // namespace rebound
