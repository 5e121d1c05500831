#include "tests/verification/calculix/calculix_run.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <numbers>
#include <regex>
#include <sstream>
#include <stdexcept>

#include "tests/verification/calculix/quarter_disc.hpp"

namespace rebound::calculix {
namespace {

/// Penalty of the contact [Pa/m]: 1 MPa takes 10 µm (pressing: 1 µm).
constexpr double impact_penalty = 1e11, press_penalty = 1e12;
/// Axisymmetric elements are wedges of two degrees there.
constexpr double wedges = 180.0;

class InputFile {
 public:
  InputFile(const Ball& ball, const QuadraticMesh& body, double gap, double penalty)
      : ball_(ball), body_(body), plate_(plate(0.55 * ball.radius, 2e-3, 60)) {
    text_ = "*NODE,NSET=ALL\n";
    write_nodes(body_, 0, gap);
    write_nodes(plate_, body_nodes(), 0.0);
    write_elements("BALL", body_, 0, 0);
    write_elements("PLATE", plate_, body_nodes(), static_cast<int>(body_.elements.size()));
    text_ += fmt::format("*NSET,NSET=NBALL,GENERATE\n1,{}\n*NSET,NSET=NPLATE,GENERATE\n{},{}\n",
                         body_nodes(), body_nodes() + 1,
                         body_nodes() + static_cast<int>(plate_.nodes.size()));
    write_set("AXIS", [](const auto& p) { return p[0] < 1e-9; });
    write_contact(penalty);
    write_materials();
  }

  template <class Holds>
  void write_set(const char* name, const Holds& holds) {
    text_ += fmt::format("*NSET,NSET={}\n", name);
    for (std::size_t i = 0; i < body_.nodes.size(); ++i)
      if (holds(body_.nodes[i])) text_ += fmt::format("{},\n", i + 1);
  }
  void add(const std::string& lines) { text_ += lines; }
  const std::string& text() const { return text_; }

 private:
  int body_nodes() const { return static_cast<int>(body_.nodes.size()); }
  void write_nodes(const QuadraticMesh& mesh, int before, double up) {
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
      text_ += fmt::format("{},{:.12g},{:.12g},0.\n", before + static_cast<int>(i) + 1,
                           mesh.nodes[i][0], mesh.nodes[i][1] + up);
  }
  void write_elements(const char* name, const QuadraticMesh& mesh, int nodes_before, int before) {
    text_ += fmt::format("*ELEMENT,TYPE=CAX8R,ELSET={}\n", name);
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
      text_ += std::to_string(before + static_cast<int>(e) + 1);
      for (const int node : mesh.elements[e]) text_ += fmt::format(",{}", nodes_before + node + 1);
      text_ += "\n";
    }
  }
  bool on_contact(int node) const {
    const auto& p = body_.nodes[node];
    return p[1] < 0.3 * ball_.radius &&
           std::abs(std::hypot(p[0], p[1] - ball_.radius) - ball_.radius) < 1e-9;
  }
  void write_contact(double penalty) {
    text_ += "*SURFACE,NAME=SBALL,TYPE=ELEMENT\n";
    for (std::size_t e = 0; e < body_.elements.size(); ++e)
      for (int side = 0; side < 4; ++side)
        if (on_contact(body_.elements[e][side]) && on_contact(body_.elements[e][(side + 1) % 4]))
          text_ += fmt::format("{},S{}\n", e + 1, side + 1);
    text_ += "*SURFACE,NAME=SPLATE,TYPE=ELEMENT\n";
    const int first = static_cast<int>(body_.elements.size());
    for (std::size_t e = 0; e < plate_.elements.size(); ++e)
      text_ += fmt::format("{},S3\n", first + e + 1);
    text_ += fmt::format(
        "*SURFACE INTERACTION,NAME=TOUCH\n*SURFACE BEHAVIOR,PRESSURE-OVERCLOSURE=LINEAR\n{:g}\n"
        "*CONTACT PAIR,INTERACTION=TOUCH,TYPE=SURFACE TO SURFACE\nSBALL,SPLATE\n",
        penalty);
  }
  void write_materials() {
    const double shear = 0.5 * ball_.youngs_modulus / (1.0 + ball_.poisson_ratio);
    const double bulk = ball_.youngs_modulus / (3.0 * (1.0 - 2.0 * ball_.poisson_ratio));
    const double density = ball_.mass / (4.0 / 3.0 * std::numbers::pi * std::pow(ball_.radius, 3));
    text_ += fmt::format(
        "*MATERIAL,NAME=RUBBER\n*HYPERELASTIC,NEO HOOKE\n{:.12g},{:.12g}\n*DENSITY\n{:.12g}\n"
        "*MATERIAL,NAME=STIFF\n*ELASTIC\n1e13,0.3\n*DENSITY\n1000.\n"
        "*SOLID SECTION,ELSET=BALL,MATERIAL=RUBBER\n*SOLID SECTION,ELSET=PLATE,MATERIAL=STIFF\n",
        0.5 * shear, 2.0 / bulk, density);
  }

