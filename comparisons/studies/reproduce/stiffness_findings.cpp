#include <fmt/format.h>

#include <cmath>

#include "comparisons/inference/calibration/platen_modulus.hpp"
#include "comparisons/studies/reproduce/findings.hpp"
#include "comparisons/studies/reproduce/table_rows.hpp"
#include "comparisons/studies/reproduce/wording.hpp"

namespace rebound {
namespace {

/// Factor c of F = c E/(1 − ν²) √R x^1.5 for one sphere on one rigid plate, x
/// the approach of its centre. Source: Hertz 1882.
constexpr double one_contact_factor = 4.0 / 3.0;

/// Stiffness of one contact over that of a ball between two platens, whose
/// total approach is shared by two contacts.
double contact_over_platens() {
  return std::pow(2.0, 1.5);
}

/// The compression of section 4.1: fitted over 0.5 to 2.5 mm of travel.
PlatenTest platen_test(const PaperCore& core) {
  return {.stiffness = core.platen_stiffness.value,
          .diameter = core.diameter.value,
          .poisson_ratio = core.published.poisson_ratio.value,
          .shortest_travel = 0.5e-3,
          .longest_travel = 2.5e-3};
}

Finding factor_of_eq_10(const Paper& paper) {
  const double platens = one_contact_factor / contact_over_platens();
  const auto measured_over = [&](double factor) {
    return per_core(paper, [&](const PaperCore& core) {
      return core.platen_stiffness.value * printed_hertz_factor /
             (core.published.hertz_stiffness.value * factor);
    });
  };
  return {"eq-10-factor",
          fmt::format("Eq. (10) has the factor {:.3f}; one sphere on one rigid plate has {:.3f}, "
                      "and between two platens, in total approach as tested, {:.3f}.",
                      printed_hertz_factor, one_contact_factor, platens),
          fmt::format("measured over theoretical platen stiffness, A-D: {} with the printed "
                      "factor, {} with that of two platens",
                      listed(measured_over(printed_hertz_factor), 2),
                      listed(measured_over(platens), 2))};
}

Finding dynamic_over_static(const Paper& paper) {
  const auto ratio = per_core(paper, [](const PaperCore& core) {
    return core.published.hunt_crossley_stiffness.value / core.platen_stiffness.value;
  });
  const auto corrected = per_core(paper, [](const PaperCore& core) {
    return core.published.hunt_crossley_stiffness.value /
           (core.platen_stiffness.value * contact_over_platens());
  });
  return {"platens-are-two-contacts",
          fmt::format("The impact has one contact, the platen test two: the stiffness to compare "
                      "with is {:.3f} times the platen one, and stiffening from slow to fast is "
                      "{:.1f} to {:.1f} times, not {:.1f} to {:.1f}.",
                      contact_over_platens(), corrected.back(), corrected.front(), ratio.back(),
                      ratio.front()),
          fmt::format("dynamic over quasi-static stiffness, A-D: {} as published, {} for one "
                      "contact against one contact",
                      listed(ratio, 1), listed(corrected, 2))};
}

Finding block_against_ball(const Paper& paper) {
  const double mega = 1e-6;
  const auto block =
      per_core(paper, [&](const PaperCore& core) { return mega * core.block_modulus.value; });
  const auto hertz = per_core(paper, [&](const PaperCore& core) {
    return mega * modulus_from_platens_hertz(platen_test(core));
  });
  const auto finite = per_core(
      paper, [&](const PaperCore& core) { return mega * modulus_from_platens(platen_test(core)); });
  std::vector<double> ratio;
  for (std::size_t i = 0; i < block.size(); ++i) ratio.push_back(block[i] / finite[i]);
  return {"block-against-ball",
          fmt::format("Block and whole ball do not give one modulus: block over ball is {} for "
                      "cores A-D.",
                      listed(ratio, 2)),
          fmt::format("modulus in MPa, A-D: block {}; ball between platens by Hertz {}; with the "
                      "finite-sphere correction (C = 0.21) {}",
                      listed(block, 2), listed(hertz, 2), listed(finite, 2))};
}

}  // namespace

std::vector<Finding> stiffness_findings(const Evidence& evidence) {
  return {factor_of_eq_10(evidence.paper), dynamic_over_static(evidence.paper),
          block_against_ball(evidence.paper)};
}

}  // namespace rebound
