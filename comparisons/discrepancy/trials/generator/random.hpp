#pragma once

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_01.hpp>
#include <cstdint>
#include <string>
#include <vector>

namespace trials {

/// Where the random numbers of one purpose in one trial come from. Trial 7 is the same whether
/// ten or a thousand trials are asked for.
struct RandomSource {
  std::uint64_t seed = 0;
  std::string set;
  int trial = 0;
  int purpose = 0;
};

/// Random numbers of one source. Boost's generators give the same numbers with every compiler.
class Random {
 public:
  explicit Random(const RandomSource& source);

  double uniform(double from, double to);
  /// Uniform in the logarithm.
  double log_uniform(double from, double to);
  /// Standard normal.
  double normal() { return normal_(engine_); }
  double sign() { return uniform(0.0, 1.0) < 0.5 ? -1.0 : 1.0; }
  bool chance(double probability) { return uniform(0.0, 1.0) < probability; }
  /// A whole number, both ends included.
  int whole(int from, int to);

  template <class T>
  const T& one_of(const std::vector<T>& list) {
    return list[static_cast<std::size_t>(whole(0, static_cast<int>(list.size()) - 1))];
  }

 private:
  boost::random::mt19937_64 engine_;
  boost::random::uniform_01<double> uniform_;
  boost::random::normal_distribution<double> normal_;
};

}  // namespace trials
