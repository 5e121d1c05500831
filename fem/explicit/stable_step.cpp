#include "fem/explicit/stable_step.hpp"

#include <algorithm>
#include <cmath>

#include "fem/explicit/dispersion_correction.hpp"

namespace rebound::fem {
namespace {

constexpr double margin = 0.97;  ///< of a step that is chosen anew, over what the cells allow

}  // namespace

StableStep::StableStep(const CellBatches& cells, const FemControls& controls)
    : safety_(controls.step_safety), largest_(controls.largest_step) {
  const std::vector<double>& frequencies = cells.cell_frequency_squared();
  first_ = capped(margin * allowed(*std::max_element(frequencies.begin(), frequencies.end())));
  before_ = now_ = smallest_ = first_;
}

double StableStep::allowed(double frequency_squared) const {
  return safety_ * DispersionCorrection::step_factor(safety_) * 2.0 / std::sqrt(frequency_squared);
}

double StableStep::capped(double step) const {
  return largest_ > 0.0 ? std::min(step, largest_) : step;
}

void StableStep::choose(double largest_frequency_squared) {
  const double most = allowed(largest_frequency_squared);
  before_ = now_;
  if (most < now_)
    now_ = margin * most;
  else if (most > 1.1 * now_)
    now_ = capped(1.02 * now_);
  smallest_ = std::min(smallest_, now_);
}

}  // namespace rebound::fem
