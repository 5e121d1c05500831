#include <fmt/format.h>

#include <cmath>

#include "comparisons/accuracy/verification/mesh_family.hpp"
#include "comparisons/accuracy/verification/refinement.hpp"

namespace rebound {
namespace {

using report::Axis;
using report::Figure;
using report::Series;

Axis cells_axis() {
  return {"cells", "1", Axis::Spacing::logarithmic};
}

/// A line through `at` of the given power, over the cells of the family.
Series guide(const std::vector<FamilyImpact>& family, const std::string& name, double power,
             double at_last) {
  Series line{.name = name, .role = Series::Role::reference};
  const double last = family.back().result.cells;
  for (const FamilyImpact& member : family) {
    line.x.push_back(member.result.cells);
    line.y.push_back(at_last * std::pow(member.result.cells / last, power));
  }
  return line;
}

template <class Value>
Series points(const std::vector<FamilyImpact>& family, const std::string& name,
              const Value& value) {
  Series series{.name = name, .style = Series::Style::points};
  for (const FamilyImpact& member : family) {
    const double y = value(member);
    if (!(y > 0.0)) continue;
    series.x.push_back(member.result.cells);
    series.y.push_back(y);
  }
  return series;
}

Figure convergence(const std::vector<FamilyImpact>& family) {
  const FemResult& finest = family.back().result;
  const auto error_of = [&](double ImpactScalars::*scalar) {
    return [&, scalar](const FamilyImpact& member) {
      return std::abs(member.result.scalars.*scalar / (finest.scalars.*scalar) - 1.0);
    };
  };
  Figure figure{
      .title = "Convergence at 15 m/s",
      .caption = fmt::format("Deviation from {} cells. Second order in the cell size falls "
                             "with the line.",
                             finest.cells),
      .x = cells_axis(),
      .y = {"relative deviation", "1", Axis::Spacing::logarithmic}};
  figure.series = {
      points(family, "restitution", error_of(&ImpactScalars::restitution)),
      points(family, "largest deflection", error_of(&ImpactScalars::peak_deflection)),
      points(family, "contact time above 1 %", error_of(&ImpactScalars::contact_time_1pct)),
      points(family, "largest force", error_of(&ImpactScalars::peak_force))};
  const double start = figure.series.front().y.empty() ? 1e-3 : figure.series.front().y.front();
  const double falls = start * family.front().result.cells / finest.cells;
  figure.series.push_back(guide(family, "second order", -1.0, falls));
  return figure;
}

Figure constraint_work(const std::vector<FamilyImpact>& family) {
  return refinement_figure(
      {.title = "Constraint work at 15 m/s",
       .caption =
           "Energy lost by nodes caught by the plate over the kinetic energy: an error of the "
           "first order in the cell. The bound of 3e-3 is met from about 500 cells.",
       .size = {"mean cell size", "m"},
       .error = {"constraint work over kinetic energy", "1"}},
      {constraint_refinement(family)});
}

Figure ripple(const std::vector<FamilyImpact>& family) {
  return {.title = "Ripple of the force at 15 m/s",
          .caption =
              "Largest deviation of the 20 µs mean from that on four times the cells, over 5 to "
              "95 % of the contact. The line is the 0.5 % that is asked for at 4000 cells.",
          .x = cells_axis(),
          .y = {"deviation over peak force", "1", Axis::Spacing::logarithmic},
          .series = {points(family, "ripple",
                            [](const FamilyImpact& member) { return member.ripple.value_or(0.0); }),
                     guide(family, "asked for", 0.0, 5e-3)}};
}

Figure cost(const std::vector<FamilyImpact>& family) {
  Figure figure = refinement_figure(
      {.title = "Cost of one impact",
       .caption =
           "Processor time of set-up and steps, one thread, samples every microsecond, on this "
           "machine. Asked for: no worse than cells to the power of 1.6.",
       .size = {"cells", "1"},
       .error = {"processor time", "s"},
       .origin = report::Origin::measured},
      {cost_growth(family)});
  figure.series.push_back(guide(family, "cells^1.6", 1.6, family.back().processor_seconds));
  return figure;
}

}  // namespace

std::vector<report::Figure> figures_of(const std::vector<FamilyImpact>& family) {
  return {convergence(family), constraint_work(family), ripple(family), cost(family)};
}

}  // namespace rebound