  const Ball& ball_;
  const QuadraticMesh& body_;
  QuadraticMesh plate_;
  std::string text_;
};

/// Runs the input and gives back what was printed.
std::string run(const InputFile& input, const std::filesystem::path& folder) {
  std::ofstream(folder / "case.inp") << input.text();
  const std::string command =
      fmt::format("cd '{}' && OMP_NUM_THREADS=1 ccx case > case.log 2>&1", folder.string());
  if (std::system(command.c_str()) != 0)
    throw std::runtime_error("ccx did not complete, see " + (folder / "case.log").string());
  std::ifstream in(folder / "case.dat");
  std::stringstream all;
  all << in.rdbuf();
  return all.str();
}

/// Lines that follow a heading: its time, and the second number of the first line under it.
Trace forces_on_plate(const std::string& printed) {
  Trace trace;
  std::istringstream lines(printed);
  for (std::string line; std::getline(lines, line);) {
    const auto at = line.find("for set NPLATE and time");
    if (at == std::string::npos) continue;
    trace.time.push_back(std::stod(line.substr(at + 23)));
    std::getline(lines, line);
    double radial = 0.0, axial = 0.0;
    lines >> radial >> axial;
    trace.force.push_back(wedges * axial);
  }
  return trace;
}

constexpr const char* print_plate =
    "*NODE PRINT,NSET=NPLATE,TOTALS=ONLY,FREQUENCY=1\nRF\n*END STEP\n";

}  // namespace

Trace press(const Ball& ball, double travel, int steps, const std::filesystem::path& folder) {
  const QuadraticMesh body = lower_half(ball.radius, 8);
  InputFile input(ball, body, 0.0, press_penalty);
  input.write_set("MIDDLE", [&](const auto& p) { return std::abs(p[1] - ball.radius) < 1e-9; });
  input.add(fmt::format(
      "*BOUNDARY\nNPLATE,1,3\nAXIS,1,1\n*STEP,NLGEOM,INC=1000\n*STATIC,DIRECT\n{:.12g},1.\n"
      "*BOUNDARY\nMIDDLE,2,2,{:.12g}\n{}",
      1.0 / steps, -travel, print_plate));
  return forces_on_plate(run(input, folder));
}

Trace impact(const Ball& ball, const ImpactRequest& request, const std::filesystem::path& folder) {
  // Led from rest to the speed over ten steps, smoothly, and on for ten more.
  const double step = request.duration / request.steps, rise = 10.0 * step, led = 20.0 * step;
  const auto gone = [&](double time) {
    if (time >= rise) return request.speed * (time - 0.5 * rise);
    const double angle = std::numbers::pi * time / rise;
    return request.speed * rise * (0.5 * time / rise - 0.5 / std::numbers::pi * std::sin(angle));
  };
  const double gap = gone(led) + 0.2 * request.speed * step;
  const QuadraticMesh body = whole_sphere(ball.radius, 3);
  InputFile input(ball, body, gap, impact_penalty);
  input.add("*AMPLITUDE,NAME=LED\n");
  for (int i = 0; i <= 80; ++i)
    input.add(fmt::format("{:.12g},{:.12g}\n", 0.25 * i * step, gone(0.25 * i * step)));
  input.add(fmt::format(
      "*BOUNDARY\nNPLATE,1,3\nAXIS,1,1\n*STEP,NLGEOM,INC=1000\n*DYNAMIC,DIRECT\n{:.12g},{:.12g}\n"
      "*BOUNDARY,AMPLITUDE=LED\nNBALL,2,2,-1.\n*BOUNDARY\nNBALL,1,1\n"
      "*NODE PRINT,NSET=AXIS,FREQUENCY=20\nV\n*END STEP\n",
      step, led));
  input.add(
      fmt::format("*STEP,NLGEOM,INC=100000\n*DYNAMIC,DIRECT\n{:.12g},{:.12g}\n*BOUNDARY,OP="
                  "NEW\nNPLATE,1,3\nAXIS,1,1\n{}",
                  step, request.duration, print_plate));
  const std::string printed = run(input, folder);
  Trace trace = forces_on_plate(printed);
  for (double& time : trace.time) time -= led;
  std::istringstream velocities(printed.substr(printed.find("velocities")));
  std::string line;
  std::getline(velocities, line);
  double node = 0.0, radial = 0.0, axial = 0.0;
  velocities >> node >> radial >> axial;
  trace.speed = -axial;
  return trace;
}

}  // namespace rebound::calculix
