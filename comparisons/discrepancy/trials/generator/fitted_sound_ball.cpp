#include "comparisons/discrepancy/trials/generator/fitted_sound_ball.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "comparisons/discrepancy/trials/generator/linear_prediction.hpp"
#include "comparisons/discrepancy/trials/generator/normal_equations.hpp"

namespace trials {
namespace {

constexpr double hardly_relaxed = 1e-9;

/// What the cells of a record get wrong [N]: nobody sees what is smaller, however quiet or slow the
/// noise. It is white, as nodes that touch one by one are.
double error_of_mesh(const std::vector<double>& force) {
  constexpr double share = 0.005;  // rms over the peak: half the edge changes so much
  return share * *std::max_element(force.begin(), force.end());
}

/// Sample, and share of the next, at which a force passes half of its largest.
double rise_of(const std::vector<double>& force) {
  const double half = 0.5 * *std::max_element(force.begin(), force.end());
  const auto above = std::find_if(force.begin(), force.end(), [&](double f) { return f > half; });
  if (above == force.begin()) return 0.0;
  const double before = *(above - 1);
  return static_cast<double>(above - 1 - force.begin()) + (half - before) / (*above - before);
}

}  // namespace

/// Rows of a linear problem, kept so that what is left over can be summed.
class FittedSoundBall::LinearProblem {
 public:
  explicit LinearProblem(std::size_t unknowns) : equations_(unknowns) {}

  void add(std::vector<int> places, std::vector<double> slopes, double residual) {
    equations_.add(places, slopes, residual);
    rows_.push_back({std::move(places), std::move(slopes), residual});
  }

  /// The unknowns where Σ r² is least, the first `pinned` of them staying at zero.
  std::vector<double> solution(std::size_t pinned, double relaxed = hardly_relaxed) const {
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
FittedSoundBall::LinearProblem FittedSoundBall::problem_of(const Trial& trial,
                                                           const Records& hidden,
                                                           const SoundBall& ball) {
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

FittedSoundBall::FittedSoundBall(const Trial& trial, const Records& hidden, const FemBall& origin,
                                 const SoundBall::Numbers& numbers, std::vector<Sampling> samplings)
    : trial_(trial),
      hidden_(hidden),
      ball_(trial, origin, numbers),
      samplings_(std::move(samplings)) {
  look();
  settle_starts();
}

FittedSoundBall::~FittedSoundBall() = default;

void FittedSoundBall::approach() {
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

void FittedSoundBall::settle() {
  constexpr int most_rounds = 60;
  constexpr double worth_a_round = 0.97;
  bool slopes_are_new = false;
  for (int round = 0; round < most_rounds && left_ > too_little_to_show; ++round) {
    const double before = left_;
    const bool helps = damped_step() && left_ < worth_a_round * before;
    if (!helps && (slopes_are_new || !renewed())) return;
    slopes_are_new = !helps;
  }
}

const FemBall* FittedSoundBall::law_worth_a_look() const {
  constexpr double worth_a_look = 0.3;
  const auto first = beside_ball_.begin() + SoundBall::first_law;
  const auto most = std::max_element(first, beside_ball_.begin() + SoundBall::gain);
  return *most > worth_a_look ? &ball_.other_laws()[static_cast<std::size_t>(most - first)]
                              : nullptr;
}

/// Starts that are plainly elsewhere are moved to where the forces rise together: to first order
/// one that is off by many samples misleads every other number.
void FittedSoundBall::settle_starts() {
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

bool FittedSoundBall::renewed() try {
  ball_.renew_slopes();
  look();
  return true;
} catch (const NoRebound&) {
  return false;
}

void FittedSoundBall::look() {
  ball_.record(samplings_);
  problem_ = std::make_unique<const LinearProblem>(problem_of(trial_, hidden_, ball_));
  beside_ball_ = problem_->solution(SoundBall::made_of);
  left_ = problem_->left_at(beside_ball_);
}

void FittedSoundBall::return_to(const Place& place) {
  ball_.move_to(place.numbers);
  samplings_ = place.samplings;
  look();
}

/// One step, shorter where it does not help; false where none does. Says how far the farthest start
/// moves [samples].
bool FittedSoundBall::step(double& samples_moved) {
  const Place from = place();
  const std::vector<double> next = problem_->solution(0);
  const double left = left_;
  for (const double share : {1.0, 0.3, 0.1}) {
    try {
      samples_moved = move(from, next, share);
      if (left_ < left) return true;
    } catch (const NoRebound&) {  // too far
    }
  }
  return_to(from);
  return false;
}

/// One step, more damped where it does not help; false where none does.
bool FittedSoundBall::damped_step() {
  const Place from = place();
  const auto problem = std::move(problem_);
  const double left = left_;
  for (const double relaxed : {hardly_relaxed, 0.01, 0.1, 1.0, 10.0}) {
    try {
      move(from, problem->solution(0, relaxed), 1.0);
      if (left_ < left) return true;
    } catch (const NoRebound&) {  // too far
    }
  }
  return_to(from);
  return false;
}

double FittedSoundBall::move(const Place& from, const std::vector<double>& next, double share) {
  constexpr SoundBall::Numbers farthest = {0.3, 0.05, 0.5, 0.7, 1.0, 1.0};
  SoundBall::Numbers numbers = from.numbers;
  for (std::size_t k = 0; k < numbers.size(); ++k)
    numbers[k] += share * std::clamp(next[k], -farthest[k], farthest[k]);
  samplings_ = from.samplings;
  double moved = 0.0;
  for (std::size_t j = 0; j < samplings_.size(); ++j) {
    const double start = share * next[SoundBall::first_shot + 2 * j];
    samplings_[j].first_time -= start;
    moved = std::max(moved, std::abs(start) * samplings_[j].rate);
  }
  ball_.move_to(numbers);
  look();
  return moved;
}

}  // namespace trials
