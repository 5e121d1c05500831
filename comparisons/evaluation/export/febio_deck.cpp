#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "comparisons/evaluation/export/deck_writers.hpp"
#include "comparisons/evaluation/export/sector.hpp"
#include "fem/interface/elastic_models.hpp"
#include "fem/interface/engineering_moduli.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr int slices = 4;  ///< bricks around a quarter of the ball

/// How its uncoupled laws write the energy of volume.
enum class PressureModel { logarithm = 0, squares_and_logarithm = 1, squares = 2 };

std::string value_line(const std::string& key, double value) {
  return fmt::format("<{0}>{1:.15g}</{0}>", key, value);
}

std::string uncoupled(const SolidCard& solid, PressureModel volume) {
  return value_line("k", solid.instantaneous.bulk) +
         fmt::format("<pressure_model>{}</pressure_model>", static_cast<int>(volume));
}

struct LawText {
  std::string type, parameters;
  bool is_uncoupled = false;
};

LawText law_of(const SolidCard& solid) {
  switch (solid.elastic) {
    case ElasticModel::neo_hookean:
      return {"neo-Hookean", value_line("E", fem::youngs_modulus(solid.instantaneous)) +
                                 value_line("v", fem::poisson_ratio(solid.instantaneous))};
    case ElasticModel::neo_hookean_isochoric:
      return {"Mooney-Rivlin",
              value_line("c1", solid.c10) + value_line("c2", 0.0) +
                  uncoupled(solid, PressureModel::squares),
              true};
    case ElasticModel::mooney_rivlin:
      return {"Mooney-Rivlin",
              value_line("c1", solid.c10) + value_line("c2", solid.c01) +
                  uncoupled(solid, PressureModel::squares_and_logarithm),
              true};
    case ElasticModel::ogden: {
      std::string text;
      for (std::size_t i = 0; i < solid.terms.size(); ++i)
        text += value_line(fmt::format("c{}", i + 1), 2.0 * solid.terms[i].shear) +
                value_line(fmt::format("m{}", i + 1), solid.terms[i].exponent);
      return {"Ogden", text + uncoupled(solid, PressureModel::squares_and_logarithm), true};
    }
    default:
      throw Error(ExitCode::bad_input, "FEBio has no such energy",
                  {.key = "model.material.elastic",
                   .value = name_of(solid.elastic),
                   .allowed = "any other than hyperfoam"});
  }
}

/// Coupled laws relax as a whole there, uncoupled ones their deviator alone.
void check_relaxation(const SolidCard& solid, const LawText& law) {
  for (const RelaxingShare& branch : solid.branches) {
    const bool all = branch.volume > 0.0;
    if (all != law.is_uncoupled) continue;
    const char* can = law.is_uncoupled ? "its deviator alone" : "all of its stress alone";
    throw Error(
        ExitCode::bad_input,
        fmt::format("FEBio relaxes {} of {}, and the deck would be another problem", can,
                    name_of(solid.elastic)),
        {.key = "model.material.branch.relaxes",
         .value = name_of(all ? Relaxes::all : Relaxes::deviator),
         .allowed = std::string("relaxes = \"") + name_of(all ? Relaxes::deviator : Relaxes::all) +
                    "\", or another elastic law"});
  }
  if (solid.branches.size() > 6)
    throw Error(ExitCode::bad_input, "FEBio has six Prony branches at most",
                {.key = "model.material.branch",
                 .value = std::to_string(solid.branches.size()),
                 .allowed = "six"});
}

