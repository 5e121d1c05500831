#include "comparisons/models/instrument/contact_ends.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace rebound {
namespace {

constexpr std::size_t intervals = 4;  // at each end
constexpr std::size_t parts = 16;     // of them, equal in w
constexpr std::size_t support = 6;    // samples behind a polynomial
constexpr std::size_t fewest = 2 * support;

/// In intervals from the end.
double place_of(std::size_t part) {
  const double w = std::sqrt(double(intervals)) * double(part) / double(parts);
  return w * w;
}

/// Shares of the samples next to an end in the value at each part, by Lagrange.
using Weights = std::array<std::array<double, support>, parts>;

Weights lagrange_weights() {
  Weights weights{};
  for (std::size_t part = 0; part < parts; ++part) {
    const double w = std::sqrt(place_of(part));
    for (std::size_t i = 0; i < support; ++i) {
      const double own = std::sqrt(double(i));
      double weight = 1.0;
      for (std::size_t k = 0; k < support; ++k)
        if (k != i) weight *= (w - std::sqrt(double(k))) / (own - std::sqrt(double(k)));
      weights[part][i] = weight;
    }
  }
  return weights;
}

/// The column with `finer(part, of_the_end)` in place of what stands in the intervals at its ends.
template <class Value>
std::vector<double> with_ends(const std::vector<double>& column, const Value& finer) {
  const std::size_t last = column.size() - 1;
  std::vector<double> result{column.front()};
  result.reserve(column.size() + 2 * parts);
  for (std::size_t part = 1; part < parts; ++part) result.push_back(finer(part, false));
  for (std::size_t i = intervals; i + intervals <= last; ++i) result.push_back(column[i]);
  for (std::size_t part = parts - 1; part > 0; --part) result.push_back(finer(part, true));
  result.push_back(column.back());
  return result;
}

std::vector<double> resampled(const std::vector<double>& column) {
  if (column.empty()) return column;
  static const Weights weights = lagrange_weights();
  const std::size_t last = column.size() - 1;
  return with_ends(column, [&](std::size_t part, bool of_the_end) {
    double value = 0.0;
    for (std::size_t i = 0; i < support; ++i)
      value += weights[part][i] * column[of_the_end ? last - i : i];
    return value;
  });
}

std::vector<double> instants(const std::vector<double>& time) {
  const double step = (time.back() - time.front()) / double(time.size() - 1);
  return with_ends(time, [&](std::size_t part, bool of_the_end) {
    return of_the_end ? time.back() - step * place_of(part) : time.front() + step * place_of(part);
  });
}

}  // namespace

Trace with_finer_ends(const Trace& contact) {
  if (contact.time.size() < fewest) return contact;
  Trace finer{.time = instants(contact.time),
              .force = resampled(contact.force),
              .deflection = resampled(contact.deflection),
              .further = {}};
  for (const TraceColumn& column : contact.further)
    finer.further.push_back({column.name, resampled(column.values)});
  return finer;
}

}  // namespace rebound
