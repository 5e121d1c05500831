#include "comparisons/models/effects/dissipative/flat_spectrum.hpp"

#include <cmath>

#include "comparisons/models/effects/dissipative/prony_branch.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {

void relax_by_power_law(Material& material, const PowerLawRelaxation& law) {
  constexpr int decades = 7;
  constexpr double fastest = 1e-5;
  constexpr std::size_t most_branches = 16;
  const double s = law.exponent;
  if (!(s > 0.0 && s < 1.0))
    throw Error(ExitCode::bad_input,
                "in the FE tier stiffness grows with rate through a spectrum of relaxation times, "
                "whose exponent lies between 0 and 1",
                {.value = std::to_string(s), .allowed = "(0, 1)"});
  if (material.branches.size() + decades > most_branches)
    throw Error(ExitCode::bad_input,
                "a flat spectrum takes 7 of the 16 branches that there can be");
  double strength[decades], time[decades];
  const auto part = [&](double tau) { return std::pow(tau / law.reference_time, -s); };
  double at_reference = part(fastest * std::pow(10.0, decades - 0.5)) / std::tgamma(1.0 + s);
  const double slow = at_reference;
  for (int k = 0; k < decades; ++k) {
    time[k] = fastest * std::pow(10.0, k);
    strength[k] = part(time[k]) * std::log(10.0) / std::tgamma(s);
    at_reference += strength[k] * std::exp(-law.reference_time / time[k]);
  }
  describe_as_long_term(material);
  const double kept = slow / at_reference;
  material.youngs_modulus *= kept;
  for (PronyBranch& branch : material.branches) branch.ratio /= kept;
  for (int k = 0; k < decades; ++k)
    material.branches.push_back({.ratio = strength[k] / slow, .relaxation_time = time[k]});
}

}  // namespace rebound