std::string material_text(const SolidCard& solid, double density) {
  const LawText law = law_of(solid);
  check_relaxation(solid, law);
  const std::string dense = value_line("density", density);
  if (solid.branches.empty())
    return fmt::format("<material id=\"1\" name=\"ball\" type=\"{}\">{}{}</material>\n", law.type,
                       dense, law.parameters);
  // S = g0 Se + sum gi Hi with Se of the instantaneous moduli: the shares stand as they are.
  std::string text = fmt::format("<material id=\"1\" name=\"ball\" type=\"{}\">{}{}",
                                 law.is_uncoupled ? "uncoupled viscoelastic" : "viscoelastic",
                                 dense, value_line("g0", 1.0 - solid.relaxing_deviator()));
  for (std::size_t i = 0; i < solid.branches.size(); ++i)
    text += value_line(fmt::format("g{}", i + 1), solid.branches[i].deviator) +
            value_line(fmt::format("t{}", i + 1), solid.branches[i].relaxation_time);
  return text + fmt::format("<elastic type=\"{}\">{}{}</elastic></material>\n", law.type, dense,
                            law.parameters);
}

class FebioDeck {
 public:
  FebioDeck(const ImpactToExport& impact, const QuadraticSection& section)
      : impact_(impact),
        section_(section),
        sector_(sector_of(section, {.to = 0.5 * std::numbers::pi, .slices = slices})) {}

  DeckBody body() {
    text_ = "<febio_spec version=\"4.0\">\n<Module type=\"solid\"/>\n";
    write_control();
    text_ += "<Material>\n" +
             material_text(impact_.solid, impact_.problem.sphere.mass / section_.volume) +
             "<material id=\"2\" name=\"plate\" type=\"rigid body\"><density>1000</density>"
             "<center_of_mass>0,0,0</center_of_mass></material>\n</Material>\n";
    write_mesh();
    write_supports();
    write_output();
    return {.text = std::move(text_),
            .differences = {},
            .nodes = static_cast<int>(sector_.nodes.size()),
            .elements = static_cast<int>(sector_.bricks.size())};
  }

 private:
  void write_control() {
    const double step = 0.5 * impact_.interval;
    text_ += fmt::format(
        "<Control><analysis>DYNAMIC</analysis><time_steps>{}</time_steps>"
        "<step_size>{:.15g}</step_size><solver type=\"solid\"><rhoi>0.9</rhoi></solver>"
        "</Control>\n",
        static_cast<long>(std::ceil(impact_.end_time / step)), step);
  }

  void write_mesh() {
    text_ += "<Mesh>\n<Nodes name=\"ball\">\n";
    int node = 0;
    const auto write_node = [&](const std::array<double, 3>& p) {
      text_ +=
          fmt::format("<node id=\"{}\">{:.15g},{:.15g},{:.15g}</node>\n", ++node, p[0], p[1], p[2]);
    };
    for (const auto& p : sector_.nodes) write_node(p);
    text_ += "</Nodes>\n<Nodes name=\"plate\">\n";
    const double far = 1.5 * impact_.problem.sphere.radius(), near = -0.1 * far;
    for (const double z : {near, 0.0})
      for (const auto& [x, y] : {std::pair{near, near}, {far, near}, {far, far}, {near, far}})
        write_node({x, y, z});
    text_ += "</Nodes>\n<Elements type=\"hex20\" name=\"ball\">\n";
    int element = 0;
    for (const auto& brick : sector_.bricks) {
      text_ += fmt::format("<elem id=\"{}\">", ++element);
      for (int i = 0; i < 20; ++i) text_ += fmt::format("{}{}", i == 0 ? "" : ",", brick[i] + 1);
      text_ += "</elem>\n";
    }
    const int first = static_cast<int>(sector_.nodes.size());
    text_ += fmt::format("</Elements>\n<Elements type=\"hex8\" name=\"plate\">\n<elem id=\"{}\">",
                         ++element);
    for (int i = 1; i <= 8; ++i) text_ += fmt::format("{}{}", i == 1 ? "" : ",", first + i);
    text_ += "</elem>\n</Elements>\n";
    write_sets(first);
    text_ +=
        "</Mesh>\n<MeshDomains><SolidDomain name=\"ball\" mat=\"ball\"/>"
        "<SolidDomain name=\"plate\" mat=\"plate\"/></MeshDomains>\n";
  }

