#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "comparisons/evaluation/export/deck_writers.hpp"
#include "comparisons/evaluation/export/keyword_lines.hpp"
#include "comparisons/evaluation/export/sector.hpp"
#include "fem/interface/elastic_models.hpp"

namespace rebound {
namespace {

constexpr double wedge = 2.0;  ///< angle of the ball's part [degrees]
constexpr double half_angle = wedge * std::numbers::pi / 360.0;

class CalculixDeck {
 public:
  CalculixDeck(const ImpactToExport& impact, const QuadraticSection& section)
      : impact_(impact),
        section_(section),
        sector_(sector_of(section, {.from = -half_angle, .to = half_angle})) {}

  DeckBody body() {
    write_mesh();
    write_plate();
    write_contact();
    write_material();
    write_supports();
    write_step();
    return {.text = std::move(text_),
            .differences = std::move(differences_),
            .nodes = node_count(),
            .elements = brick_count()};
  }

 private:
  int node_count() const { return static_cast<int>(sector_.nodes.size()); }
  int brick_count() const { return static_cast<int>(sector_.bricks.size()); }

  /// Fields end after twenty characters there, whatever they hold: twelve digits fit with sign and
  /// exponent.
  void write_mesh() {
    text_ += "*NODE, NSET=BALL\n";
    for (int i = 0; i < node_count(); ++i) {
      const auto& p = sector_.nodes[i];
      text_ += fmt::format("{}, {:.12g}, {:.12g}, {:.12g}\n", i + 1, p[0], p[1], p[2]);
    }
    text_ += "*ELEMENT, TYPE=C3D20R, ELSET=BALL\n";
    for (int e = 0; e < brick_count(); ++e) {
      text_ += std::to_string(e + 1);
      for (int i = 0; i < 20; ++i)  // sixteen numbers a line
        text_ += fmt::format(",{}{}", i == 15 ? "\n" : " ", sector_.bricks[e][i] + 1);
      text_ += "\n";
    }
  }

  /// One brick under the wedge, wider than the ball.
  void write_plate() {
    const double across = 1.5 * impact_.problem.sphere.radius(), deep = 0.1 * across;
    const double half = across * std::tan(half_angle) + deep;
    text_ += "*NODE, NSET=PLATE\n";
    int node = node_count();
    for (const double z : {-deep, 0.0})
      for (const auto& [x, y] :
           {std::pair{-deep, -half}, {across, -half}, {across, half}, {-deep, half}})
        text_ += fmt::format("{}, {:.12g}, {:.12g}, {:.12g}\n", ++node, x, y, z);
    text_ += fmt::format("*ELEMENT, TYPE=C3D8, ELSET=PLATE\n{}", brick_count() + 1);
    for (int i = 1; i <= 8; ++i) text_ += fmt::format(", {}", node_count() + i);
    text_ += "\n";
  }

  void write_contact() {
    text_ += "*SURFACE, NAME=BALL_SIDE, TYPE=ELEMENT\n";
    for (const auto& [brick, side] : sector_.contact_faces)
      text_ += fmt::format("{}, S{}\n", brick + 1, side + 3);
    text_ += fmt::format("*SURFACE, NAME=PLATE_TOP, TYPE=ELEMENT\n{}, S2\n", brick_count() + 1);
    text_ += fmt::format(
        "*SURFACE INTERACTION, NAME=TOUCH\n"
        "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n{:.12g}\n"
        "*CONTACT PAIR, INTERACTION=TOUCH, TYPE=SURFACE TO SURFACE\nBALL_SIDE, PLATE_TOP\n",
        impact_.penalty);
  }

  void write_material() {
    text_ += "*MATERIAL, NAME=BALL\n" + hyperelastic_lines(impact_.solid, "", differences_);
    text_ += fmt::format("*DENSITY\n{:.12g}\n", impact_.problem.sphere.mass / section_.volume);
    text_ +=
        "*SOLID SECTION, ELSET=BALL, MATERIAL=BALL\n"
        "*MATERIAL, NAME=PLATE\n*ELASTIC\n1e12, 0.3\n*DENSITY\n1000\n"
        "*SOLID SECTION, ELSET=PLATE, MATERIAL=PLATE\n";
  }

  void write_supports() {
    text_ += "*NSET, NSET=AXIS\n" + number_lines(sector_.axis);
    text_ += "*NSET, NSET=SIDES\n" + number_lines(sector_.first_plane) +
             number_lines(sector_.last_plane);
    text_ +=
        "** No motion around the axis z on the sides of the wedge.\n"
        "*TRANSFORM, NSET=SIDES, TYPE=C\n0, 0, 0, 0, 0, 1\n"
        "*BOUNDARY\nSIDES, 2, 2\nAXIS, 1, 2\nPLATE, 1, 3\n";
    text_ += fmt::format("*INITIAL CONDITIONS, TYPE=VELOCITY\nBALL, 3, {:.12g}\n",
                         -impact_.problem.impact.speed);
  }

  /// Laws of principal stretches leave rounding in a ball that flies free, which no iteration
  /// takes below a share of forces that are not there yet: a share of the mean contact force.
  std::string controls() const {
    if (!has_terms(impact_.solid.elastic)) return "";
    const FemProblem& problem = impact_.problem;
    const double force = 2.0 * problem.sphere.mass * problem.impact.speed / impact_.end_time;
    return fmt::format("*CONTROLS, PARAMETERS=FIELD\n0.005, 0.01, , {:.6g}\n",
                       force * wedge / 360.0 / node_count());
  }

  void write_step() {
    const double step = 0.5 * impact_.interval;
    const FemProblem& problem = impact_.problem;
    text_ += fmt::format(
        "*STEP, NLGEOM, INC={}\n** A fixed step, half the output's.\n{}"
        "*DYNAMIC, DIRECT\n{:.12g}, {:.12g}\n",
        10 + static_cast<long>(std::ceil(impact_.end_time / step)), controls(), step,
        impact_.end_time);
    if (problem.gravity > 0.0)
      text_ += fmt::format("*DLOAD\nBALL, GRAV, {:.12g}, 0, 0, -1\n", problem.gravity);
    text_ += fmt::format(
        "** The force on the whole plate is {:.12g} times the sum over its nodes.\n"
        "*NODE PRINT, NSET=PLATE, TOTALS=ONLY, FREQUENCY=1\nRF\n"
        "*END STEP\n",
        360.0 / wedge);
  }

  const ImpactToExport& impact_;
  const QuadraticSection& section_;
  Sector sector_;
  std::string text_;
  std::vector<std::string> differences_;
};

}  // namespace

DeckBody calculix_deck(const ImpactToExport& impact) {
  const QuadraticSection section = quadratic_section(impact.mesh, impact.problem.sphere.radius());
  return CalculixDeck(impact, section).body();
}

}  // namespace rebound
