#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <set>

#include "comparisons/evaluation/export/deck_writers.hpp"
#include "comparisons/evaluation/export/sector.hpp"
#include "fem/interface/elastic_models.hpp"
#include "fem/interface/engineering_moduli.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

/// Bricks around a quarter of the ball.
constexpr int bricks_around = 6;

/// Fields of ten characters, as its cards have them.
std::string card(const std::vector<double>& values) {
  std::string line;
  for (const double value : values) {
    std::string field;
    for (int digits = 9; digits > 2 && (field.empty() || field.size() > 9); --digits)
      field = fmt::format("{:.{}g}", value, digits);
    line += fmt::format("{:>10}", field);
  }
  return line + "\n";
}

class LsDynaDeck {
 public:
  LsDynaDeck(const ImpactToExport& impact, const QuadraticSection& section)
      : impact_(impact),
        section_(section),
        sector_(sector_of(section, {.to = 0.5 * std::numbers::pi, .slices = bricks_around})) {}

  DeckBody body() {
    number_corners();
    text_ = "*KEYWORD\n*TITLE\nimpact of a ball on a rigid wall, a quarter of it\n";
    write_control();
    write_material();
    write_mesh();
    write_supports();
    return {.text = std::move(text_),
            .differences = std::move(differences_),
            .nodes = static_cast<int>(corners_.size()),
            .elements = static_cast<int>(sector_.bricks.size())};
  }

 private:
  /// Its bricks have eight nodes: those in the middle of sides are left out.
  void number_corners() {
    number_.assign(sector_.nodes.size(), 0);
    for (const auto& brick : sector_.bricks)
      for (int i = 0; i < 8; ++i)
        if (number_[brick[i]] == 0) {
          corners_.push_back(brick[i]);
          number_[brick[i]] = static_cast<int>(corners_.size());
        }
  }

  void write_control() {
    text_ += "*CONTROL_TERMINATION\n" + card({impact_.end_time}) + "*CONTROL_TIMESTEP\n" +
             card({0.0, 0.9}) + "*CONTROL_ENERGY\n" + card({2, 2, 2, 2}) + "*CONTROL_SOLID\n" +
             card({1}) +
             "$ No bulk viscosity; zero would stand for its default.\n*CONTROL_BULK_VISCOSITY\n" +
             card({1e-20, 1e-20}) +
             "$ The force on the whole ball is 4 times the normal force of the wall.\n" +
             "*DATABASE_RWFORC\n" + card({impact_.interval}) + "*DATABASE_GLSTAT\n" +
             card({impact_.interval}) + "*DATABASE_MATSUM\n" + card({impact_.interval}) +
             "*DATABASE_BINARY_D3PLOT\n" + card({impact_.end_time / 20.0});
  }

  void write_material() {
    const SolidCard& solid = impact_.solid;
    const double density = impact_.problem.sphere.mass / section_.volume;
    const double stays = 1.0 - solid.relaxing_deviator();
    const std::vector<double> head = {1, density, fem::poisson_ratio(solid.long_term), 0,
                                      static_cast<double>(solid.branches.size())};
    text_ += "*PART\nball\n" + card({1, 1, 1}) + "*SECTION_SOLID\n" + card({1, 2});
    if (solid.elastic == ElasticModel::ogden) {
      std::vector<double> moduli(8, 0.0), exponents(8, 0.0);
      for (std::size_t i = 0; i < solid.terms.size(); ++i) {
        moduli[i] = 2.0 * stays * solid.terms[i].shear / solid.terms[i].exponent;
        exponents[i] = solid.terms[i].exponent;
      }
      text_ += "*MAT_OGDEN_RUBBER\n" + card(head) + card(moduli) + card(exponents);
    } else if (solid.elastic == ElasticModel::hyperfoam) {
      throw Error(ExitCode::bad_input, "this deck has no such energy for LS-DYNA",
                  {.key = "model.material.elastic",
                   .value = name_of(solid.elastic),
                   .allowed = "any other than hyperfoam"});
    } else {
      text_ += "*MAT_HYPERELASTIC_RUBBER\n" + card(head) +
               card({stays * solid.c10, stays * solid.c01, 0, 0, 0, 0});
    }
    differences_.push_back(
        "the energy of volume is the code's own, with the bulk modulus that the Poisson ratio of "
        "the card gives");
    if (solid.elastic == ElasticModel::neo_hookean)
      differences_.push_back("neo-hookean is written as its isochoric form");
    write_branches();
  }

