#include "fem/explicit/dispersion_correction.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace rebound::fem {

namespace {

typedef double Pair __attribute__((vector_size(16)));  // (r, z)

inline Pair load(const double* at) {
  Pair pair;
  std::memcpy(&pair, at, sizeof(Pair));
  return pair;
}

inline void store(double* at, Pair pair) {
  std::memcpy(at, &pair, sizeof(Pair));
}

using Row = DispersionCorrection::Row;
using Neighbour = DispersionCorrection::Neighbour;
using Rows = std::vector<Row>;

/// What a kick reads and writes, [node][2].
struct Kick {
  double span;
  const double *inverse_mass, *force, *acceleration;
  double* velocity;
};

// A node by itself: a pair of nodes in one go would write to both in memory and wait for the write
// before. A node's sum is in the order of its neighbours either way.
[[gnu::always_inline]] inline Pair corrected_force(const Row& row, const Neighbour* neighbours,
                                                   const double* force, const double* y) {
  const Pair own = load(y + row.at);
  Pair sum = load(force + row.at);
  for (const Neighbour* n = neighbours + row.begin; n < neighbours + row.end; ++n)
    sum += n->mass * (own - load(y + n->at));
  return sum;
}

[[gnu::always_inline]] inline void kick_rows(const Rows& rows, const Neighbour* neighbours,
                                             const Kick& kick) {
  for (const Row& row : rows) {
    const Pair moving = corrected_force(row, neighbours, kick.force, kick.acceleration);
    store(kick.velocity + row.at,
          load(kick.velocity + row.at) - kick.span * moving * load(kick.inverse_mass + row.at));
  }
}

[[gnu::always_inline]] inline double kinetic_of_rows(const Rows& rows, const Neighbour* neighbours,
                                                     const double* velocity) {
  Pair sum = {};
  for (const Row& row : rows) {
    const Pair own = load(velocity + row.at);
    Pair of_row = {};
    for (const Neighbour* n = neighbours + row.upper; n < neighbours + row.end; ++n) {
      const Pair apart = own - load(velocity + n->at);
      of_row += n->mass * (apart * apart);
    }
    sum += of_row;
  }
  return 0.5 * (sum[0] + sum[1]);
}

/// The two for one instruction set.
struct RowFunctions {
  void (*kick)(const Rows&, const Neighbour*, const Kick&);
  double (*kinetic)(const Rows&, const Neighbour*, const double* velocity);
};

void kick_plainly(const Rows& rows, const Neighbour* neighbours, const Kick& kick) {
  kick_rows(rows, neighbours, kick);
}

double kinetic_plainly(const Rows& rows, const Neighbour* neighbours, const double* velocity) {
  return kinetic_of_rows(rows, neighbours, velocity);
}

#if defined(__x86_64__)
// Half the instructions for the same operations; without FMA, so that every bit is the same.
[[gnu::target("avx")]] void kick_with_avx(const Rows& rows, const Neighbour* neighbours,
                                          const Kick& kick) {
  kick_rows(rows, neighbours, kick);
}

[[gnu::target("avx")]] double kinetic_with_avx(const Rows& rows, const Neighbour* neighbours,
                                               const double* velocity) {
  return kinetic_of_rows(rows, neighbours, velocity);
}
#endif

const RowFunctions& chosen() {
  static const RowFunctions functions = [] {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx")) return RowFunctions{kick_with_avx, kinetic_with_avx};
#endif
    return RowFunctions{kick_plainly, kinetic_plainly};
  }();
  return functions;
}

/// (ω Δt/2)² of the stiffest cell, its own correction counted.
double squared_limit(double safety) {
  return 1.5 - std::sqrt(2.25 - 2.0 * safety * safety);
}

}  // namespace

double DispersionCorrection::step_factor(double step_safety) {
  return std::sqrt(squared_limit(step_safety)) / step_safety;
}

DispersionCorrection::DispersionCorrection(const Discretisation& body,
                                           const std::vector<double>& frequency_squared,
                                           double step_safety)
    : acceleration_(2 * (body.position.size() + 1), 0.0) {
  const double largest = *std::max_element(frequency_squared.begin(), frequency_squared.end());
  std::vector<char> may_touch(body.position.size(), 0);
  for (const int node : body.contact_nodes) may_touch[static_cast<std::size_t>(node)] = 1;
  std::vector<std::vector<Neighbour>> rows(body.position.size());
  const auto add = [&](int node, int other, double mass) {
    auto& row = rows[static_cast<std::size_t>(node)];
    const auto found = std::find_if(row.begin(), row.end(),
                                    [&](const Neighbour& known) { return known.at == 2 * other; });
    if (found == row.end())
      row.push_back({mass, 2 * static_cast<std::ptrdiff_t>(other)});
    else
      found->mass += mass;
  };
  for (std::size_t c = 0; c < body.cells.size(); ++c) {
    const CellGeometry& cell = body.cells[c];
    const double share = 0.5 * (1.0 - squared_limit(step_safety) * frequency_squared[c] / largest);
    for (int a = 0; a < nodes_per_cell; ++a)
      for (int b = 0; b < nodes_per_cell; ++b) {
        const int i = cell.nodes[a], j = cell.nodes[b];
        if (i >= j || may_touch[static_cast<std::size_t>(i)] ||
            may_touch[static_cast<std::size_t>(j)])
          continue;
        for (int q = 0; q < points_per_cell; ++q) {
          const double mass =
              share * body.density * cell.weight[q] * cell.shape[q][a] * cell.shape[q][b];
          add(i, j, mass);
          add(j, i, mass);
        }
      }
  }
  for (std::size_t node = 0; node < rows.size(); ++node) {
    auto& row = rows[node];
    std::sort(row.begin(), row.end(),
              [](const Neighbour& a, const Neighbour& b) { return a.at < b.at; });
    const auto own = 2 * static_cast<std::ptrdiff_t>(node);
    const auto begin = static_cast<int>(neighbours_.size());
    const auto lower = std::count_if(row.begin(), row.end(),
                                     [&](const Neighbour& other) { return other.at < own; });
    neighbours_.insert(neighbours_.end(), row.begin(), row.end());
    rows_.push_back(
        {own, begin, begin + static_cast<int>(lower), static_cast<int>(neighbours_.size())});
  }
}

void DispersionCorrection::find_accelerations(const std::vector<double>& inverse_mass,
                                              const std::vector<double>& force) {
  for (std::size_t i = 0; i < force.size(); ++i) acceleration_[i] = force[i] * inverse_mass[i];
}

std::vector<double> DispersionCorrection::corrected(const std::vector<double>& inverse_mass,
                                                    const std::vector<double>& force) {
  find_accelerations(inverse_mass, force);
  std::vector<double> corrected = force;
  for (const Row& row : rows_)
    store(corrected.data() + row.at,
          corrected_force(row, neighbours_.data(), force.data(), acceleration_.data()));
  return corrected;
}

void DispersionCorrection::kick(double span, const std::vector<double>& inverse_mass,
                                const std::vector<double>& force, std::vector<double>& velocity) {
  find_accelerations(inverse_mass, force);
  chosen().kick(rows_, neighbours_.data(),
                {.span = span,
                 .inverse_mass = inverse_mass.data(),
                 .force = force.data(),
                 .acceleration = acceleration_.data(),
                 .velocity = velocity.data()});
}

double DispersionCorrection::kinetic(const std::vector<double>& velocity) const {
  return chosen().kinetic(rows_, neighbours_.data(), velocity.data());
}

}  // namespace rebound::fem
