#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "comparisons/discrepancy/trials/generator/fem_materials.hpp"
#include "comparisons/discrepancy/trials/generator/linear_prediction.hpp"
#include "comparisons/discrepancy/trials/generator/normal_equations.hpp"
#include "comparisons/discrepancy/trials/generator/trial.hpp"

namespace trials {
namespace {

/// Numbers of the ball, and shares of what makes it another sound one (sound_balls_near).
constexpr std::size_t other_balls = 5;
/// Places of the unknowns; those of shot j follow from first_of_shot + 2 j.
enum Unknown : std::size_t {
  log_modulus,
  poisson_ratio,
  branches,
  log_times,
  first_share,
  gain = first_share + other_balls,
  offset,
  first_of_shot
};
constexpr std::array of_the_ball = {log_modulus, poisson_ratio, branches, log_times};

/// Slopes by the shared unknowns and the shot's two; the residual last.
using Row = std::array<double, first_of_shot + 3>;
using Records = std::vector<std::vector<double>>;  ///< shot by shot

/// The ball with nothing hidden, one of its numbers changed by `step`.
Trial changed(Trial trial, Unknown which, double step) {
  FemBall& ball = trial.fem;
  if (which == log_modulus) ball.modulus *= std::exp(step);
  if (which == poisson_ratio) ball.poisson_ratio += step;
  if (which == branches)
    for (FemBranch& branch : ball.branches) branch.ratio *= 1.0 + step;
  if (which == log_times)
    for (FemBranch& branch : ball.branches) branch.time *= std::exp(step);
  return trial;
}

/// Records with nothing hidden, and their change by a number of the ball.
class NothingHidden {
 public:
  explicit NothingHidden(const Trial& trial) : trial_(trial), ball_(simulate_trial(trial, {})) {
    constexpr std::array<double, of_the_ball.size()> steps = {0.01, -0.01, 0.05, 0.05};
    for (const Unknown which : of_the_ball)
      add(changed(trial, which, steps[which]), which, steps[which]);
    Trial other = trial;
    std::size_t place = first_share;
    for (FemBall& ball : sound_balls_near(trial.fem, trial.scales.contact_time)) {
      other.fem = std::move(ball);
      add(other, place++, 1.0);
    }
  }

  /// At these times, which are those of the data on the clock of each shot.
  void record(const std::vector<Sampling>& samplings) {
    samplings_ = samplings;
    force_ = records_of(ball_);
    for (const OtherBall& other : others_) slopes_[other.place] = slopes_to(other);
  }

  const std::vector<double>& force(std::size_t shot) const { return force_[shot]; }

  Row row(std::size_t shot, std::size_t i, double hidden) const {
    const std::vector<double>& force = force_[shot];
    const Sampling& sampling = samplings_[shot];
    const std::size_t before = i == 0 ? 0 : i - 1, after = std::min(i + 1, force.size() - 1);
    const double slope =
        (force[after] - force[before]) * sampling.rate / static_cast<double>(after - before);
    const double time = sampling.first_time + static_cast<double>(i) / sampling.rate;
    Row row;
    for (std::size_t k = 0; k < slopes_.size(); ++k) row[k] = slopes_[k][shot][i];
    row[gain] = force[i] / trial_.true_gain;
    row[offset] = 1.0;
    row[first_of_shot] = -slope;
    // By the logarithm of the speed as a Hertzian impact changes: F as v^1.2, time as v^-0.2.
    row[first_of_shot + 1] = 1.2 * force[i] + 0.2 * time * slope;
    row.back() = force[i] - hidden;
    return row;
  }

 private:
  struct OtherBall {
    NoiseFree impacts;
    std::size_t place;  ///< of the unknown in which it differs
    double step;
  };

  void add(const Trial& other, std::size_t place, double step) {
    others_.push_back({simulate_trial(other, {}), place, step});
  }

  Records records_of(const NoiseFree& free) const {
    Records records;
    for (std::size_t j = 0; j < free.impacts.size(); ++j)
      records.push_back(recorded(free, j, samplings_[j]));
    return records;
  }

  Records slopes_to(const OtherBall& other) const {
    Records records = records_of(other.impacts);
    for (std::size_t j = 0; j < records.size(); ++j)
      for (std::size_t i = 0; i < records[j].size(); ++i)
        records[j][i] = (records[j][i] - force_[j][i]) / other.step;
    return records;
  }

