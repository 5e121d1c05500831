#include "fem/impact/impulse_bins.hpp"

#include <algorithm>

namespace rebound::fem {

ImpulseBins::ImpulseBins(double interval, std::size_t expected_samples) : interval_(interval) {
  half_bins_.reserve(2 * expected_samples);
}

void ImpulseBins::add(double impulse, double start, double end) {
  if (impulse == 0.0) return;
  total_ += impulse;
  start = std::max(start, 0.0);
  const double half = 0.5 * interval_;
  const double rate = impulse / (end - start);
  double from = start;
  while (from < end) {
    auto bin = static_cast<std::size_t>(from / half);
    double to = static_cast<double>(bin + 1) * half;
    if (to <= from) to = static_cast<double>(++bin + 1) * half;  // `from` sits on an edge
    to = std::min(to, end);
    if (half_bins_.size() <= bin) half_bins_.resize(bin + 1, 0.0);
    half_bins_[bin] += rate * (to - from);
    from = to;
  }
}

std::vector<double> ImpulseBins::force(std::size_t samples) const {
  std::vector<double> force;
  force.reserve(samples);
  const auto bin = [&](std::size_t i) { return i < half_bins_.size() ? half_bins_[i] : 0.0; };
  for (std::size_t k = 0; k < samples; ++k) {
    const double before = k > 0 ? bin(2 * k - 1) : 0.0;
    const double after = k + 1 < samples ? bin(2 * k) : 0.0;
    const double length = (k == 0 || k + 1 == samples) ? 0.5 * interval_ : interval_;
    force.push_back((before + after) / length);
  }
  return force;
}

std::vector<double> ImpulseBins::running_means(std::size_t half_bins) const {
  const double length = 0.5 * interval_ * static_cast<double>(half_bins);
  std::vector<double> padded = half_bins_;
  padded.resize(half_bins_.size() + half_bins + 1, 0.0);
  std::vector<double> means;
  for (std::size_t from = 0; from + half_bins <= padded.size(); ++from) {
    double sum = 0.0;
    for (std::size_t i = from; i < from + half_bins; ++i) sum += padded[i];
    means.push_back(sum / length);
  }
  return means;
}

}  // namespace rebound::fem
