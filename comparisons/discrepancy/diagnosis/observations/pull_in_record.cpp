#include "comparisons/discrepancy/diagnosis/observations/pull_in_record.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "comparisons/discrepancy/diagnosis/observations/prepared_record.hpp"
#include "comparisons/inference/calibration/autocorrelation.hpp"

namespace rebound {
namespace {

/// Means of a force over blocks of a twentieth of the contact, in deviations of the first samples.
class ForceInBlocks {
 public:
  ForceInBlocks(const SampleRange& contact, std::size_t quiet_samples,
                const std::vector<double>& force, double rounding)
      : force_(force), block_(std::max<std::size_t>(contact.count() / blocks_a_contact, 1)) {
    const std::span quiet(force.data(), quiet_samples);
    zero_ = std::accumulate(quiet.begin(), quiet.end(), 0.0) / static_cast<double>(quiet.size());
    deviation_ = std::hypot(estimate_noise({quiet}).deviation, rounding);
  }

  /// Where a pull ends that begins within a quarter of the contact from `first` on; `first` where
  /// there is none, `last` at the furthest.
  std::size_t end_of_pull(std::size_t first, std::size_t last) const {
    std::size_t begin = first;
    for (std::size_t k = 0; k < calm_blocks && is_within(begin, last) && !pulls(begin); ++k)
      begin += block_;
    if (!is_within(begin, last) || !pulls(begin)) return first;
    while (is_within(begin, last) && pulls(begin)) begin += block_;
    return begin;
  }
  /// Where a pull begins that ends within a quarter of the contact before `last`; or `last`.
  std::size_t begin_of_pull(std::size_t last) const {
    std::size_t end = last;
    for (std::size_t k = 0; k < calm_blocks && end >= 2 * block_ && !pulls(end - block_); ++k)
      end -= block_;
    if (end < 2 * block_ || !pulls(end - block_)) return last;
    while (end >= 2 * block_ && pulls(end - block_)) end -= block_;
    return end;
  }
  bool pushes_between(std::size_t first, std::size_t last) const {
    for (; is_within(first, last); first += block_)
      if (mean_at(first) > plain) return true;
    return false;
  }

 private:
  static constexpr std::size_t blocks_a_contact = 20, calm_blocks = 5;
  static constexpr double plain = 3.0;

  bool is_within(std::size_t first, std::size_t last) const {
    return first + block_ <= std::min(last, force_.size() - 1);
  }
  bool pulls(std::size_t first) const { return mean_at(first) < -plain; }
  double mean_at(std::size_t first) const {
    const auto begin = force_.begin() + static_cast<std::ptrdiff_t>(first);
    const double sum = std::accumulate(begin, begin + static_cast<std::ptrdiff_t>(block_), 0.0);
    return (sum / static_cast<double>(block_) - zero_) / deviation_;
  }

  const std::vector<double>& force_;
  std::size_t block_;
  double zero_ = 0.0, deviation_ = 0.0;
};

}  // namespace

SampleRange with_pull(SampleRange contact, const std::vector<double>& force, double rounding) {
  if (contact.first < fewest_quiet) return contact;
  // What precedes the contact may end with a pull; its first half is quiet.
  const ForceInBlocks blocks(contact, std::max(contact.first / 2, fewest_quiet), force, rounding);
  const std::size_t end = blocks.end_of_pull(contact.last, contact.last + contact.count());
  const std::size_t as_long_again = end + (end - contact.last);
  contact.first = std::max(blocks.begin_of_pull(contact.first), fewest_quiet);
  // A record that ends before cannot tell a pull from a plate that swings back.
  if (as_long_again < force.size() && !blocks.pushes_between(end, as_long_again))
    contact.last = end;
  return contact;
}

}  // namespace rebound
