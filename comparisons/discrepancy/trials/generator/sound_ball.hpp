#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "comparisons/discrepancy/trials/generator/trial.hpp"

namespace trials {

/// Records of a ball in finite elements that hides nothing, and how they change with what such a
/// ball may be made of.
///
///   r = F(ball) − F_hidden,  with the slopes of r by its unknowns
///
/// The ball moves; its slopes stay those of where they were taken last (chord method), since one
/// ball is three impacts and its slopes are eighteen.
class SoundBall {
 public:
  enum Unknown : std::size_t {
    log_modulus,
    poisson_ratio,
    branches,   ///< factor on all ratios, less one
    log_times,  ///< of all branches
    slow_branch,
    branch_of_other_kind,  ///< both: shares as MoreBranches has them
    first_law,             ///< how much of each other elastic law, to first order
    gain = first_law + 3,
    offset,     ///< [N]
    first_shot  ///< those of shot j follow from here + 2 j: start [s], logarithm of the speed
  };
  /// Numbers that make another ball.
  static constexpr std::size_t made_of = first_law;
  using Numbers = std::array<double, made_of>;
  /// Slopes by the shared unknowns and the shot's two; the residual last.
  using Row = std::array<double, first_shot + 3>;

  /// Begins at the ball of these numbers, counted from `origin`.
  /// Errors: NoRebound.
  SoundBall(const Trial& trial, FemBall origin, const Numbers& numbers);

  const Numbers& numbers() const { return numbers_; }
  /// Errors: NoRebound; the ball stays as it was.
  void move_to(const Numbers& numbers);
  /// Takes the slopes by the numbers where the ball is now; those by other laws stay.
  /// Errors: NoRebound; the slopes stay as they were.
  void renew_slopes();

  /// At these times, which are those of the data on the clock of each shot.
  void record(const std::vector<Sampling>& samplings);
  const std::vector<double>& force(std::size_t shot) const { return force_[shot]; }
  Row row(std::size_t shot, std::size_t i, double hidden) const;

  /// The ball of each other elastic law, with these numbers.
  const std::vector<FemBall>& other_laws() const { return laws_; }

 private:
  using Records = std::vector<std::vector<double>>;  ///< shot by shot
  struct Slope {
    std::shared_ptr<const NoiseFree> from, to;
    double step;
  };

  NoiseFree simulated(const FemBall& origin, const Numbers& numbers, int cells) const;
  std::shared_ptr<const NoiseFree> coarse(const FemBall& origin, const Numbers& numbers) const;
  Records records_of(const NoiseFree& free) const;

  const Trial& trial_;
  FemBall origin_;
  std::vector<FemBall> laws_;
  Numbers numbers_;
  NoiseFree ball_;
  std::array<Slope, gain> slopes_;  ///< by the unknowns of the ball
  std::vector<Sampling> samplings_;
  Records force_;
  std::array<Records, gain> slopes_recorded_;
};

}  // namespace trials
