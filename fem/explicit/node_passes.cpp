#include "fem/explicit/node_passes.hpp"

#include <cstddef>
#include <cstring>

// Compiled without contraction to FMA (fem/CMakeLists.txt).
namespace rebound::fem {
namespace {

constexpr std::size_t strands = 8;

[[gnu::always_inline]] inline void add_scaled_to(double* a, double s, const double* b,
                                                 std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) a[i] += s * b[i];
}

/// `Vector` holds as many values as the machine's registers.
template <class Vector>
[[gnu::always_inline]] inline void sum_up(const double* weight, const double* b, std::size_t count,
                                          WeightedSums& sums) {
  constexpr std::size_t vectors = strands * sizeof(double) / sizeof(Vector);
  Vector squares[vectors] = {}, plain[vectors] = {};
  const auto add = [&](const double* weights, const double* values) __attribute__((always_inline)) {
    Vector w[vectors], v[vectors];
    std::memcpy(w, weights, sizeof w);
    std::memcpy(v, values, sizeof v);
    for (std::size_t i = 0; i < vectors; ++i) {
      const Vector weighted = w[i] * v[i];
      plain[i] += weighted;
      squares[i] += weighted * v[i];
    }
  };
  const std::size_t whole = count - count % strands;
  for (std::size_t i = 0; i < whole; i += strands) add(weight + i, b + i);
  double last_weight[strands] = {}, last[strands] = {};
  for (std::size_t i = whole; i < count; ++i) {
    last_weight[i - whole] = weight[i];
    last[i - whole] = b[i];
  }
  add(last_weight, last);
  double of_squares[strands], of_plain[strands];
  std::memcpy(of_squares, squares, sizeof squares);
  std::memcpy(of_plain, plain, sizeof plain);
  sums = {};
  for (std::size_t i = 0; i < strands; i += 2) {
    sums.squares += of_squares[i] + of_squares[i + 1];
    sums.axial += of_plain[i + 1];
  }
}

/// The two for one instruction set.
struct Functions {
  void (*add_scaled)(double* a, double s, const double* b, std::size_t count);
  void (*sum)(const double* weight, const double* b, std::size_t count, WeightedSums& sums);
};

typedef double Pair __attribute__((vector_size(16)));

void add_scaled_plainly(double* a, double s, const double* b, std::size_t count) {
  add_scaled_to(a, s, b, count);
}
void sum_plainly(const double* weight, const double* b, std::size_t count, WeightedSums& sums) {
  sum_up<Pair>(weight, b, count, sums);
}

#if defined(__x86_64__)
typedef double Quad __attribute__((vector_size(32)));
typedef double Octet __attribute__((vector_size(64)));

[[gnu::target("avx")]] void add_scaled_with_avx(double* a, double s, const double* b,
                                                std::size_t count) {
  add_scaled_to(a, s, b, count);
}
[[gnu::target("avx")]] void sum_with_avx(const double* weight, const double* b, std::size_t count,
                                         WeightedSums& sums) {
  sum_up<Quad>(weight, b, count, sums);
}
[[gnu::target("avx512f")]] void add_scaled_with_avx512(double* a, double s, const double* b,
                                                       std::size_t count) {
  add_scaled_to(a, s, b, count);
}
[[gnu::target("avx512f")]] void sum_with_avx512(const double* weight, const double* b,
                                                std::size_t count, WeightedSums& sums) {
  sum_up<Octet>(weight, b, count, sums);
}
#endif

const Functions& chosen() {
  static const Functions functions = [] {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx512f"))
      return Functions{add_scaled_with_avx512, sum_with_avx512};
    if (__builtin_cpu_supports("avx")) return Functions{add_scaled_with_avx, sum_with_avx};
#endif
    return Functions{add_scaled_plainly, sum_plainly};
  }();
  return functions;
}

}  // namespace

void add_scaled(std::vector<double>& a, double s, const std::vector<double>& b) {
  chosen().add_scaled(a.data(), s, b.data(), a.size());
}

WeightedSums weighted_sums(const std::vector<double>& weight, const std::vector<double>& b) {
  WeightedSums sums;
  chosen().sum(weight.data(), b.data(), b.size(), sums);
  return sums;
}

}  // namespace rebound::fem
