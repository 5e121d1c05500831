#pragma once

#include <vector>

#include "fem/discretisation/discretisation.hpp"
#include "fem/kernel/cache_line_vector.hpp"

namespace rebound::fem {

/// Weighted graph Laplacian over nodes:
///
///   (L y)_i = Σ_j m_ij (y_i − y_j),   m_ij = m_ji over nodes that share a cell
///
///   m_ij  mass between two nodes [kg];  y  a field of the nodes, [node][2] (r, z)
///
/// Kept by blocks of four nodes that follow each other. A diagonal of a block is four neighbours
/// at the same distance in number, one for each node and of no mass where a node has none there:
/// they lie side by side and are loaded at once. As discretise() numbers the nodes, a block of the
/// built-in mesh has some nine diagonals for eight neighbours; any numbering is correct.
///
/// Limit: a sum of each node is in the order of its neighbours whatever the instruction set, so
///        that every bit is the same -> test
///        DispersionCorrectionTest.AKickIsThatOfTheCorrectedForce
class NodeLaplacian {
 public:
  struct Neighbour {
    int node;
    double mass;  ///< m_ij [kg]
  };
  static constexpr int block_size = nodes_per_block;
  static constexpr int padding = block_size;  ///< nodes

  /// Neighbours of node i, in ascending order: [first[i], first[i + 1]) of `neighbours`.
  NodeLaplacian(const std::vector<int>& first, const std::vector<Neighbour>& neighbours);

  /// v − `span` M⁻¹ (f + L M⁻¹ f), in one pass over the nodes after that for M⁻¹ f.
  void kick(double span, const std::vector<double>& inverse_mass, const std::vector<double>& force,
            std::vector<double>& velocity);

  /// f + L M⁻¹ f, node by node.
  std::vector<double> added_to(const std::vector<double>& force,
                               const std::vector<double>& inverse_mass) const;

  /// ½ vᵀ L v + ½ wᵀ L w. Blocks reach over the last node: v and w have as many more as `padding`
  /// (of any value that is a number).
  double half_squares(const std::vector<double>& v, const std::vector<double>& w) const;

  /// Diagonals of one block, by distance, [begin, end) of all; those of higher number from `upper`.
  struct Block {
    int begin, upper, end;
  };
  /// What the functions of an instruction set read.
  struct Diagonals {
    const Block* blocks;
    int nodes;
    const int* at;       ///< of the neighbours of a block, in [node][2]
    const double* mass;  ///< [diagonal][block_size]
  };

 private:
  void add_block(const int* first, int nodes, const Neighbour* neighbours, int node);
  Diagonals diagonals() const;

  int nodes_;
  std::vector<Block> blocks_;
  std::vector<int> at_;
  CacheLineVector<double> mass_;
  CacheLineVector<double> accelerations_;  ///< y, with nodes of zero before and behind
};

}  // namespace rebound::fem
