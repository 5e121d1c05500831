#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/discrepancy/trials/generator/baseline_pulse.hpp"
#include "comparisons/discrepancy/trials/generator/fem_program.hpp"
#include "comparisons/discrepancy/trials/generator/hidden_effect.hpp"
#include "comparisons/discrepancy/trials/generator/noise.hpp"
#include "comparisons/discrepancy/trials/generator/refit.hpp"

namespace trials {

/// What one trial is drawn from.
struct TrialRequest {
  std::uint64_t seed = 0;
  std::string set;
  int number = 1;
  std::string only;  ///< a kind or the name of a form; empty: all kinds
  /// Balls in finite elements, by this program; null: balls that obey Hunt–Crossley.
  std::shared_ptr<FemProgram> fem{};
  /// Of those balls: is the believed model one in finite elements, and not Hunt–Crossley?
  bool believe_fem = false;
};

/// A number as the data set states it, with one standard deviation.
struct Stated {
  double value = 0.0;
  double uncertainty = 0.0;
};

struct TrialShot {
  Stated speed;             ///< [m/s]
  double true_speed = 0.0;  ///< [m/s]
  double true_restitution = 0.0;
  double true_contact_time = 0.0;  ///< [s]
  double true_peak_force = 0.0;    ///< before the measuring chain [N]
  std::optional<Stated> restitution{};
  double sampling_phase = 0.0;  ///< of the first sample, in sampling intervals
  std::vector<double> time;     ///< as written [s]
  std::vector<double> force;    ///< as written [N]
};

/// How well the noise is stated.
enum class NoiseStatement { right, half, twice, absent };
std::string name_of(NoiseStatement statement);

/// The form whose trace in the data is most like that of the truth.
struct Rival {
  std::string form;     ///< empty: there is none
  double cosine = 0.0;  ///< of what both leave over beside the refitted baseline, absolute
};

/// Could anyone tell the truth of a trial from other effects? A cosine of 0.9 leaves a fifth of χ².
struct Rivals {
  Rival of_other_family;  ///< of two effects, or one outside all families: of any family
  Rival of_other_name;    ///< another effect of the project's list
};

/// One trial: what is stated, what is true, what was recorded.
struct Trial {
  TrialRequest request;
  std::string kind;

  BaselineBall ball;    ///< true mass, stiffness, damping; in finite elements about those
  FemBall fem;          ///< with nothing hidden, where the request has a program for it
  double radius = 0.0;  ///< true [m]
  double restitution_at_mid_speed = 0.0;
  Stated mass;      ///< [kg]
  Stated diameter;  ///< [m]
  double true_gain = 1.0;
  double gain_uncertainty = 0.0;

  Noise noise;
  NoiseStatement noise_statement = NoiseStatement::right;
  std::optional<double> stated_noise{};  ///< [N]

  double sampling_rate = 0.0;  ///< [Hz]
  int samples_before = 0;
  double after_share = 0.0;  ///< record after contact, in contact times
  std::optional<double> restitution_uncertainty{};

  Scales scales;
  std::vector<HiddenEffect> effects;
  std::vector<TrialShot> shots;
  double visible_chi_square = 0.0;
  Rivals rivals;

  double believed_stiffness = 0.0;  ///< [N/m^1.5]
  double believed_damping = 0.0;    ///< k λ [N s/m^2.5]
};

/// Kinds of trials that can be asked for, beside the names of forms.
const std::vector<std::string>& kinds();

/// Are these trials of a ball in finite elements? They have kinds and forms of their own.
inline bool in_fem(const TrialRequest& request) {
  return request.fem != nullptr;
}

/// Draws and records one trial. The same request gives the same trial, bit for bit.
Trial make_trial(const TrialRequest& request);

/// Ball, speeds, instrument and noise: everything but effects and records.
Trial draw_experiment(const TrialRequest& request);

/// One of these forms, with secondary numbers and no size yet.
HiddenEffect draw_form(const std::vector<const EffectForm*>& from, Random& random);

/// Draws kind, forms, secondary numbers and sizes.
void draw_effects(Trial& trial);

/// Three speeds for a ball in finite elements, and the ball: its highest speed is 0.06 to 0.16 of
/// that of waves, √(E/ρ).
std::vector<double> draw_fem_speeds(Random& random);
void draw_fem_ball(Trial& trial, Random& random);

/// Noise-free record of all shots with these effects, clipped and rounded.
/// Errors: NoRebound.
struct NoiseFree {
  HiddenWorld world;
  std::vector<SimulatedImpact> impacts;
  std::vector<Sampling> samplings;
};
NoiseFree simulate_trial(const Trial& trial, const std::vector<HiddenEffect>& effects);
/// In finite elements, on so many cells.
NoiseFree simulate_in_fem(const Trial& trial, const std::vector<HiddenEffect>& effects, int cells);

/// What is left of these effects beside the refitted baseline, in the noise of the trial, at times
/// of these samplings. Errors: NoRebound.
Refit what_shows(const Trial& trial, const std::vector<HiddenEffect>& effects,
                 const std::vector<Sampling>& samplings);

/// χ² of that, at the effects' own times. Errors: NoRebound.
double visible_chi_square(const Trial& trial, const std::vector<HiddenEffect>& effects);

/// The same in finite elements: what is left beside a ball with nothing hidden, whose modulus,
/// Poisson ratio, branches, starts of shots and elastic law are fitted in a few steps, beside gain,
/// offset and speeds, which enter to first order. Sizes are searched with it. Errors: NoRebound.
/// Limit:  a delay of all shots shows nothing -> test FemTrials.ADelayOfAllShotsShowsNothing
double visible_chi_square_in_fem(const Trial& trial, const std::vector<HiddenEffect>& effects);

/// The same beside the nearest ball that is found from every elastic law with steps until they
/// settle: the label of a trial. Errors: NoRebound.
double least_chi_square_in_fem(const Trial& trial, const std::vector<HiddenEffect>& effects);

/// The noise-free reading of one shot, before clipping and rounding.
std::vector<double> recorded(const NoiseFree& free, std::size_t shot, const Sampling& sampling);

/// What of all forms comes nearest to the effects of a trial.
Rivals rivals_of(const Trial& trial);

}  // namespace trials