  const Trial& trial_;
  NoiseFree ball_;
  std::vector<OtherBall> others_;
  std::vector<Sampling> samplings_;
  Records force_;
  std::array<Records, gain> slopes_;  ///< by the unknowns of the ball
};

/// σ over √(σ² + e²), e what the cells of these records get wrong: nobody sees what is smaller,
/// however quiet the record.
double weight_beside_mesh(const Noise& noise, const std::vector<double>& force) {
  constexpr double error_of_mesh = 0.005;  // rms over the peak: half the edge changes so much
  const double peak = *std::max_element(force.begin(), force.end());
  return noise.deviation / std::hypot(noise.deviation, error_of_mesh * peak);
}

/// Rows of a linear problem, kept so that what is left over can be summed.
class LinearProblem {
 public:
  explicit LinearProblem(std::size_t unknowns) : equations_(unknowns) {}

  void add(std::vector<int> places, std::vector<double> slopes, double residual) {
    equations_.add(places, slopes, residual);
    rows_.push_back({std::move(places), std::move(slopes), residual});
  }

  /// The unknowns where Σ r² is least.
  std::vector<double> solution() const {
    constexpr double relaxed = 1e-9;
    return equations_.step(relaxed);
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
LinearProblem problem_of(const Trial& trial, const std::vector<std::vector<double>>& hidden,
                         const NothingHidden& nothing) {
  const LinearPrediction prediction(trial.noise);
  const double gain_uncertainty =
      std::hypot(trial.gain_uncertainty, trial.mass.uncertainty / trial.ball.mass);
  LinearProblem problem(first_of_shot + 2 * trial.shots.size());
  std::vector<int> shared(first_of_shot);
  std::iota(shared.begin(), shared.end(), 0);
  for (std::size_t j = 0; j < trial.shots.size(); ++j) {
    std::vector<Row> rows;
    for (std::size_t i = 0; i < hidden[j].size(); ++i)
      rows.push_back(nothing.row(j, i, hidden[j][i]));
    prediction.whiten(rows);
    const double weight = weight_beside_mesh(trial.noise, nothing.force(j));
    for (Row& row : rows)
      for (double& one : row) one *= weight;
    const int own = static_cast<int>(first_of_shot + 2 * j);
    std::vector<int> places = shared;
    places.insert(places.end(), {own, own + 1});
    for (const Row& row : rows) problem.add(places, {row.begin(), row.end() - 1}, row.back());
    problem.add({own + 1}, {trial.shots[j].speed.value / trial.shots[j].speed.uncertainty}, 0.0);
  }
  for (std::size_t k = 0; k < other_balls; ++k)
    problem.add({static_cast<int>(first_share + k)}, {1.0}, 0.0);
  problem.add({gain}, {1.0 / gain_uncertainty}, 0.0);
  problem.add({offset}, {1.0 / trial.noise.deviation}, 0.0);
  return problem;
}

/// Moves the starts of shots to where a solution has them; false where none moves by more than this
/// many samples.
bool move_starts(const std::vector<double>& solution, double samples,
                 std::vector<Sampling>& samplings) {
  bool moved = false;
  for (std::size_t j = 0; j < samplings.size(); ++j)
    if (const double start = solution[first_of_shot + 2 * j];
        std::abs(start) * samplings[j].rate > samples) {
      samplings[j].first_time -= start;
      moved = true;
    }
  return moved;
}

}  // namespace

double visible_chi_square_in_fem(const Trial& trial, const std::vector<HiddenEffect>& effects) {
  if (effects.empty()) return 0.0;
  const NoiseFree free = simulate_trial(trial, effects);
  std::vector<std::vector<double>> hidden;
  for (std::size_t j = 0; j < trial.shots.size(); ++j) {
    hidden.push_back(recorded(free, j, free.samplings[j]));
    digitise(free.world.chain, hidden.back());
  }
  NothingHidden nothing(trial);
  std::vector<Sampling> samplings = free.samplings;
  constexpr int most_rounds = 12;
  constexpr double plainly_moved = 2.0, settled = 0.05;  // samples: the first order holds within
  double left = 0.0;
  for (int round = 0; round < most_rounds; ++round) {
    nothing.record(samplings);
    const LinearProblem problem = problem_of(trial, hidden, nothing);
    const std::vector<double> solution = problem.solution();
    left = problem.left_at(solution);
    if (!move_starts(solution, round == 0 ? plainly_moved : settled, samplings)) break;
  }
  return left;
}

}  // namespace trials
