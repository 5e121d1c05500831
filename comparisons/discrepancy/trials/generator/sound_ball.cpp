#include "comparisons/discrepancy/trials/generator/sound_ball.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "comparisons/discrepancy/trials/generator/fem_materials.hpp"

namespace trials {
namespace {

/// Fewer than those of records: a slope that is a little off makes a fit slower, not wrong.
constexpr int cells_of_slopes = 600;
/// Poisson ratios that plain bilinear cells take.
constexpr double least_poisson_ratio = 0.05, most_poisson_ratio = 0.47;

FemBall ball_of(FemBall ball, const SoundBall::Numbers& numbers, double contact_time) {
  ball.modulus *= std::exp(numbers[SoundBall::log_modulus]);
  ball.poisson_ratio = std::clamp(ball.poisson_ratio + numbers[SoundBall::poisson_ratio],
                                  least_poisson_ratio, most_poisson_ratio);
  for (FemBranch& branch : ball.branches) {
    branch.ratio *= std::max(0.0, 1.0 + numbers[SoundBall::branches]);
    branch.time *= std::exp(numbers[SoundBall::log_times]);
  }
  return with_more_branches(std::move(ball), contact_time,
                            {.slow = numbers[SoundBall::slow_branch],
                             .of_other_kind = numbers[SoundBall::branch_of_other_kind]});
}

}  // namespace

SoundBall::SoundBall(const Trial& trial, FemBall origin, const Numbers& numbers)
    : trial_(trial),
      origin_(std::move(origin)),
      laws_(other_laws_of(origin_)),
      numbers_(numbers),
      ball_(simulated(origin_, numbers, cells_of_visibility)) {
  renew_slopes();
  for (std::size_t k = 0; k < laws_.size(); ++k)
    slopes_[first_law + k] = {slopes_.front().from, coarse(laws_[k], numbers), 1.0};
}

void SoundBall::renew_slopes() {
  constexpr Numbers steps = {0.01, -0.01, 0.05, 0.05, 1.0, 1.0};
  std::array<Slope, gain> slopes = slopes_;
  const auto from = coarse(origin_, numbers_);
  for (std::size_t k = 0; k < made_of; ++k) {
    Numbers other = numbers_;
    other[k] += steps[k];
    slopes[k] = {from, coarse(origin_, other), steps[k]};
  }
  slopes_ = std::move(slopes);
}

std::shared_ptr<const NoiseFree> SoundBall::coarse(const FemBall& origin,
                                                   const Numbers& numbers) const {
  return std::make_shared<const NoiseFree>(simulated(origin, numbers, cells_of_slopes));
}

NoiseFree SoundBall::simulated(const FemBall& origin, const Numbers& numbers, int cells) const {
  Trial other = trial_;
  other.fem = ball_of(origin, numbers, trial_.scales.contact_time);
  return simulate_in_fem(other, {}, cells);
}

void SoundBall::move_to(const Numbers& numbers) {
  ball_ = simulated(origin_, numbers, cells_of_visibility);
  numbers_ = numbers;
}

SoundBall::Records SoundBall::records_of(const NoiseFree& free) const {
  Records records;
  for (std::size_t j = 0; j < free.impacts.size(); ++j)
    records.push_back(recorded(free, j, samplings_[j]));
  return records;
}

void SoundBall::record(const std::vector<Sampling>& samplings) {
  samplings_ = samplings;
  force_ = records_of(ball_);
  std::map<const NoiseFree*, Records> known;  // one ball is where many slopes begin
  for (std::size_t k = 0; k < slopes_.size(); ++k) {
    const auto [place, is_new] = known.try_emplace(slopes_[k].from.get());
    if (is_new) place->second = records_of(*slopes_[k].from);
    const Records& from = place->second;
    Records records = records_of(*slopes_[k].to);
    for (std::size_t j = 0; j < records.size(); ++j)
      for (std::size_t i = 0; i < records[j].size(); ++i)
        records[j][i] = (records[j][i] - from[j][i]) / slopes_[k].step;
    slopes_recorded_[k] = std::move(records);
  }
}

SoundBall::Row SoundBall::row(std::size_t shot, std::size_t i, double hidden) const {
  const std::vector<double>& force = force_[shot];
  const Sampling& sampling = samplings_[shot];
  const std::size_t before = i == 0 ? 0 : i - 1, after = std::min(i + 1, force.size() - 1);
  const double slope =
      (force[after] - force[before]) * sampling.rate / static_cast<double>(after - before);
  const double time = sampling.first_time + static_cast<double>(i) / sampling.rate;
  Row row;
  for (std::size_t k = 0; k < gain; ++k) row[k] = slopes_recorded_[k][shot][i];
  row[gain] = force[i] / trial_.true_gain;
  row[offset] = 1.0;
  row[first_shot] = -slope;
  // By the logarithm of the speed as a Hertzian impact changes: F as v^1.2, time as v^-0.2.
  row[first_shot + 1] = 1.2 * force[i] + 0.2 * time * slope;
  row.back() = force[i] - hidden;
  return row;
}

}  // namespace trials
