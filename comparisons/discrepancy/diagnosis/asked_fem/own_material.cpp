#include "comparisons/discrepancy/diagnosis/asked_fem/own_material.hpp"
#include "fem/interface/elastic_models.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

/// Poisson ratio where a search starts, and how far it may go: cells of plain bilinear kind.
constexpr double first_poisson_ratio = 0.35, least_poisson_ratio = 0.1, most_poisson_ratio = 0.45;
constexpr double first_ratio = 1.0, least_ratio = 1e-3, most_ratio = 20.0;
constexpr double reach = 3.0;  // of a logarithm, either way

/// Time of a branch over that of the contact: where it starts, and how far it may go.
struct BranchTimes {
  double first, shortest, longest;
};
/// Loss without memory, of one branch and of a slower one beside it.
constexpr std::array<BranchTimes, 2> times = {{{0.025, 0.004, 0.08}, {0.06, 0.03, 0.1}}};

double contact_time_of(const Material& guess) {
  return guess.branches.front().relaxation_time / times.front().first;
}

CalibrationParameter logarithm(const char* name, double first, double least, double most) {
  return {.name = name,
          .unit = "ln SI",
          .start = std::log(std::clamp(first, least, most)),
          .lowest = std::log(least),
          .highest = std::log(most),
          .scale = 1.0};
}

}  // namespace

Material guess_fem_material(const Observations& seen, const std::vector<std::size_t>& shots,
                            const HypothesisFit& lumped) {
  if (shots.empty()) throw Error(ExitCode::solver_failed, "no force history to fit an FE model to");
  const Sphere& sphere = seen.balls[seen.shots[shots.front()].ball].sphere;
  const ImpactScalars& scalars = lumped.model->impact(lumped.values, shots.front()).scalars;
  Material material;
  material.poisson_ratio = first_poisson_ratio;
  material.modulus = ModulusBasis::long_term;
  material.youngs_modulus = 0.6 * (1.0 - first_poisson_ratio * first_poisson_ratio) *
                            scalars.peak_force /
                            (std::sqrt(sphere.radius()) * std::pow(scalars.peak_deflection, 1.5));
  material.branches = {
      {.ratio = first_ratio, .relaxation_time = times.front().first * scalars.contact_time}};
  return material;
}

std::vector<Material> other_laws_near(const Material& fitted) {
  constexpr double second_share = 0.3, of_ogden = 3.0, of_hyperfoam = 4.0;
  std::vector<Material> laws(3, fitted);
  laws[0].elastic = ElasticModel::mooney_rivlin;
  laws[0].second_share = second_share;
  laws[1].elastic = ElasticModel::ogden;
  laws[1].terms = {{.exponent = of_ogden, .beta = {}}};
  laws[2].elastic = ElasticModel::hyperfoam;
  laws[2].terms = {{.exponent = of_hyperfoam, .beta = {}}};
  return laws;
}

std::vector<Material> other_kinds_near(const Material& fitted, const Material& guess) {
  std::vector<Material> kinds(2, fitted);
  // Fast branches act by ratio times time: half of it each.
  PronyBranch& first = kinds[0].branches.front();
  const double slower = times[1].first * contact_time_of(guess);
  first.ratio *= 0.5;
  kinds[0].branches.push_back(
      {.ratio = first.ratio * first.relaxation_time / slower, .relaxation_time = slower});
  kinds[1].branches.front().relaxes = Relaxes::deviator;
  return kinds;
}

MaterialUnknowns::MaterialUnknowns(const Material& guess, const Material& start)
    : guess_(guess), kind_(start) {}

void MaterialUnknowns::add(std::vector<CalibrationParameter>& unknowns) const {
  const double far = std::exp(reach), modulus = guess_.youngs_modulus;
  unknowns.push_back(
      logarithm("Young's modulus", kind_.youngs_modulus, modulus / far, modulus * far));
  unknowns.push_back({.name = "Poisson ratio",
                      .unit = "1",
                      .start = kind_.poisson_ratio,
                      .lowest = least_poisson_ratio,
                      .highest = most_poisson_ratio,
                      .scale = 1.0});
  const double contact = contact_time_of(guess_);
  for (std::size_t k = 0; k < kind_.branches.size(); ++k) {
    const PronyBranch& branch = kind_.branches[k];
    const BranchTimes& of = times.at(k);
    unknowns.push_back(logarithm("branch ratio", branch.ratio, least_ratio, most_ratio));
    unknowns.push_back(logarithm("relaxation time", branch.relaxation_time, of.shortest * contact,
                                 of.longest * contact));
  }
}

Material MaterialUnknowns::at(const std::vector<double>& x) const {
  Material material = kind_;
  material.youngs_modulus = std::exp(x[0]);
  material.poisson_ratio = x[1];
  for (std::size_t k = 0; k < material.branches.size(); ++k) {
    material.branches[k].ratio = std::exp(x[2 + 2 * k]);
    material.branches[k].relaxation_time = std::exp(x[3 + 2 * k]);
  }
  return material;
}

}  // namespace rebound
