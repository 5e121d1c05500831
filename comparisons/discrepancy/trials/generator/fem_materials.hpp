#pragma once

#include <vector>

#include "comparisons/discrepancy/trials/generator/fem_ball.hpp"
#include "comparisons/discrepancy/trials/generator/random.hpp"

namespace trials {

/// What balls that hide nothing are made of: name, elastic law, Poisson ratio, kind of branches.
/// Modulus, ratios and times are drawn for each trial.
const std::vector<FemBall>& fem_materials();

/// One of them with its numbers. Its branches have faded within an eighth of the contact time: they
/// are loss, and no memory that a diagnosis of impacts could see as such.
///
///   modulus       long-term [Pa]
///   contact_time  about that of the middle speed [s]
FemBall draw_material(double modulus, double contact_time, const FemBall& kind, Random& random);

/// Branches that a ball with nothing hidden may have beside its own, as shares of half of the
/// largest that are drawn.
struct MoreBranches {
  double slow = 0.0;
  double of_other_kind = 0.0;  ///< of the deviator, where the first is of all stress; else of that
};

/// The ball with them; a ratio does not go below zero.
FemBall with_more_branches(FemBall ball, double contact_time, const MoreBranches& more);

/// The ball of each other elastic law of fem_materials().
std::vector<FemBall> other_laws_of(const FemBall& ball);

}  // namespace trials
