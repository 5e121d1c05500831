#pragma once

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/models/effects/effect_choice.hpp"
#include "lumped/problem/dimension.hpp"
#include "lumped/problem/names.hpp"
#include "lumped/problem/validity.hpp"

namespace rebound {

/// What kind of thing an effect is. Faults of the measurement are rivals of
/// every physical explanation and are never left out of a diagnosis.
enum class EffectKind { elastic, dissipative, inertial, boundary, damping_formula, measurement };

/// What a missing force depends on. Forms of one family are told apart by less than families are.
enum class EffectFamily {
  none,         ///< not said
  elastic,      ///< deflection
  rate,         ///< deflection and its rate now
  memory,       ///< past deflection, fading
  history,      ///< the largest deflection so far, not its rate
  surface,      ///< contact or not, its size
  dynamics,     ///< another mass that moves, or another force on the ball
  measurement,  ///< the measuring chain
};
constexpr auto names_of(EffectFamily) {
  return names_list<EffectFamily>({{"none", EffectFamily::none},
                                   {"elastic", EffectFamily::elastic},
                                   {"rate", EffectFamily::rate},
                                   {"memory", EffectFamily::memory},
                                   {"history", EffectFamily::history},
                                   {"surface", EffectFamily::surface},
                                   {"dynamics", EffectFamily::dynamics},
                                   {"measurement", EffectFamily::measurement}});
}

/// How a further number of an effect is looked for.
enum class ParameterKind {
  logarithmic,  ///< positive; the unknown of a fit is its logarithm
  linear,       ///< of any sign; the unknown is the number itself
  shot,         ///< one of the shots, from 1; no unknown of a fit: a diagnosis tries every shot
  largest_deflection,  ///< over the radius, of all shots; set by a diagnosis
  largest_rate         ///< of all shots; set by a diagnosis
};

/// What the numbers are shares of at which a diagnosis looks: a rig is known by its records.
enum class TriedIn {
  si,
  contact_times,     ///< of the shortest contact
  per_contact_time,  ///< frequencies: swings in the shortest contact
  largest_readings   ///< of the largest force of all records
};

/// A further number of an effect, beside its size.
struct EffectParameterCard {
  std::string name;  ///< TOML key, e.g. "relaxation_time"
  std::string sentence;
  Dimension dimension;
  Range range;  ///< SI
  double default_value = 0.0;
  bool fitted = false;  ///< unknown of a diagnosis; otherwise it stays as given
  /// False: a number of the lumped form alone. In FE nothing fits it, and a file may not change it.
  bool in_fem = true;
  /// At its default no fit looks for it: the model chooses it, or the formula has it so.
  bool is_left_open = false;
  ParameterKind kind = ParameterKind::logarithmic;
  double scale = 1.0;  ///< of a linear one, SI: sets steps of fits
  /// Where a diagnosis looks; empty: decades about the default. Of a number that no fit looks for:
  /// the choices that there are.
  std::vector<double> tried{};
  TriedIn tried_in = TriedIn::si;
  /// No fit goes further: beyond it this is no such effect, whatever a file may say.
  double most_fitted = std::numeric_limits<double>::infinity();
  /// Of a normal prior about the default, for a linear one; 0: none.
  double prior_deviation = 0.0;
};

/// A curve of a free form: what it depends on, and which of the effect's numbers are its points.
struct CurveCard {
  struct Point {
    std::string number;  ///< a parameter; empty: the size
    double place = 0.0;  ///< over the reach
    double sign = 1.0;   ///< of the curve in the number
  };
  std::string of;                   ///< e.g. "deflection_over_radius"
  std::string reach{};              ///< parameter that places are shares of; empty: one
  std::string quantity = "factor";  ///< "factor" is one and the number, any other the number itself
  std::vector<Point> points{};
  /// A number of the law takes the level: the shape is what is found.
  bool level_is_the_laws = false;
  bool is_even = false;          ///< points are evenly spaced in what the curve is smooth over
  bool ends_at_nothing = false;  ///< one point more, at which it is held at zero
};

/// Signs of what an effect of its prior scale does to an FE impact at 15 m/s: 1 up, −1 down,
/// 0 where either may come of it.
struct ImpactChange {
  int peak_force = 0;
  int contact_time = 0;
  int restitution = 0;
};

/// Of an effect that is a mass on a spring. What rings has a narrow valley for every frequency: a
/// diagnosis looks along those that the data can hold, not along the numbers of the card.
struct OscillatorCard {
  /// The effect with a frequency [Hz] and a strength: the mass of the ball [kg] over that of the
  /// plate, or the share of it inside.
  EffectChoice (*with)(double frequency, double strength, double ball_mass);
  double (*frequency_of)(const EffectChoice& choice);  ///< [Hz]
  bool rings_on = false;                               ///< seen when the ball has left
};

/// Of an effect that is two masses on springs in series, as a plate on a frame: found by its two
/// frequencies, which the ringing after contact shows, and not by its own numbers.
struct OscillatorPairCard {
  /// The effect that swings at `slow` and `fast` [Hz]: with the mass of the ball [kg] over that of
  /// the plate, and where between both the plate would swing on a frame that stands still, as a
  /// share of the logarithm.
  EffectChoice (*with)(double slow, double fast, double share, double strength, double ball_mass);
};

/// All that is said of one effect, once. File format, help, diagnosis, tests
/// and report read it.
struct EffectCard {
  std::string name;  ///< e.g. "permanent-set"
  EffectKind kind = EffectKind::elastic;
  EffectFamily family = EffectFamily::none;  ///< must be said
  std::string sentence;                      ///< what it is, for --help and the report
  std::string equation;                      ///< lumped form in one line
  Dimension size_dimension;
  double null = 0.0;                    ///< the size at which the effect is absent
  Range range;                          ///< of the size, SI
  std::optional<Range> range_in_fem{};  ///< of its FE form, where that holds less
  double prior_scale = 0.0;  ///< a size that would surprise nobody; sets steps and starts of fits
  /// Only null and one are meaningful (a formula is exact or not, gravity acts or
  /// not); sizes between interpolate, for derivatives.
  bool is_switch = false;
  std::vector<EffectParameterCard> parameters;
  /// Sizes from which a diagnosis looks; empty: multiples of the prior scale. For effects
  /// that start all at once, so that derivatives at the null say nothing.
  std::vector<double> tried{};
  TriedIn tried_in = TriedIn::si;
  /// What it does is proportional to its size, so that the first order is the whole.
  bool is_linear = false;
  /// Its force is not zero at first touch. When that was is fitted, so that the first order, which
  /// leaves the touch where the baseline has it, says too little.
  bool jumps_at_touch = false;
  /// It grows from shot to shot: no property of a ball at rest, so that it is no name.
  bool follows_shot_order = false;
  /// Seen in the readings themselves: no fit looks for it.
  bool told_by_readings = false;
  /// Of a memory with one time: the parameter in which it fades. Far below a contact it is a
  /// damper, far above it nothing fades.
  std::string fades_in{};
  std::optional<OscillatorCard> oscillator{};  ///< of a mass that swings
  std::optional<OscillatorPairCard> oscillator_pair{};
  std::string signature;   ///< where it shows
  std::string experiment;  ///< what would tell it from its rivals
  std::string source;
  /// Stands for its family where no formula of the list does: never a candidate by its name.
  bool is_free_form = false;
  /// The one effect of the list that a free form is the free form of, where its family has no other
  /// that it could be: to say the free form is to say that effect, by another law.
  std::string free_form_of{};
  /// A free form of so many numbers that it is tried only where no single effect is adequate.
  bool after_single_effects = false;
  std::vector<CurveCard> curves{};  ///< of a free form
  /// Numbers of a free form from which a search begins, too, all others at their defaults: where
  /// what begins from nothing does not find a force that jumps at first touch.
  std::map<std::string, double> begins_from{};
  /// Of a free form that contains others: the same body as a fitted one of those has it, with its
  /// numbers; nothing for other effects. A search starts there too.
  std::optional<EffectChoice> (*from_part)(const EffectChoice& part) = nullptr;
  /// The formula of its family that a free form without curves contains, as a plate on a frame
  /// contains a plate: a search starts there.
  std::string contains{};
  std::optional<ImpactChange>
      moves;  ///< what it moves in FE; must be said where it has a form there

  const Range& range_of_size(bool of_fem) const {
    return of_fem && range_in_fem ? *range_in_fem : range;
  }
};

}  // namespace rebound
