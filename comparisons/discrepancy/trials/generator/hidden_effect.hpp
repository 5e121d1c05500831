#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "comparisons/discrepancy/trials/generator/fem_ball.hpp"
#include "comparisons/discrepancy/trials/generator/impact_model.hpp"
#include "comparisons/discrepancy/trials/generator/measuring_chain.hpp"

namespace trials {

/// What a trial consists of besides its statements: the impact and the measuring chain.
struct HiddenWorld {
  ImpactModel impact;
  FemBall fem;  ///< in place of the impact's law, for a ball in finite elements
  MeasuringChain chain;
};

/// Typical values of a trial's baseline impacts, by which effects are scaled.
struct Scales {
  double radius = 0.0;        ///< [m]
  double deflection = 0.0;    ///< largest, at the highest speed [m]
  double force = 0.0;         ///< peak at the highest speed [N]
  double speed = 0.0;         ///< geometric mean of lowest and highest [m/s]
  double contact_time = 0.0;  ///< at that speed [s]
  double largest_speed = 0.0;
  double smallest_speed = 0.0;
  int shots = 1;
};

/// A secondary number of an effect, drawn uniformly in the logarithm or in itself.
struct SecondaryRange {
  std::string name;
  double from = 0.0;
  double to = 0.0;
  bool in_itself = false;
};

using Parameters = std::map<std::string, double>;

/// One mathematical form of one effect. At size 0 it leaves the baseline as it is.
struct EffectForm {
  std::string family;
  std::string name;
  std::string formula;
  double smallest = 0.0;  ///< range of the absolute size
  double largest = 0.0;
  bool either_sign = false;
  std::vector<SecondaryRange> secondary{};
  /// The effect of the project's list that this one is, or comes nearest to; empty: none.
  std::string registry_name{};
  /// Is the form exactly that of the project's list?
  bool in_registry = false;
  /// True for a form that equals the listed one only at the largest size, a full replacement.
  bool only_at_largest = false;
  std::function<void(double size, const Parameters&, const Scales&, HiddenWorld&)> apply;
  /// The size in the units of the project's list; empty: the same number.
  std::function<double(double size, const Scales&)> registry_size{};
};

/// An effect with the numbers it has in one trial.
struct HiddenEffect {
  const EffectForm* form = nullptr;
  double size = 0.0;
  Parameters parameters{};
  double visible_alone = 0.0;  ///< χ² with this effect alone

  bool in_registry() const;
};

void apply(const HiddenEffect& effect, const Scales& scales, HiddenWorld& world);

std::vector<EffectForm> elastic_forms();
std::vector<EffectForm> rate_forms();
std::vector<EffectForm> memory_forms();
std::vector<EffectForm> history_forms();
std::vector<EffectForm> surface_forms();
std::vector<EffectForm> dynamics_forms();
std::vector<EffectForm> measurement_forms();
std::vector<EffectForm> out_of_family_forms();

/// All forms: the one list.
const std::vector<EffectForm>& all_forms();

/// Forms of one family.
std::vector<const EffectForm*> forms_of(const std::string& family);

/// Forms that a ball in finite elements hides, and those of the measurement.
const std::vector<EffectForm>& all_fem_forms();
std::vector<const EffectForm*> fem_forms_of(const std::string& family);

}  // namespace trials