  void write_branches() {
    const SolidCard& solid = impact_.solid;
    if (solid.branches.empty()) return;
    differences_.push_back(
        "the Prony series is added to the long-term law as stress linear in the Green strain, here "
        "it acts on the stress of the law: alike at small strain");
    for (const RelaxingShare& branch : solid.branches) {
      if (branch.volume > 0.0)
        throw Error(ExitCode::bad_input,
                    "a rubber of LS-DYNA relaxes its deviator alone: the deck would lose that all "
                    "of the stress relaxes",
                    {.key = "model.material.branch.relaxes",
                     .value = name_of(Relaxes::all),
                     .allowed = name_of(Relaxes::deviator)});
      text_ += card({branch.deviator * solid.instantaneous.shear, 1.0 / branch.relaxation_time});
    }
  }

  void write_mesh() {
    text_ += "*NODE\n";
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const auto& p = sector_.nodes[corners_[i]];
      text_ += fmt::format("{:>8}{:>16.9e}{:>16.9e}{:>16.9e}{:>8}{:>8}\n", i + 1, p[0], p[1], p[2],
                           0, 0);
    }
    text_ += "*ELEMENT_SOLID\n";
    int element = 0;
    for (const auto& brick : sector_.bricks) {
      text_ += fmt::format("{:>8}{:>8}", ++element, 1);
      for (const int node : ordered(brick)) text_ += fmt::format("{:>8}", number_[node]);
      text_ += "\n";
    }
  }

  /// Eight nodes; where a side has shrunk to the axis, as its pentahedra are written: a face of
  /// four, then each node of the axis twice.
  static std::array<int, 8> ordered(const std::array<int, 20>& b) {
    for (int i = 0; i < 4; ++i) {
      const int next = (i + 1) % 4, after = (i + 2) % 4, last = (i + 3) % 4;
      if (b[i] != b[4 + i] || b[next] != b[4 + next]) continue;
      return {b[4 + last], b[last], b[after], b[4 + after], b[i], b[i], b[next], b[next]};
    }
    return {b[0], b[1], b[2], b[3], b[4], b[5], b[6], b[7]};
  }

  void write_set(int id, const std::vector<int>& nodes) {
    text_ += fmt::format("*SET_NODE_LIST\n{:>10}\n", id);
    int column = 0;
    for (const int node : nodes) {
      if (number_[node] == 0) continue;
      text_ += fmt::format("{:>10}", number_[node]);
      if (++column % 8 == 0) text_ += "\n";
    }
    if (column % 8 != 0) text_ += "\n";
  }

  void write_supports() {
    const FemProblem& problem = impact_.problem;
    if (problem.plate.friction >= 1.0)
      throw Error(ExitCode::bad_input,
                  "a wall of LS-DYNA with a friction of 1 lets nothing slide: the deck would be "
                  "another problem",
                  {.key = "model.plate.friction",
                   .value = number_text(problem.plate.friction),
                   .allowed = "below 1"});
    write_set(1, sector_.last_plane);   // x = 0
    write_set(2, sector_.first_plane);  // y = 0
    write_set(3, sector_.axis);
    text_ += "*BOUNDARY_SPC_SET\n" + card({1, 0, 1, 0, 0}) + "*BOUNDARY_SPC_SET\n" +
             card({2, 0, 0, 1, 0}) + "*BOUNDARY_SPC_SET\n" + card({3, 0, 1, 1, 0}) +
             "*INITIAL_VELOCITY\n" + card({0, 0, 0}) + card({0, 0, -problem.impact.speed}) +
             "*RIGIDWALL_PLANAR\n" + card({0, 0, 0, 0, 0, 1e20, 0}) +
             card({0, 0, 0, 0, 0, 1, problem.plate.friction, 0});
    if (problem.gravity > 0.0)
      text_ += "*DEFINE_CURVE\n" + card({1}) + fmt::format("{:>20}{:>20}\n", 0.0, 1.0) +
               fmt::format("{:>20}{:>20}\n", 1e3, 1.0) +
               "$ The acceleration of the frame: the ball is drawn the other way.\n" +
               "*LOAD_BODY_Z\n" + card({1, problem.gravity});
    text_ += "*END\n";
  }

  const ImpactToExport& impact_;
  const QuadraticSection& section_;
  Sector sector_;
  std::vector<int> corners_, number_;
  std::string text_;
  std::vector<std::string> differences_;
};

}  // namespace

DeckBody lsdyna_deck(const ImpactToExport& impact) {
  const QuadraticSection section = quadratic_section(impact.mesh, impact.problem.sphere.radius());
  return LsDynaDeck(impact, section).body();
}

}  // namespace rebound
