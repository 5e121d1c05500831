#include "fem/explicit/node_laplacian.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <limits>

// Compiled without contraction to FMA (fem/CMakeLists.txt): every bit is then the same on each
// instruction set.
namespace rebound::fem {
namespace {

constexpr int block_size = NodeLaplacian::block_size;
constexpr int block_values = 2 * block_size;  // (r, z) of each node
constexpr int values_of_padding = 2 * NodeLaplacian::padding;

using Diagonals = NodeLaplacian::Diagonals;
using Block = NodeLaplacian::Block;

/// What a kick reads and writes, [node][2]; y is M⁻¹ f, made by it.
struct Kick {
  double span;
  const double *inverse_mass, *force;
  double *y, *velocity;
};

typedef double Pair __attribute__((vector_size(16)));  // (r, z) of a node
typedef double Quad __attribute__((vector_size(32)));
typedef double Octet __attribute__((vector_size(64)));

/// Masses of the nodes of one vector, and how each comes to stand for r and z.
template <class Vector>
struct Masses;
template <>
struct Masses<Pair> {
  double m;
  [[gnu::always_inline]] void spread(Pair& out) const { out = Pair{m, m}; }
};
template <>
struct Masses<Quad> {
  Pair m;
  [[gnu::always_inline]] void spread(Quad& out) const {
    out = __builtin_shufflevector(m, m, 0, 0, 1, 1);
  }
};
template <>
struct Masses<Octet> {
  Quad m;
  [[gnu::always_inline]] void spread(Octet& out) const {
    out = __builtin_shufflevector(m, m, 0, 0, 1, 1, 2, 2, 3, 3);
  }
};

// Vectors go by reference or as arrays in memory: wide ones have no calling convention of their
// own outside functions for their instruction set.
template <class Vector>
inline constexpr int vectors = static_cast<int>(sizeof(Octet) / sizeof(Vector));

template <class Vector>
[[gnu::always_inline]] inline void kick_block(const Diagonals& d, int b, const Kick& kick,
                                              const double* inverse_mass, const double* force,
                                              double* velocity) {
  Vector own[vectors<Vector>], moving[vectors<Vector>];
  std::memcpy(own, kick.y + b * block_values, sizeof(Octet));
  std::memcpy(moving, force, sizeof(Octet));
  for (int k = d.blocks[b].begin; k < d.blocks[b].end; ++k) {
    Vector other[vectors<Vector>], mass;
    Masses<Vector> masses[vectors<Vector>];
    std::memcpy(other, kick.y + d.at[k], sizeof(Octet));
    std::memcpy(masses, d.mass + block_size * k, sizeof(masses));
    for (int i = 0; i < vectors<Vector>; ++i) {
      masses[i].spread(mass);
      const Vector apart = own[i] - other[i];
      moving[i] += mass * apart;
    }
  }
  Vector share[vectors<Vector>], v[vectors<Vector>];
  std::memcpy(share, inverse_mass, sizeof(Octet));
  std::memcpy(v, velocity, sizeof(Octet));
  for (int i = 0; i < vectors<Vector>; ++i) v[i] -= kick.span * moving[i] * share[i];
  std::memcpy(velocity, v, sizeof(Octet));
}

template <class Vector>
[[gnu::always_inline]] inline void kick_nodes(const Diagonals& d, const Kick& kick) {
  const int values = 2 * d.nodes, whole = values / block_values;
  for (int i = 0; i < values; ++i) kick.y[i] = kick.force[i] * kick.inverse_mass[i];
  for (int b = 0; b < whole; ++b)
    kick_block<Vector>(d, b, kick, kick.inverse_mass + b * block_values,
                       kick.force + b * block_values, kick.velocity + b * block_values);
  const int done = whole * block_values, left = values - done;
  if (left == 0) return;
  double inverse_mass[block_values] = {}, force[block_values] = {}, velocity[block_values] = {};
  std::copy_n(kick.inverse_mass + done, left, inverse_mass);
  std::copy_n(kick.force + done, left, force);
  std::copy_n(kick.velocity + done, left, velocity);
  kick_block<Vector>(d, whole, kick, inverse_mass, force, velocity);
  std::copy_n(velocity, left, kick.velocity + done);
}

/// Both fields in one pass: what the weights cost to read is paid once.
template <class Vector>
[[gnu::always_inline]] inline double half_squares_of(const Diagonals& d, const double* v,
                                                     const double* w) {
  Vector sum[vectors<Vector>] = {};
  for (int b = 0; b * block_size < d.nodes; ++b) {
    Vector own[2][vectors<Vector>];
    std::memcpy(own[0], v + b * block_values, sizeof(Octet));
    std::memcpy(own[1], w + b * block_values, sizeof(Octet));
    for (int k = d.blocks[b].upper; k < d.blocks[b].end; ++k) {
      Vector other[2][vectors<Vector>], mass;
      Masses<Vector> masses[vectors<Vector>];
      std::memcpy(other[0], v + d.at[k], sizeof(Octet));
      std::memcpy(other[1], w + d.at[k], sizeof(Octet));
      std::memcpy(masses, d.mass + block_size * k, sizeof(masses));
      for (int i = 0; i < vectors<Vector>; ++i) {
        masses[i].spread(mass);
        const Vector v_apart = own[0][i] - other[0][i], w_apart = own[1][i] - other[1][i];
        sum[i] += mass * (v_apart * v_apart + w_apart * w_apart);
      }
    }
  }
  double values[block_values];
  std::memcpy(values, sum, sizeof(Octet));
  double total = 0.0;
  for (const double value : values) total += value;
  return 0.5 * total;
}

/// The two for one instruction set.
struct Functions {
  void (*kick)(const Diagonals&, const Kick&);
  double (*half_squares)(const Diagonals&, const double* v, const double* w);
};

void kick_plainly(const Diagonals& d, const Kick& kick) {
  kick_nodes<Pair>(d, kick);
}
double half_squares_plainly(const Diagonals& d, const double* v, const double* w) {
  return half_squares_of<Pair>(d, v, w);
}

#if defined(__x86_64__)
[[gnu::target("avx")]] void kick_with_avx(const Diagonals& d, const Kick& kick) {
  kick_nodes<Quad>(d, kick);
}
[[gnu::target("avx")]] double half_squares_with_avx(const Diagonals& d, const double* v,
                                                    const double* w) {
  return half_squares_of<Quad>(d, v, w);
}
[[gnu::target("avx512f")]] void kick_with_avx512(const Diagonals& d, const Kick& kick) {
  kick_nodes<Octet>(d, kick);
}
[[gnu::target("avx512f")]] double half_squares_with_avx512(const Diagonals& d, const double* v,
                                                           const double* w) {
  return half_squares_of<Octet>(d, v, w);
}
#endif

const Functions& chosen() {
  static const Functions functions = [] {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx512f"))
      return Functions{kick_with_avx512, half_squares_with_avx512};
    if (__builtin_cpu_supports("avx")) return Functions{kick_with_avx, half_squares_with_avx};
#endif
    return Functions{kick_plainly, half_squares_plainly};
  }();
  return functions;
}

}  // namespace

NodeLaplacian::NodeLaplacian(const std::vector<int>& first,
                             const std::vector<Neighbour>& neighbours)
    : nodes_(static_cast<int>(first.size()) - 1),
      accelerations_(static_cast<std::size_t>(2 * (nodes_ + 2 * padding)), 0.0) {
  const std::size_t blocks = (static_cast<std::size_t>(nodes_) + block_size - 1) / block_size;
  blocks_.reserve(blocks);
  at_.reserve(12 * blocks);
  mass_.reserve(12 * blocks * block_size);
  for (int node = 0; node < nodes_; node += block_size)
    add_block(first.data() + node, std::min(block_size, nodes_ - node), neighbours.data(), node);
}

void NodeLaplacian::add_block(const int* first, int nodes, const Neighbour* neighbours, int node) {
  int next[block_size];
  std::copy_n(first, nodes, next);
  Block block{.begin = static_cast<int>(at_.size()), .upper = -1, .end = 0};
  const auto distance = [&](int lane) {
    return next[lane] < first[lane + 1] ? neighbours[next[lane]].node - (node + lane)
                                        : std::numeric_limits<int>::max();
  };
  while (true) {
    int nearest = std::numeric_limits<int>::max();
    for (int lane = 0; lane < nodes; ++lane) nearest = std::min(nearest, distance(lane));
    if (block.upper < 0 && nearest > 0) block.upper = static_cast<int>(at_.size());
    if (nearest == std::numeric_limits<int>::max()) break;
    at_.push_back(2 * (node + nearest));
    for (int lane = 0; lane < block_size; ++lane) {
      const bool has = lane < nodes && distance(lane) == nearest;
      mass_.push_back(has ? neighbours[next[lane]++].mass : 0.0);
    }
  }
  block.end = static_cast<int>(at_.size());
  blocks_.push_back(block);
}

NodeLaplacian::Diagonals NodeLaplacian::diagonals() const {
  return {.blocks = blocks_.data(), .nodes = nodes_, .at = at_.data(), .mass = mass_.data()};
}

void NodeLaplacian::kick(double span, const std::vector<double>& inverse_mass,
                         const std::vector<double>& force, std::vector<double>& velocity) {
  chosen().kick(diagonals(), {.span = span,
                              .inverse_mass = inverse_mass.data(),
                              .force = force.data(),
                              .y = accelerations_.data() + values_of_padding,
                              .velocity = velocity.data()});
}

std::vector<double> NodeLaplacian::added_to(const std::vector<double>& force,
                                            const std::vector<double>& inverse_mass) const {
  const auto y = [&](int value) { return force[value] * inverse_mass[value]; };
  std::vector<double> sum = force;
  for (std::size_t b = 0; b < blocks_.size(); ++b)
    for (int k = blocks_[b].begin; k < blocks_[b].end; ++k)
      for (int i = 0; i < block_values; ++i)
        if (const double mass = mass_[block_size * k + i / 2]; mass != 0.0) {
          const int own = static_cast<int>(b) * block_values + i;
          sum[own] += mass * (y(own) - y(at_[k] + i));
        }
  return sum;
}

double NodeLaplacian::half_squares(const std::vector<double>& v,
                                   const std::vector<double>& w) const {
  return chosen().half_squares(diagonals(), v.data(), w.data());
}

}  // namespace rebound::fem
