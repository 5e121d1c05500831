#include "tests/unit/comparisons/io/report/demo_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/unit/comparisons/io/report/demo_blocks.hpp"

namespace rebound::report_tests {
namespace {

using namespace report;

struct Ball {
  std::string name;
  double mass;       ///< [kg]
  double frequency;  ///< undamped, ω₀ [1/s]
};

struct Law {
  std::string name;
  Origin origin;
  double damping_ratio;
};

/// Half of the relative width of the made-up reference's band.
constexpr double reference_band = 0.04;
constexpr double reference_damping = 0.17;

struct Curves {
  std::vector<double> time_ms, deflection_mm, force_kN;
};

double restitution(double damping_ratio) {
  const double root = std::sqrt(1.0 - damping_ratio * damping_ratio);
  return std::exp(-damping_ratio * std::numbers::pi / root);
}

Curves kelvin_voigt(const Ball& ball, double speed, double damping_ratio) {
  constexpr int samples = 160;
  const double decay = damping_ratio * ball.frequency;
  const double damped = ball.frequency * std::sqrt(1.0 - damping_ratio * damping_ratio);
  Curves curves;
  for (int i = 0; i <= samples; ++i) {
    const double t = std::numbers::pi / damped * i / samples;
    const double envelope = std::exp(-decay * t);
    const double x = speed / damped * envelope * std::sin(damped * t);
    const double v =
        speed * envelope * (std::cos(damped * t) - decay / damped * std::sin(damped * t));
    const double f = ball.mass * (ball.frequency * ball.frequency * x + 2.0 * decay * v);
    curves.time_ms.push_back(1e3 * t);
    curves.deflection_mm.push_back(1e3 * x);
    curves.force_kN.push_back(1e-3 * f);
  }
  return curves;
}

Series series_of(const Law& law, const std::vector<double>& x, const std::vector<double>& y) {
  Series series;
  series.name = law.name;
  series.origin = law.origin;
  series.x = x;
  series.y = y;
  return series;
}

Series reference_of(const std::vector<double>& x, const std::vector<double>& y) {
  Series series = series_of({"made-up reference", Origin::predicted, 0.0}, x, y);
  series.role = Series::Role::reference;
  for (const double value : y) {
    series.y_low.push_back(value - reference_band * std::abs(value));
    series.y_high.push_back(value + reference_band * std::abs(value));
  }
  return series;
}

Series peak_point(const Curves& curves) {
  const auto peak = std::max_element(curves.deflection_mm.begin(), curves.deflection_mm.end());
  Series series;
  series.name = "made-up reading";
  series.origin = Origin::measured;
  series.style = Series::Style::points;
  series.x = {curves.time_ms[static_cast<std::size_t>(peak - curves.deflection_mm.begin())]};
  series.y = {*peak};
  series.x_error = {0.05 * series.x[0]};
  series.y_error = {0.06 * series.y[0]};
  return series;
}

std::vector<Law> laws() {
  return {{"linear spring", Origin::predicted, 0.0},
          {"Kelvin–Voigt, ζ = 0.1", Origin::predicted, 0.1},
          {"Kelvin–Voigt, ζ = 0.2", Origin::fitted, 0.2}};
}

Overlay overlay_of(const Ball& ball, double speed) {
  const Curves truth = kelvin_voigt(ball, speed, reference_damping);
  Overlay overlay;
  overlay.key = ball.name + fmt::format("/{:g}", speed);
  overlay.title = ball.name + fmt::format(" at {:g} m/s", speed);
  overlay.note = "TEST DATA. The band is 4 % of the value.";
  Figure force{.title = "Force over deflection",
               .caption = "",
               .x = {"deflection", "mm"},
               .y = {"force", "kN"}};
  Figure motion{.title = "Deflection over time",
                .caption = "",
                .x = {"time", "ms"},
                .y = {"deflection", "mm"}};
  for (const Law& law : laws()) {
    const Curves curves = kelvin_voigt(ball, speed, law.damping_ratio);
    force.series.push_back(series_of(law, curves.deflection_mm, curves.force_kN));
    motion.series.push_back(series_of(law, curves.time_ms, curves.deflection_mm));
  }
  force.series.push_back(reference_of(truth.deflection_mm, truth.force_kN));
  motion.series.push_back(reference_of(truth.time_ms, truth.deflection_mm));
  motion.series.push_back(peak_point(truth));
  overlay.figures = {force, motion};
  Table scalars{.title = "Restitution", .caption = "", .columns = {{"law"}}, .rows = {}};
  scalars.columns.push_back({"restitution", "1", TableColumn::Kind::number, Origin::predicted});
  scalars.columns.push_back({"reference", "1", TableColumn::Kind::number, Origin::predicted});
  for (const Law& law : laws()) {
    scalars.rows.push_back({text_cell(law.name), number_cell(restitution(law.damping_ratio), 3),
                            uncertain_cell(restitution(reference_damping), 0.012)});
  }
  overlay.tables = {scalars};
  return overlay;
}

MatrixCell cell_of(const Ball& ball, double speed, const Law& law) {
  // A made-up trend with speed, so that the cells differ.
  const double reference = restitution(reference_damping) - 0.004 * (speed - 15.0);
  const double difference = 100.0 * (restitution(law.damping_ratio) / reference - 1.0);
  return {.value = difference,
          .text = fmt::format("{:+.1f}", difference),
          .hatched = std::abs(difference) < 5.0,
          .overlay = ball.name + fmt::format("/{:g}", speed),
          .highlight = law.name};
}

Matrix matrix_of(const std::vector<Ball>& balls, const std::vector<double>& speeds) {
  Matrix matrix;
  matrix.title = "Difference of the restitution from the reference";
  matrix.caption = "TEST DATA. A cell shows its overlay below.";
  matrix.quantity = "restitution against the reference";
  matrix.unit = "%";
  matrix.row_heading = "law";
  matrix.hatching = "smaller than the reference's own uncertainty";
  matrix.scale = {ColourScale::Kind::diverging, 50.0};
  matrix.overlays = "pairs";
  for (const Ball& ball : balls) {
    for (const double speed : speeds)
      matrix.columns.push_back({ball.name, fmt::format("{:g} m/s", speed)});
  }
  for (const Law& law : laws()) {
    MatrixRow row{.name = law.name, .cells = {}};
    for (const Ball& ball : balls) {
      for (const double speed : speeds) row.cells.push_back(cell_of(ball, speed, law));
    }
    matrix.rows.push_back(row);
  }
  matrix.rows.back().cells.back() = {
      .value = std::nullopt, .text = "not run", .hatched = false, .overlay = "", .highlight = ""};
  return matrix;
}

Figure convergence() {
  Figure figure{.title = "Convergence of a made-up error",
                .caption = "Slope 2 by construction.",
                .x = {"cell size", "mm", Axis::Spacing::logarithmic},
                .y = {"relative error", "1", Axis::Spacing::logarithmic}};
  Series error;
  error.name = "made-up error";
  error.style = Series::Style::points;
  for (const double h : {0.25, 0.5, 1.0, 2.0}) {
    error.x.push_back(h);
    error.y.push_back(1e-3 * h * h);
  }
  Series slope = error;
  slope.name = "slope 2";
  slope.style = Series::Style::line;
  slope.origin = Origin::derived;
  figure.series = {error, slope};
  return figure;
}

}  // namespace

Report demo_report(const std::string& ball_name) {
  const std::vector<Ball> balls{{ball_name, 0.09, 1600.0}, {"ball Q", 0.1, 1400.0}};
  const std::vector<double> speeds{5.0, 15.0, 25.0};
  Overlays overlays{.id = "pairs", .chosen = ball_name + "/15", .items = {}};
  for (const Ball& ball : balls) {
    for (const double speed : speeds) overlays.items.push_back(overlay_of(ball, speed));
  }
  Report report;
  report.title = "TEST DATA: a report of made-up balls";
  report.subtitle = "Closed-form Kelvin–Voigt impacts; nothing here was measured or simulated.";
  report.headline =
      "For " + ball_name +
      " at 15 m/s a linear spring returns 1.00 of the speed where the "
      "made-up reference returns 0.58; damping with ζ = 0.2 closes all but 0.05 of it.";
  report.notices = {{Notice::Level::warning, "Every number on this page is test data."}};
  report.sections = {
      {"Laws against the reference", Section::Folding::open, {matrix_of(balls, speeds)}},
      {"The chosen cell", Section::Folding::open, {overlays}},
      {"Checks that were not fitted",
       Section::Folding::open,
       {checks_table(), wide_table(),
        Notice{Notice::Level::failure, "The mean deflection is 20 % low.",
               "Measured 3.1 mm, made-up reference 2.5 mm."},
        Notice{Notice::Level::abstention, "The residual deflection does not tell the laws apart."}},
       {linked_table()}},
      {"Credibility", Section::Folding::open, {convergence(), squeezed_disc()}},
      {"Provenance",
       Section::Folding::folded,
       {Paragraph{"Made by the tests."}, Verbatim{"Command", "write_demo_report " + ball_name}}}};
  return report;
}

}  // namespace rebound::report_tests
