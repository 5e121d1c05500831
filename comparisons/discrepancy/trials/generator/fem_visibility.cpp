#include <algorithm>
#include <cmath>
#include <numeric>

#include "comparisons/discrepancy/trials/generator/fem_materials.hpp"
#include "comparisons/discrepancy/trials/generator/linear_prediction.hpp"
#include "comparisons/discrepancy/trials/generator/normal_equations.hpp"
#include "comparisons/discrepancy/trials/generator/sound_ball.hpp"

namespace trials {
namespace {

using Records = std::vector<std::vector<double>>;  ///< shot by shot

/// What the cells of a record get wrong [N]: nobody sees what is smaller, however quiet or slow the
/// noise. It is white, as nodes that touch one by one are.
double error_of_mesh(const std::vector<double>& force) {
  constexpr double share = 0.005;  // rms over the peak: half the edge changes so much
  return share * *std::max_element(force.begin(), force.end());
}

/// Rows of a linear problem, kept so that what is left over can be summed.
class LinearProblem {
 public:
  explicit LinearProblem(std::size_t unknowns) : equations_(unknowns) {}

  void add(std::vector<int> places, std::vector<double> slopes, double residual) {
    equations_.add(places, slopes, residual);
    rows_.push_back({std::move(places), std::move(slopes), residual});
  }

  /// The unknowns where Σ r² is least, the first `pinned` of them staying at zero.
  std::vector<double> solution(std::size_t pinned = 0) const {
    constexpr double relaxed = 1e-9;
    NormalEquations equations = equations_;
    for (std::size_t k = 0; k < pinned; ++k) equations.pin(k);
    return equations.step(relaxed);
  }

  /// Σ r² there.
  double left_at(const std::vector<double>& step) const {
    double sum = 0.0;
    for (const auto& [places, slopes, residual] : rows_) {
      double left = residual;
      for (std::size_t k = 0; k < places.size(); ++k) left += slopes[k] * step[places[k]];
      sum += left * left;
    }
    return sum;
  }

 private:
  struct KeptRow {
    std::vector<int> places;
    std::vector<double> slopes;
    double residual;
  };
  NormalEquations equations_;
  std::vector<KeptRow> rows_;
};

/// What a trial shows beside a ball with nothing hidden, whose numbers are unknowns.
LinearProblem problem_of(const Trial& trial, const Records& hidden, const SoundBall& ball) {
  const double gain_uncertainty =
      std::hypot(trial.gain_uncertainty, trial.mass.uncertainty / trial.ball.mass);
  LinearProblem problem(SoundBall::first_shot + 2 * trial.shots.size());
  std::vector<int> shared(SoundBall::first_shot);
  std::iota(shared.begin(), shared.end(), 0);
  for (std::size_t j = 0; j < trial.shots.size(); ++j) {
    std::vector<SoundBall::Row> rows;
    for (std::size_t i = 0; i < hidden[j].size(); ++i) rows.push_back(ball.row(j, i, hidden[j][i]));
    LinearPrediction(trial.noise, error_of_mesh(ball.force(j))).whiten(rows);
    const int own = static_cast<int>(SoundBall::first_shot + 2 * j);
    std::vector<int> places = shared;
    places.insert(places.end(), {own, own + 1});
    for (const SoundBall::Row& row : rows)
      problem.add(places, {row.begin(), row.end() - 1}, row.back());
    problem.add({own + 1}, {trial.shots[j].speed.value / trial.shots[j].speed.uncertainty}, 0.0);
  }
  for (std::size_t k = SoundBall::slow_branch; k < SoundBall::gain; ++k)
    problem.add({static_cast<int>(k)}, {1.0}, k < SoundBall::made_of ? ball.numbers()[k] : 0.0);
  problem.add({SoundBall::gain}, {1.0 / gain_uncertainty}, 0.0);
  problem.add({SoundBall::offset}, {1.0 / trial.noise.deviation}, 0.0);
  return problem;
}

constexpr double too_little_to_show = 5.0;  // in χ², whatever else might take of it

/// Sample, and share of the next, at which a force passes half of its largest.
double rise_of(const std::vector<double>& force) {
  const double half = 0.5 * *std::max_element(force.begin(), force.end());
  const auto above = std::find_if(force.begin(), force.end(), [&](double f) { return f > half; });
  if (above == force.begin()) return 0.0;
  const double before = *(above - 1);
  return static_cast<double>(above - 1 - force.begin()) + (half - before) / (*above - before);
}

/// A ball with nothing hidden that is fitted to what a trial shows, by Gauss and Newton's
/// steps. Looks at what it is given, which must outlive it.
class FittedSoundBall {
 public:
  FittedSoundBall(const Trial& trial, const Records& hidden, const FemBall& origin,
                  const SoundBall::Numbers& numbers, std::vector<Sampling> samplings)
      : trial_(trial),
        hidden_(hidden),
        ball_(trial, origin, numbers),
        samplings_(std::move(samplings)) {
    look();
    settle_starts();
  }

  /// Σ r² that this very ball leaves over, all else fitted to first order.
  double left() const { return left_; }

