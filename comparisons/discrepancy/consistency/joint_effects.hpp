#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparisons/discrepancy/consistency/scalar_diagnosis.hpp"
#include "lumped/problem/names.hpp"

namespace rebound {

/// Which numbers of an effect several balls have in common.
enum class InCommon {
  nothing,       ///< each ball has its own
  all_but_size,  ///< a size of each ball
  everything,    ///< one size for all balls
};
constexpr auto names_of(InCommon) {
  return names_list<InCommon>({{"nothing", InCommon::nothing},
                               {"all-but-size", InCommon::all_but_size},
                               {"everything", InCommon::everything}});
}

/// How far several balls are from data that were fitted, and from a speed that no fit saw.
struct JointGap {
  ScalarGap all;                          ///< over all balls
  std::vector<double> unseen_of_balls{};  ///< Σ r² over the data of each at that speed
};

/// One effect in all balls, with that much in common.
struct JointVariant {
  InCommon in_common{};
  std::vector<EffectChoice> of_balls;  ///< with fitted numbers
  std::vector<Material> materials;     ///< fitted beside it, of each ball
  double numbers = 0.0;                ///< k: fitted numbers of the effect
  double chi_square = 0.0;             ///< Σ r² over data and priors of all balls
  double information_criterion = 0.0;  ///< χ²/s + k ln N
  JointGap gap;
};

/// One effect in all balls, and how much of it they have in common.
struct JointEffect {
  std::string name;
  EffectFamily family{};
  std::vector<JointVariant> variants;  ///< least criterion first

  const JointVariant& chosen() const { return variants.front(); }
};

/// Several balls without an effect more, and with one; none of it has seen the middle speed.
struct JointEffects {
  JointGap believed;
  std::vector<JointEffect> effects;  ///< least criterion first
  /// s: reduced χ² of the closest of all, where it is above one. Errors are taken to be as large as
  /// it leaves them: a number more is not bought by what no number explains.
  double scale = 1.0;
};

/// The effects that came nearest apart, in all balls together.
///
///   nothing in common   the fits apart, taken together
///   one size            one fit of all balls, each with its own material, that starts from them
///
/// Between them stands, of an effect with further numbers, a size of every ball with all else in
/// common. The criterion χ²/s + k ln N chooses, N the scalars of all balls. An effect that acts on
/// one shot is no effect of all balls.
///
/// Valid:   two balls or more.
/// Limit:   two balls of FE with one effect of one size: it is first, and its size is one; with two
///          sizes each ball keeps its own -> test JointScalarsTest.OneHiddenSizeIsFoundAsOne,
///          JointScalarsTest.TwoHiddenSizesStayTwo.
/// Errors:  Error(interrupted); effects without an answer are left out.
JointEffects try_effects_jointly(const std::vector<const FitsOfEffects*>& apart,
                                 const RunControl& control = {});

}  // namespace rebound
