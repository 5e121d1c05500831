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

/// How else a ball near this one may be made with nothing hidden, one change each: a slower branch
/// more, a branch of the other kind more (of the deviator, or of all stress), each other law.
std::vector<FemBall> sound_balls_near(const FemBall& ball, double contact_time);

}  // namespace trials
