#pragma once

#include <string>
#include <utility>

#include "comparisons/models/effects/effect.hpp"

/// Further numbers of effects that are a factor on the elastic force.
namespace rebound {

/// Does the damping force follow the factor? Laws differ in it: Hunt and Crossley's damping grows
/// with the elastic force, Tsuji's does not. A diagnosis tries both.
inline EffectParameterCard damping_share_number() {
  return {.name = "damping_share",
          .sentence = "Share in which the damping force follows the factor.",
          .dimension = dimension::none,
          .range = from_to(0.0, 1.0),
          .default_value = 0.0,
          .in_fem = false,  // branches follow all of the elastic stress there
          .kind = ParameterKind::linear,
          .tried = {0.0, 1.0}};
}

/// Number of the shape of a factor. At its default no fit looks for it; a search from other numbers
/// does.
inline EffectParameterCard shape_number(std::string name, std::string sentence, const Range& range,
                                        double default_value, std::vector<double> tried) {
  return {.name = std::move(name),
          .sentence = std::move(sentence),
          .dimension = dimension::none,
          .range = range,
          .default_value = default_value,
          .fitted = true,
          .in_fem = false,
          .is_left_open = true,
          .tried = std::move(tried)};
}

/// The number `factor` of both forces: of the elastic one as it is, of the damping force as far as
/// it follows.
inline void set_factor(const EffectChoice& choice, double ElasticFactors::*factor,
                       LumpedProblem& problem) {
  Mechanisms& mechanisms = problem.model.mechanisms;
  mechanisms.elastic.*factor = choice.size;
  mechanisms.damping.elastic.*factor = choice.parameters.at("damping_share") * choice.size;
}

/// A number of the factor's shape, the same for both forces.
inline void set_shape(double value, double ElasticFactors::*number, LumpedProblem& problem) {
  problem.model.mechanisms.elastic.*number = value;
  problem.model.mechanisms.damping.elastic.*number = value;
}

}  // namespace rebound
