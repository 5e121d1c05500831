#include "comparisons/discrepancy/trials/generator/random.hpp"

#include <algorithm>
#include <cmath>

namespace trials {
namespace {

/// The output function of splitmix64: neighbouring inputs give unrelated outputs.
std::uint64_t mixed(std::uint64_t bits) {
  bits += 0x9e3779b97f4a7c15ull;
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9ull;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebull;
  return bits ^ (bits >> 31);
}

std::uint64_t engine_seed(const RandomSource& source) {
  std::uint64_t bits = mixed(source.seed);
  for (const unsigned char letter : source.set) bits = mixed(bits ^ letter);
  bits = mixed(bits ^ static_cast<std::uint64_t>(source.trial));
  return mixed(bits ^ (static_cast<std::uint64_t>(source.purpose) << 32));
}

}  // namespace

Random::Random(const RandomSource& source) : engine_(engine_seed(source)) {}

double Random::uniform(double from, double to) {
  return from + (to - from) * uniform_(engine_);
}

double Random::log_uniform(double from, double to) {
  return std::exp(uniform(std::log(from), std::log(to)));
}

int Random::whole(int from, int to) {
  const double drawn = std::floor(uniform(from, to + 1.0));
  return std::min(to, static_cast<int>(drawn));
}

}  // namespace trials
