#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "comparisons/accuracy/verification/element_cases.hpp"
#include "comparisons/accuracy/verification/element_meshes.hpp"
#include "comparisons/accuracy/verification/refinement.hpp"
#include "comparisons/accuracy/verification/targets.hpp"
#include "fem/interface/elastic_models.hpp"

namespace rebound {
namespace {

UniformStretch uniaxial(double stretch) {
  return {1.0 / std::sqrt(stretch), stretch};
}
UniformStretch equibiaxial(double stretch) {
  return {stretch, 1.0 / (stretch * stretch)};
}

/// Long-term μ = 1, one branch of the deviator, ratio 1, τ = 1 s. At constant
/// volume the bulk modulus does no work: stress differences are those of the
/// incompressible solid.
Material solid() {
  Material material{.elastic = ElasticModel::neo_hookean_isochoric,
                    .youngs_modulus = 2.8,
                    .poisson_ratio = 0.4,
                    .modulus = ModulusBasis::long_term};
  material.branches = {{1.0, 1.0, Relaxes::deviator}};
  return material;
}

class ViscoelasticCellsCase {
 public:
  ViscoelasticCellsCase(const ElementChecks& checks, CellKind cells)
      : checks_(checks), cells_(cells) {}

  void ramps(VerificationTable& rows, std::vector<Refinement>& drawn) const;
  void step(VerificationTable& rows) const;
  void cycles(VerificationTable& rows) const;

 private:
  /// Cauchy stress, axial less radial, at constant volume.
  std::vector<double> differences(const StretchHistory& history) const {
    const auto nominal = checks_.follow(distorted_cylinder(), cells_, solid(), history);
    std::vector<double> stress;
    for (std::size_t i = 0; i < nominal.size(); ++i)
      stress.push_back(nominal[i].axial * history.stretches[i].axial -
                       nominal[i].radial * history.stretches[i].radial);
    return stress;
  }
  double ramp_error(const targets::RampAndHold& ramp, int per_second) const;
  std::string of_cells() const { return fmt::format(", {} cells", name_of(cells_)); }

  const ElementChecks& checks_;
  CellKind cells_;
};

/// Largest relative error over the instants of the target.
double ViscoelasticCellsCase::ramp_error(const targets::RampAndHold& ramp, int per_second) const {
  StretchHistory history{.step = 1.0 / per_second, .stretches = {}};
  for (int n = 1; n <= 4 * per_second; ++n) {
    const double stretch = 1.0 + (ramp.stretch - 1.0) * std::min(n * history.step, 1.0);
    history.stretches.push_back(ramp.equibiaxial ? equibiaxial(stretch) : uniaxial(stretch));
  }
  const auto stress = differences(history);
  double worst = 0.0;
  for (const auto& [time, target] : ramp.stresses) {
    const double found = stress[std::lround(time * per_second) - 1];
    worst = std::max(worst, std::abs((ramp.equibiaxial ? -found : found) / target - 1.0));
  }
  return worst;
}

void ViscoelasticCellsCase::ramps(VerificationTable& rows, std::vector<Refinement>& drawn) const {
  for (const targets::RampAndHold& ramp : targets::ramps_and_holds) {
    Refinement steps{.name = ramp.name + of_cells(),
                     .size = {},
                     .error = {},
                     .expected_order = 2.0,
                     .tolerance = 0.1};
    for (const int per_second : {40, 80, 160}) {
      steps.size.push_back(1.0 / per_second);
      steps.error.push_back(ramp_error(ramp, per_second));
    }
    rows.push_back({.case_id = "g",
                    .quantity = fmt::format("largest error of the stress, {}, 160 steps a second{}",
                                            ramp.name, of_cells()),
                    .unit = "",
                    .target = 0.0,
                    .result = steps.error.back(),
                    .tolerance = 1e-5,
                    .scale = ToleranceScale::absolute,
                    .order = fitted_order(steps),
                    .source = "quadratures of the incompressible solid, 12 digits"});
    rows.push_back(order_row("g", steps, "branches exact for stress linear over a step"));
    drawn.push_back(std::move(steps));
  }
}

void ViscoelasticCellsCase::step(VerificationTable& rows) const {
  // A step is a ramp over one time step here: first order in it.
  constexpr int per_second = 2000;
  const StretchHistory history{
      .step = 1.0 / per_second,
      .stretches = std::vector<UniformStretch>(5 * per_second, uniaxial(2.0))};
  const auto stress = differences(history);
  const auto add = [&](const char* when, int place, double target) {
    rows.push_back(
        {.case_id = "g",
         .quantity = fmt::format("stress {} a step to a stretch of 2{}", when, of_cells()),
         .unit = "Pa",
         .target = target,
         .result = stress[place],
         .tolerance = 5e-4,
         .source = "7/2 (1 + exp(-t)) Pa"});
  };
  add("right after", 0, 7.0);
  add("1 s after", per_second - 1, 4.7875780441);
  add("5 s after", 5 * per_second - 1, 3.5235828145);
}

void ViscoelasticCellsCase::cycles(VerificationTable& rows) const {
  // ∮ P dλ at λ = 1 + 0.3 sin t, P the nominal uniaxial stress.
  constexpr int per_cycle = 1000;
  StretchHistory history{.step = 2.0 * std::numbers::pi / per_cycle, .stretches = {}};
  for (int n = 1; n <= 6 * per_cycle; ++n)
    history.stretches.push_back(uniaxial(1.0 + 0.3 * std::sin(n * history.step)));
  const auto stress = differences(history);
  const auto nominal = [&](int n) { return stress[n] / history.stretches[n].axial; };
  double work = 0.0;
  for (int n = 5 * per_cycle; n < 6 * per_cycle; ++n)
    work += 0.5 * (nominal(n) + nominal(n - 1)) *
            (history.stretches[n].axial - history.stretches[n - 1].axial);
  rows.push_back({.case_id = "g",
                  .quantity = "work of the sixth cycle" + of_cells(),
                  .unit = "J/m3",
                  .target = 0.4946002104,
                  .result = work,
                  .tolerance = 1e-4,
                  .source = "quadratures of the incompressible solid"});
}

}  // namespace

VerificationPart verify_viscoelastic_cells(const ElementChecks& checks) {
  VerificationPart part;
  std::vector<Refinement> drawn;
  for (const CellKind cells : cell_kinds) {
    const ViscoelasticCellsCase case_id(checks, cells);
    case_id.ramps(part.rows, drawn);
    case_id.step(part.rows);
    case_id.cycles(part.rows);
  }
  part.figures = {refinement_figure(
      {.title = "Viscoelastic cells under a ramp",
       .caption = "Case g: largest relative error of the stress over ramp and hold, finite strain.",
       .size = {"time step", "s"},
       .error = {"relative error of the stress", "1"}},
      drawn)};
  return part;
}

}  // namespace rebound
