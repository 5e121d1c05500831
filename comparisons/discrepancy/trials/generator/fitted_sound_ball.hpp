#pragma once

#include <memory>
#include <vector>

#include "comparisons/discrepancy/trials/generator/sound_ball.hpp"

namespace trials {

inline constexpr double too_little_to_show = 5.0;  // in χ², whatever else might take of it

/// A ball with nothing hidden that is fitted to what a trial shows, by Gauss and Newton's steps.
/// Looks at what it is given, which must outlive it.
class FittedSoundBall {
 public:
  using Records = std::vector<std::vector<double>>;  ///< shot by shot

  /// Begins at the ball of these numbers, counted from `origin`.
  /// Errors: NoRebound.
  FittedSoundBall(const Trial& trial, const Records& hidden, const FemBall& origin,
                  const SoundBall::Numbers& numbers, std::vector<Sampling> samplings);
  ~FittedSoundBall();

  /// Σ r² that this very ball leaves over, all else fitted to first order.
  double left() const { return left_; }

  /// A few steps, with new slopes once where the old ones help no more: how large an effect has to
  /// be is searched with these.
  void approach();

  /// Steps until none helps with new slopes, damped after Levenberg and Marquardt.
  void settle();

  const SoundBall::Numbers& numbers() const { return ball_.numbers(); }
  const std::vector<Sampling>& samplings() const { return samplings_; }
  const std::vector<FemBall>& other_laws() const { return ball_.other_laws(); }

  /// The other elastic law that would take most; null where that is less than 0.3 of one.
  const FemBall* law_worth_a_look() const;

 private:
  class LinearProblem;
  struct Place {
    SoundBall::Numbers numbers;
    std::vector<Sampling> samplings;
  };

  static LinearProblem problem_of(const Trial& trial, const Records& hidden, const SoundBall& ball);
  void look();
  void settle_starts();
  bool renewed();
  Place place() const { return {numbers(), samplings_}; }
  void return_to(const Place& place);
  bool step(double& samples_moved);
  bool damped_step();
  double move(const Place& from, const std::vector<double>& next, double share);

  const Trial& trial_;
  const Records& hidden_;
  SoundBall ball_;
  std::vector<Sampling> samplings_;
  std::unique_ptr<const LinearProblem> problem_;
  std::vector<double> beside_ball_;  ///< all else, the ball as it is
  double left_ = 0.0;
};

}  // namespace trials