  void write_sets(int plate) {
    std::vector<int> all(plate);
    for (int i = 0; i < plate; ++i) all[i] = i;
    write_node_set("all", all, {});
    write_node_set("plane_x", sector_.last_plane, sector_.axis);   // x = 0
    write_node_set("plane_y", sector_.first_plane, sector_.axis);  // y = 0
    text_ += "<Surface name=\"ball_side\">\n";
    int face = 0;
    for (const auto& [brick, side] : sector_.contact_faces) {
      const auto& b = sector_.bricks[brick];
      const int next = (side + 1) % 4;  // outward: from the larger angle to the smaller
      const int nodes[8] = {b[side],      b[4 + side],  b[4 + next],  b[next],
                            b[16 + side], b[12 + side], b[16 + next], b[8 + side]};
      text_ += fmt::format("<quad8 id=\"{}\">", ++face);
      for (int i = 0; i < 8; ++i) text_ += fmt::format("{}{}", i == 0 ? "" : ",", nodes[i] + 1);
      text_ += "</quad8>\n";
    }
    text_ += fmt::format(
        "</Surface>\n<Surface name=\"plate_top\"><quad4 id=\"1\">{},{},{},{}</quad4></Surface>\n"
        "<SurfacePair name=\"touch\"><primary>ball_side</primary>"
        "<secondary>plate_top</secondary></SurfacePair>\n",
        plate + 5, plate + 6, plate + 7, plate + 8);
  }

  void write_node_set(const char* name, std::vector<int> nodes, const std::vector<int>& more) {
    nodes.insert(nodes.end(), more.begin(), more.end());
    std::sort(nodes.begin(), nodes.end());
    text_ += fmt::format("<NodeSet name=\"{}\">", name);
    for (std::size_t i = 0; i < nodes.size(); ++i)
      text_ += fmt::format("{}{}", i == 0 ? "" : ",", nodes[i] + 1);
    text_ += "</NodeSet>\n";
  }

  void write_supports() {
    text_ += fmt::format(
        "<Boundary>\n"
        "<bc type=\"zero displacement\" node_set=\"plane_x\"><x_dof>1</x_dof><y_dof>0</y_dof>"
        "<z_dof>0</z_dof></bc>\n"
        "<bc type=\"zero displacement\" node_set=\"plane_y\"><x_dof>0</x_dof><y_dof>1</y_dof>"
        "<z_dof>0</z_dof></bc>\n</Boundary>\n"
        "<Rigid><rigid_bc type=\"rigid_fixed\"><rb>plate</rb><Rx_dof>1</Rx_dof><Ry_dof>1</Ry_dof>"
        "<Rz_dof>1</Rz_dof><Ru_dof>1</Ru_dof><Rv_dof>1</Rv_dof><Rw_dof>1</Rw_dof></rigid_bc>"
        "</Rigid>\n"
        "<Initial><ic type=\"velocity\" node_set=\"all\"><value>0,0,{:.15g}</value></ic>"
        "</Initial>\n"
        "<Contact><contact type=\"sliding-elastic\" surface_pair=\"touch\">"
        "<laugon>PENALTY</laugon><auto_penalty>0</auto_penalty><penalty>{:.15g}</penalty>"
        "<two_pass>0</two_pass></contact></Contact>\n",
        -impact_.problem.impact.speed, impact_.penalty);
  }

  void write_output() {
    text_ +=
        "<Output>\n<!-- The force on the whole ball is -4 times Fz of the plate. -->\n"
        "<logfile><rigid_body_data data=\"Fz\" file=\"force.txt\">2</rigid_body_data></logfile>\n"
        "<plotfile type=\"febio\"><var type=\"displacement\"/><var type=\"stress\"/>"
        "<var type=\"contact pressure\"/></plotfile>\n</Output>\n</febio_spec>\n";
  }

  const ImpactToExport& impact_;
  const QuadraticSection& section_;
  Sector sector_;
  std::string text_;
};

}  // namespace

DeckBody febio_deck(const ImpactToExport& impact) {
  const QuadraticSection section = quadratic_section(impact.mesh, impact.problem.sphere.radius());
  return FebioDeck(impact, section).body();
}

}  // namespace rebound