  /// Goes on while that falls, with new slopes where the old ones help no more.
  void fit() {
    constexpr int most_rounds = 8, most_renewals = 1;
    constexpr double worth_a_round = 0.7, settled = 0.05;  // of a sample
    int renewals = 0;
    for (int round = 0; round < most_rounds && left_ > too_little_to_show; ++round) {
      const double before = left_;
      double moved = 0.0;
      const bool helps = step(moved);
      if (helps && (left_ < worth_a_round * before || moved > settled)) continue;
      if (renewals++ == most_renewals || !renewed()) return;
    }
  }

  const SoundBall::Numbers& numbers() const { return ball_.numbers(); }
  const std::vector<Sampling>& samplings() const { return samplings_; }

  /// The other elastic law that would take most; null where that is less than 0.3 of one.
  const FemBall* law_worth_a_look() const {
    constexpr double worth_a_look = 0.3;
    const auto first = beside_ball_.begin() + SoundBall::first_law;
    const auto most = std::max_element(first, beside_ball_.begin() + SoundBall::gain);
    return *most > worth_a_look ? &ball_.other_laws()[static_cast<std::size_t>(most - first)]
                                : nullptr;
  }

 private:
  /// Starts that are plainly elsewhere are moved to where the forces rise together: to first order
  /// one that is off by many samples misleads every other number.
  void settle_starts() {
    constexpr double plainly_elsewhere = 5.0;  // samples
    bool moved = false;
    for (std::size_t j = 0; j < samplings_.size(); ++j) {
      const double later = rise_of(hidden_[j]) - rise_of(ball_.force(j));
      if (std::abs(later) < plainly_elsewhere) continue;
      samplings_[j].first_time -= later / samplings_[j].rate;
      moved = true;
    }
    if (moved) look();
  }

  /// Returns how far the farthest moves [samples].
  double move_starts(const std::vector<double>& next, double share) {
    double moved = 0.0;
    for (std::size_t j = 0; j < samplings_.size(); ++j) {
      const double start = share * next[SoundBall::first_shot + 2 * j];
      samplings_[j].first_time -= start;
      moved = std::max(moved, std::abs(start) * samplings_[j].rate);
    }
    return moved;
  }

  bool renewed() try {
    ball_.renew_slopes();
    look();
    return true;
  } catch (const NoRebound&) {
    return false;
  }

  void look() {
    ball_.record(samplings_);
    const LinearProblem problem = problem_of(trial_, hidden_, ball_);
    beside_ball_ = problem.solution(SoundBall::made_of);
    left_ = problem.left_at(beside_ball_);
    next_ = problem.solution();
  }

  /// One step, shorter where it does not help; false where none does.
  bool step(double& samples_moved) {
    const SoundBall::Numbers numbers = ball_.numbers();
    const std::vector<Sampling> samplings = samplings_;
    const std::vector<double> next = next_;
    const double left = left_;
    for (const double share : {1.0, 0.3, 0.1}) {
      try {
        samples_moved = move(numbers, samplings, next, share);
        if (left_ < left) return true;
      } catch (const NoRebound&) {  // too far
      }
    }
    ball_.move_to(numbers);
    samplings_ = samplings;
    look();
    return false;
  }

  double move(const SoundBall::Numbers& from, const std::vector<Sampling>& samplings,
              const std::vector<double>& next, double share) {
    constexpr SoundBall::Numbers farthest = {0.3, 0.05, 0.5, 0.7, 1.0, 1.0};
    SoundBall::Numbers numbers = from;
    for (std::size_t k = 0; k < numbers.size(); ++k)
      numbers[k] += share * std::clamp(next[k], -farthest[k], farthest[k]);
    samplings_ = samplings;
    const double moved = move_starts(next, share);
    ball_.move_to(numbers);
    look();
    return moved;
  }

  const Trial& trial_;
  const Records& hidden_;
  SoundBall ball_;
  std::vector<Sampling> samplings_;
  std::vector<double> beside_ball_;  ///< all else, the ball as it is
  std::vector<double> next_;         ///< the next step
  double left_ = 0.0;
};

}  // namespace

double visible_chi_square_in_fem(const Trial& trial, const std::vector<HiddenEffect>& effects) {
  if (effects.empty()) return 0.0;
  const NoiseFree free = simulate_trial(trial, effects);
  Records hidden;
  for (std::size_t j = 0; j < trial.shots.size(); ++j) {
    hidden.push_back(recorded(free, j, free.samplings[j]));
    digitise(free.world.chain, hidden.back());
  }
  FittedSoundBall fitted(trial, hidden, trial.fem, {}, free.samplings);
  fitted.fit();
  if (fitted.left() < too_little_to_show) return fitted.left();
  const FemBall* law = fitted.law_worth_a_look();
  if (law == nullptr) return fitted.left();
  try {
    FittedSoundBall other(trial, hidden, *law, fitted.numbers(), fitted.samplings());
    other.fit();
    return std::min(fitted.left(), other.left());
  } catch (const NoRebound&) {
    return fitted.left();
  }
}

}  // namespace trials
