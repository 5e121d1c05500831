#include <array>

#include "comparisons/models/effects/dissipative/prony_branch.hpp"
#include "comparisons/models/effects/free_form/curve_points.hpp"

namespace rebound {
namespace {

constexpr double apart = 6.0;  // neighbouring relaxation times of the spectrum

EffectParameterCard ratio(const std::string& name, const std::string& sentence) {
  return {.name = name,
          .sentence = sentence,
          .dimension = dimension::none,
          .range = from_to(0.0, 20.0),
          .default_value = 0.0,
          .fitted = true,
          .kind = ParameterKind::linear,
          .scale = 0.3};
}

/// The fast, the middle and the slow one.
std::array<RelaxationBranch, 3> spectrum_of(const EffectChoice& choice) {
  const double time = choice.parameters.at("relaxation_time");
  const double exponent = choice.parameters.at("exponent");
  const auto branch = [&](double share, double factor) {
    return RelaxationBranch{.ratio = share, .relaxation_time = factor * time, .exponent = exponent};
  };
  return {branch(choice.parameters.at("fast_ratio"), 1.0 / apart), branch(choice.size, 1.0),
          branch(choice.parameters.at("slow_ratio"), apart)};
}

}  // namespace

Effect relaxation_spectrum_effect() {
  return {.card = {.name = "relaxation-spectrum",
                   .kind = EffectKind::dissipative,
                   .family = EffectFamily::memory,
                   .sentence = "Three relaxation times, each six times the one before: the memory "
                               "family without a formula.",
                   .equation = "F + q_1 + q_2 + q_3, q_i' = s_i G' - q_i/tau_i, "
                               "G = F_e (x/x_r)^p, s_i >= 0; the size is s_2",
                   .size_dimension = dimension::none,
                   .range = limit_of<&RelaxationBranch::ratio>.range,
                   .prior_scale = 0.3,
                   .parameters = {ratio("fast_ratio", "Ratio of the branch of tau/6."),
                                  ratio("slow_ratio", "Ratio of the branch of 6 tau."),
                                  {.name = "relaxation_time",
                                   .sentence = "The middle one, tau.",
                                   .dimension = dimension::time,
                                   .range = limit_of<&RelaxationBranch::relaxation_time>.range,
                                   .default_value = 1e-3,
                                   .fitted = true},
                                  {.name = "exponent",
                                   .sentence = "Power of x/x_r by which the springs of the "
                                               "branches differ from the law's: -1/2 makes "
                                               "Hertz's linear.",
                                   .dimension = dimension::none,
                                   .range = limit_of<&RelaxationBranch::exponent>.range,
                                   .default_value = 0.0,
                                   .fitted = true,
                                   .in_fem = false,  // branches follow the elastic stress there
                                   .kind = ParameterKind::linear,
                                   .scale = 0.3,
                                   .prior_deviation = 0.5}},
                   .fades_in = "relaxation_time",
                   .signature = "Force ends early at x > 0; stiffness grows with rate over more "
                                "than one decade.",
                   .experiment = "Hold and relax: the spectrum is the decay of the force.",
                   .source = "generalised Maxwell model as a free spectrum, e.g. Tschoegl 1989",
                   .is_free_form = true,
                   .free_form_of = "relaxation",
                   .moves = ImpactChange{.peak_force = 1, .contact_time = -1, .restitution = -1}},
          .to_lumped =
              [](const EffectChoice& choice, LumpedProblem& problem) {
                const auto [fast, middle, slow] = spectrum_of(choice);
                Mechanisms& mechanisms = problem.model.mechanisms;
                mechanisms.relaxation = middle;
                mechanisms.further_relaxation = {fast, slow};
              },
          .to_fem =
              [](const EffectChoice& choice, FemProblem& problem) {
                for (const RelaxationBranch& one : spectrum_of(choice))
                  if (one.ratio > 0.0)
                    add_prony_branch(problem.material, {.ratio = one.ratio,
                                                        .relaxation_time = one.relaxation_time,
                                                        .relaxes = Relaxes::all});
              }};
}

}  // namespace rebound
