#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cmath>
#include <filesystem>

#include "comparisons/app/commands.hpp"
#include "comparisons/app/examples.hpp"
#include "comparisons/app/print_result.hpp"
#include "comparisons/app/terminal.hpp"
#include "comparisons/models/fem_access/module_loader.hpp"
#include "lumped/integration/simulate.hpp"
#include "lumped/problem/atomic_file.hpp"
#include "meshes/generate/sphere_mesh.hpp"

namespace rebound {
namespace {

/// One thing looked at: "ok" or what is wrong with it.
struct Check {
  std::string what;
  std::string state;
  bool healthy = true;
};

template <class Look>
Check look_at(const std::string& what, const Look& look) {
  try {
    return {what, look(), true};
  } catch (const std::exception& error) {
    return {what, error.what(), false};
  }
}

std::string look_at_folder(const std::filesystem::path& folder) {
  if (folder.empty()) throw Error(ExitCode::input_output_failed, "no folder is set");
  make_writable_folder(folder);
  return folder.string();
}

/// An undamped law must give back all of its speed.
std::string look_at_lumped_tier() {
  LumpedProblem problem = example_lumped_problem();
  problem.model.parameters["damping"] = 0.0;
  const double restitution = simulate(problem).scalars.restitution;
  if (std::abs(restitution - 1.0) > 1e-6)
    throw Error(ExitCode::comparison_failed,
                fmt::format("an elastic impact returned e = {:.9f}", restitution));
  return fmt::format("elastic impact returns e = {:.9f}", restitution);
}

/// An elastic sphere on few cells: momentum and energy must close.
std::string look_at_fem_tier() {
  FemProblem problem = example_fem_problem();
  problem.material.branches.clear();
  problem.impact.speed = 1.0;
  const Mesh mesh = generate_sphere_mesh({.radius = problem.sphere.radius(), .cells = 100});
  const FemResult result = fem_tier().simulate(problem, mesh, {});
  if (!result.incomplete_because.empty())
    throw Error(ExitCode::solver_failed, result.incomplete_because);
  if (result.closures.impulse > 1e-6 || result.closures.energy > 1e-3)
    throw Error(ExitCode::comparison_failed,
                fmt::format("closures are {:.2g} (impulse) and {:.2g} (energy)",
                            result.closures.impulse, result.closures.energy));
  return fmt::format("elastic impact of {} cells returns e = {:.4f}", result.cells,
                     result.restitution_momentum);
}

/// A mesh made, written and read back by Gmsh.
std::string look_at_meshing() {
  const RunControl control;
  const GmshModule& gmsh = gmsh_module();
  const Mesh mesh = gmsh.sphere({.radius = 0.03, .cells = 60}, control);
  if (gmsh.msh(mesh).empty()) throw Error(ExitCode::input_output_failed, "Gmsh wrote nothing");
  return fmt::format("{}, {} unstructured cells", gmsh.version(), mesh.cells.size());
}

std::vector<Check> examine() {
  std::vector<Check> findings;
  for (const std::string& version : library_versions()) findings.push_back({"built with", version});
  findings.push_back(look_at("results folder (here)", [] { return look_at_folder("."); }));
  findings.push_back(look_at(
      "temporary files", [] { return look_at_folder(std::filesystem::temp_directory_path()); }));
  findings.push_back(look_at("lumped tier", look_at_lumped_tier));
  if (!has_fem_tier()) {
    findings.push_back({"FE tier", "left out of this build (-DREBOUND_FEM=OFF)"});
    return findings;
  }
  findings.push_back(look_at("FE module", [] { return fem_tier().versions(); }));
  findings.push_back(look_at("FE tier", look_at_fem_tier));
  findings.push_back(look_at("mesh files", look_at_meshing));
  return findings;
}

ExitCode run_doctor(const Session& session) {
  bool healthy = true;
  Json list = Json::array();
  for (const Check& finding : examine()) {
    healthy = healthy && finding.healthy;
    list.push_back({{"what", finding.what}, {"state", finding.state}, {"ok", finding.healthy}});
    if (!session.json())
      print_text(fmt::format("{:<8}{:<24}{}\n", finding.healthy ? "ok" : "PROBLEM", finding.what,
                             finding.state));
  }
  if (session.json())
    print_result(session, {{"schema", 1},
                           {"version", REBOUND_VERSION},
                           {"fem", has_fem_tier()},
                           {"healthy", healthy},
                           {"findings", list}});
  return healthy ? ExitCode::done : ExitCode::comparison_failed;
}

}  // namespace

Action declare_doctor(CLI::App& command) {
  command.footer("Looks at versions, modules and folders, and runs each tier once.\n\n" +
                 exit_code_help());
  return run_doctor;
}

}  // namespace rebound
