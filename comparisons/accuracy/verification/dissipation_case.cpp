#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "comparisons/accuracy/verification/element_cases.hpp"
#include "comparisons/accuracy/verification/element_meshes.hpp"
#include "fem/interface/elastic_models.hpp"

namespace rebound {
namespace {

struct NamedMaterial {
  std::string name;
  Material material;
};

Material law(ElasticModel elastic) {
  Material material{.elastic = elastic, .youngs_modulus = 2.8, .poisson_ratio = 0.4};
  if (shape_of(elastic) == ElasticShape::second_share) material.second_share = 0.25;
  if (has_terms(elastic))
    material.terms = {{.weight = 3.0, .exponent = 4.0}, {.weight = 1.0, .exponent = -2.0}};
  return material;
}

Material with_branch(Material material, const PronyBranch& branch,
                     Relaxation relaxation = Relaxation::convolution) {
  material.branches = {branch};
  material.relaxation = relaxation;
  return material;
}

Material with_strain(Material material, const StrainDependence& strain) {
  material.strain = strain;
  return material;
}

/// As people write it, where that is not the name in files.
std::string title_of(const ElasticModelCard& card) {
  switch (card.model) {
    case ElasticModel::neo_hookean: return "neo-Hookean";
    case ElasticModel::neo_hookean_isochoric: return "isochoric neo-Hookean";
    case ElasticModel::mooney_rivlin: return "Mooney-Rivlin";
    case ElasticModel::ogden: return "Ogden";
    default: return card.name;
  }
}

/// Every law and every way to lose energy.
std::vector<NamedMaterial> materials() {
  using enum ElasticModel;
  const Material plain = law(neo_hookean);
  Material viscous = plain;
  viscous.retardation_time = 0.05;
  const PronyBranch all{0.5, 1.0, Relaxes::all}, deviator{0.5, 1.0, Relaxes::deviator};
  Material whole = with_branch(plain, {0.3, 1.0, Relaxes::all}, Relaxation::multiplicative);
  whole.strain = {.stiffening = 1.0, .mullins = 0.3};
  whole.retardation_time = 0.01;
  StrainDependence curves;
  curves.curve = {.value = {0.0, 0.3, 0.1, 0.4, 0.4, 0.6}, .reach = 0.3};
  curves.unloading.value = {-0.5, -0.4, -0.3, -0.2, -0.1};
  std::vector<NamedMaterial> list;
  for (const ElasticModelCard& card : elastic_models())
    list.push_back({title_of(card), law(card.model)});
  const std::vector<NamedMaterial> inelastic = {
      {"branch of all stress", with_branch(plain, all)},
      {"branch of the deviator", with_branch(plain, deviator)},
      {"branch of the isochoric stress", with_branch(law(neo_hookean_isochoric), deviator)},
      {"branch of a hyperfoam", with_branch(law(hyperfoam), all)},
      {"multiplicative branch", with_branch(plain, all, Relaxation::multiplicative)},
      {"multiplicative branch of the deviator",
       with_branch(plain, deviator, Relaxation::multiplicative)},
      {"power-law branch", with_branch(plain, {0.4, 1.0, Relaxes::all, 0.3, 0.05})},
      {"plastic branch", with_branch(plain, {0.4, 1.0, Relaxes::deviator, 0.05, 0.03})},
      {"viscous stress", viscous},
      {"stiffening and densification",
       with_strain(plain, {.stiffening = 2.0, .densification = 10.0})},
      {"softening", with_strain(law(ogden), {.softening = 0.6})},
      {"Mullins softening", with_strain(law(hyperfoam), {.mullins = 0.5})},
      {"curves of strain and of unloading", with_strain(plain, curves)},
      {"multiplicative branch, Mullins softening, viscous stress", whole}};
  list.insert(list.end(), inelastic.begin(), inelastic.end());
  return list;
}

/// A closed path from rest to rest, both stretches sums of four sines.
StretchHistory random_cycle(std::mt19937_64& engine, int steps) {
  // Not a distribution of the library: those differ between libraries.
  const auto uniform = [&] { return static_cast<double>(engine() >> 11) * 0x1.0p-53; };
  std::array<std::array<double, 4>, 2> size{};
  const double largest = 0.05 + 0.25 * uniform();
  for (auto& one : size)
    for (double& value : one) value = largest * (2.0 * uniform() - 1.0) / 2.0;
  const double duration = std::pow(10.0, 2.0 * uniform() - 1.0);
  StretchHistory history{.step = duration / steps, .stretches = {}};
  for (int n = 1; n <= steps; ++n) {
    std::array<double, 2> stretch = {1.0, 1.0};
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t k = 0; k < 4; ++k)
        stretch[i] +=
            size[i][k] * std::sin(std::numbers::pi * static_cast<double>(k + 1) * n / steps);
    history.stretches.push_back({stretch[0], stretch[1]});
  }
  return history;
}

/// Work of a cycle over the work put in during it: zero without loss, never below.
double work_share(const std::vector<UniformStress>& stresses, const StretchHistory& history) {
  double work = 0.0, put_in = 0.0;
  UniformStretch stretch_before;
  UniformStress before;
  for (std::size_t n = 0; n < stresses.size(); ++n) {
    const UniformStretch& stretch = history.stretches[n];
    const double now =
        (stresses[n].radial + before.radial) * (stretch.radial - stretch_before.radial) +
        0.5 * (stresses[n].axial + before.axial) * (stretch.axial - stretch_before.axial);
    work += now;
    put_in += std::max(now, 0.0);
    stretch_before = stretch;
    before = stresses[n];
  }
  return work / put_in;
}

}  // namespace

VerificationPart verify_dissipation(const ElementChecks& checks) {
  constexpr int trials = 30, steps = 800;
  const Mesh mesh = distorted_cylinder();
  VerificationPart part;
  for (const NamedMaterial& one : materials()) {
    std::mt19937_64 engine(20);
    double smallest = 1.0;
    for (int trial = 0; trial < trials; ++trial) {
      const StretchHistory history = random_cycle(engine, steps);
      smallest = std::min(
          smallest,
          work_share(checks.follow(mesh, CellKind::bilinear, one.material, history), history));
    }
    part.rows.push_back(
        {.case_id = "invariant",
         .quantity = fmt::format("energy won in the worst of {} closed cycles over that put in, {}",
                                 trials, one.name),
         .unit = "",
         .target = 1e-4,
         .result = -smallest,
         .tolerance = 0.0,
         .scale = ToleranceScale::upper_bound,
         .source = "second law, random search; 1e-4 for the sums of 800 steps"});
  }
  return part;
}

}  // namespace rebound
