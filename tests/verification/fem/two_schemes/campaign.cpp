#include "tests/verification/fem/two_schemes/campaign.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "comparisons/io/toml/impact_file.hpp"
#include "comparisons/models/fem_access/module_loader.hpp"
#include "lumped/problem/error.hpp"
#include "meshes/generate/sphere_mesh.hpp"

namespace rebound::test {
namespace {

constexpr const char* header =
    "core,speed_m_s,quantity,explicit,explicit_bar,implicit,implicit_bar";

}  // namespace

double SchemePair::distance() const {
  return std::abs(explicit_value - implicit_value) / std::hypot(explicit_bar, implicit_bar);
}

std::vector<SchemePair> run_both(const std::filesystem::path& folder, const std::string& core,
                                 double speed) {
  FemProblem problem = read_fem_file(folder / ("core-" + core + ".toml"));
  problem.impact.speed = speed;
  const auto reference = [&](FemScheme scheme, int cells) {
    problem.scheme = scheme;
    const Mesh coarse = generate_sphere_mesh({.radius = problem.sphere.radius(), .cells = cells});
    return run_reference(fem_tier(), problem, coarse, {});
  };
  const auto first = reference(FemScheme::explicit_steps, explicit_coarse_cells);
  const auto second = reference(FemScheme::implicit_steps, implicit_coarse_cells);
  std::vector<SchemePair> pairs;
  for (std::size_t i = 0; i < scalars_with_error().size(); ++i) {
    const ScalarOfResult& scalar = scalars_with_error()[i];
    pairs.push_back({.core = core,
                     .speed = speed,
                     .quantity = scalar.key,
                     .explicit_value = scalar.value(first.result),
                     .explicit_bar = first.errors[i].uncertainty,
                     .implicit_value = scalar.value(second.result),
                     .implicit_bar = second.errors[i].uncertainty});
  }
  return pairs;
}

std::string campaign_csv(const std::vector<SchemePair>& pairs) {
  std::string text = std::string(header) + "\n";
  for (const SchemePair& p : pairs)
    text += fmt::format("{},{},{},{:.8g},{:.3g},{:.8g},{:.3g}\n", p.core, p.speed, p.quantity,
                        p.explicit_value, p.explicit_bar, p.implicit_value, p.implicit_bar);
  return text;
}

std::vector<SchemePair> read_campaign(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  if (line != header) throw Error(ExitCode::corrupt_store, "not a table of the campaign");
  std::vector<SchemePair> pairs;
  while (std::getline(stream, line)) {
    std::istringstream cells(line);
    SchemePair p;
    char comma;
    std::getline(cells, p.core, ',');
    cells >> p.speed >> comma;
    std::getline(cells, p.quantity, ',');
    cells >> p.explicit_value >> comma >> p.explicit_bar >> comma >> p.implicit_value >> comma >>
        p.implicit_bar;
    if (!cells) throw Error(ExitCode::corrupt_store, "a broken line in the campaign: " + line);
    pairs.push_back(p);
  }
  return pairs;
}

}  // namespace rebound::test
