#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "comparisons/evaluation/export/deck_writers.hpp"
#include "comparisons/evaluation/export/keyword_lines.hpp"
#include "fem/interface/elastic_models.hpp"
#include "lumped/problem/error.hpp"
#include "meshes/quality/mesh_quality.hpp"

namespace rebound {
namespace {

/// Shares of the instantaneous moduli; foams have one relaxation of all the stress there.
std::string prony_lines(const SolidCard& solid) {
  std::string text = "*VISCOELASTIC, TIME=PRONY\n";
  for (const RelaxingShare& branch : solid.branches) {
    if (solid.elastic == ElasticModel::hyperfoam && branch.volume != branch.deviator)
      throw Error(
          ExitCode::bad_input,
          "a foam relaxes as a whole in Abaqus: the deck would lose that the deviator alone "
          "relaxes",
          {.key = "model.material.branch.relaxes",
           .value = name_of(Relaxes::deviator),
           .allowed = name_of(Relaxes::all)});
    text += fmt::format("{:.12g}, {:.12g}, {:.12g}\n", branch.deviator, branch.volume,
                        branch.relaxation_time);
  }
  return text;
}

class AbaqusDeck {
 public:
  explicit AbaqusDeck(const ImpactToExport& impact) : impact_(impact) {}

  DeckBody body() {
    write_mesh();
    write_plate();
    write_material();
    write_supports();
    write_step();
    return {.text = std::move(text_),
            .differences = std::move(differences_),
            .nodes = node_count(),
            .elements = static_cast<int>(mesh().cells.size())};
  }

 private:
  const Mesh& mesh() const { return impact_.mesh; }
  int node_count() const { return static_cast<int>(mesh().vertices.size()); }
  int plate_node() const { return node_count() + 1; }

  void write_mesh() {
    text_ += "*NODE, NSET=BALL\n";
    for (int i = 0; i < node_count(); ++i)
      text_ += fmt::format("{}, {:.12g}, {:.12g}\n", i + 1, mesh().vertices[i][0],
                           mesh().vertices[i][1]);
    text_ += "*ELEMENT, TYPE=CAX4R, ELSET=BALL\n";
    int element = 0;
    for (const auto& cell : mesh().cells)
      text_ += fmt::format("{}, {}, {}, {}, {}\n", ++element, cell[0] + 1, cell[1] + 1, cell[2] + 1,
                           cell[3] + 1);
    std::set<int> axis;
    for (const auto& edge : mesh().axis_edges) axis.insert(edge.begin(), edge.end());
    text_ += "*NSET, NSET=AXIS\n" + number_lines({axis.begin(), axis.end()});
  }

  void write_plate() {
    const double far = 3.0 * impact_.problem.sphere.radius();
    text_ += fmt::format("*NODE, NSET=PLATE\n{}, 0, 0\n*NODE\n{}, {:.12g}, 0\n", plate_node(),
                         plate_node() + 1, far);
    text_ += "*SURFACE, TYPE=ELEMENT, NAME=BALL_SIDE\n";
    std::set<std::pair<int, int>> contact;
    for (const auto& edge : mesh().contact_edges) contact.insert(std::minmax(edge[0], edge[1]));
    for (std::size_t e = 0; e < mesh().cells.size(); ++e)
      for (int i = 0; i < 4; ++i)
        if (contact.contains(std::minmax(mesh().cells[e][i], mesh().cells[e][(i + 1) % 4])))
          text_ += fmt::format("{}, S{}\n", e + 1, i + 1);
    // The positive side of a rigid segment is to the left on the way from its first node.
    text_ += fmt::format(
        "*ELEMENT, TYPE=RAX2, ELSET=PLATE\n{0}, {1}, {2}\n"
        "*SURFACE, TYPE=ELEMENT, NAME=PLATE_TOP\nPLATE, SPOS\n"
        "*RIGID BODY, ELSET=PLATE, REF NODE={1}\n",
        mesh().cells.size() + 1, plate_node(), plate_node() + 1);
    text_ += "*SURFACE INTERACTION, NAME=TOUCH\n";
    if (impact_.problem.plate.friction > 0.0)
      text_ += fmt::format("*FRICTION\n{:.12g}\n", impact_.problem.plate.friction);
  }

  void write_material() {
    const bool relaxes = !impact_.solid.branches.empty();
    text_ +=
        "*MATERIAL, NAME=BALL\n" +
        hyperelastic_lines(impact_.solid, relaxes ? ", MODULI=INSTANTANEOUS" : "", differences_);
    if (relaxes) {
      text_ += prony_lines(impact_.solid);
      differences_.push_back(
          "the Prony series acts on the Kirchhoff stress in the turning frame of the point, here "
          "on the second Piola-Kirchhoff stress: alike at small strain");
    }
    const double density = impact_.problem.sphere.mass / measure_quality(mesh()).volume;
    text_ += fmt::format(
        "*DENSITY\n{:.12g}\n*SECTION CONTROLS, NAME=CONTROLS, HOURGLASS=ENHANCED\n"
        "*SOLID SECTION, ELSET=BALL, MATERIAL=BALL, CONTROLS=CONTROLS\n",
        density);
  }

  void write_supports() {
    text_ += fmt::format(
        "*BOUNDARY\nAXIS, 1, 1\n{0}, 1, 2\n{0}, 6, 6\n"
        "*INITIAL CONDITIONS, TYPE=VELOCITY\nBALL, 2, {1:.12g}\n",
        plate_node(), -impact_.problem.impact.speed);
  }

  void write_step() {
    text_ += fmt::format(
        "*STEP, NLGEOM=YES\n*DYNAMIC, EXPLICIT\n, {:.12g}\n*BULK VISCOSITY\n0, 0\n"
        "*CONTACT PAIR, INTERACTION=TOUCH, MECHANICAL CONSTRAINT=KINEMATIC\nBALL_SIDE, PLATE_TOP\n",
        impact_.end_time);
    if (impact_.problem.gravity > 0.0)
      text_ += fmt::format("*DLOAD\nBALL, GRAV, {:.12g}, 0, -1\n", impact_.problem.gravity);
    text_ += fmt::format(
        "*OUTPUT, HISTORY, TIME INTERVAL={:.12g}\n"
        "** RF2 of the plate is the contact force of the whole ball.\n"
        "*NODE OUTPUT, NSET=PLATE\nRF2\n*ENERGY OUTPUT\nALLKE, ALLSE, ALLCD, ALLAE, ETOTAL\n"
        "*OUTPUT, FIELD, NUMBER INTERVAL=20\n*NODE OUTPUT\nU, V\n*ELEMENT OUTPUT\nS, LE\n"
        "*END STEP\n",
        impact_.interval);
  }

  const ImpactToExport& impact_;
  std::string text_;
  std::vector<std::string> differences_;
};

}  // namespace

DeckBody abaqus_deck(const ImpactToExport& impact) {
  return AbaqusDeck(impact).body();
}

}  // namespace rebound
