#pragma once

#include <string>
#include <vector>

#include "fem/interface/material.hpp"
#include "lumped/problem/impact.hpp"

namespace rebound {

/// How the travel of the plates goes with time.
enum class CompressionPath {
  slow,      ///< so slowly that every branch has relaxed
  triangle,  ///< up and down at constant speed
  half_sine  ///< up and down as sin(π t/T)
};
constexpr auto names_of(CompressionPath) {
  return names_list<CompressionPath>({{"slow", CompressionPath::slow},
                                      {"triangle", CompressionPath::triangle},
                                      {"half-sine", CompressionPath::half_sine}});
}

/// A sphere pressed by rigid plates, without inertia.
struct Compression {
  int platens = 2;  ///< 1: on one plate, held by a uniform body force; 2: between two
  double deflection =
      0.0;          ///< largest travel: of the centre of mass (1), of the platens together (2) [m]
  int steps = 100;  ///< over the path
  CompressionPath path = CompressionPath::slow;
  double duration = 0.0;  ///< T of triangle or half sine [s]
  double friction = 0.0;  ///< Coulomb coefficient of the plates [-]

  static constexpr auto limits() {
    return std::tuple{Limit{&Compression::platens, "platens", "", from_to(1.0, 2.0)},
                      Limit{&Compression::deflection, "deflection", "mm", above(0.0)},
                      Limit{&Compression::steps, "steps", "", from_to(1.0, 100000.0)},
                      Limit{&Compression::duration, "duration", "ms", above(0.0), 0.0},
                      Limit{&Compression::friction, "friction", "", from_to(0.0, 5.0), 0.0}};
  }
  friend bool operator==(const Compression&, const Compression&) = default;
};

/// One compression of the FE tier.
struct CompressionProblem {
  Sphere sphere;
  Compression compression;
  Material material;
  int cells = 250;  ///< about; nine-node cells of the sphere, or of its half between two platens
  std::string mesh_file;  ///< a user's own mesh of the same; empty: generate

  static constexpr auto limits() {
    return std::tuple{Limit{&CompressionProblem::cells, "cells", "", from_to(20.0, 20000.0)}};
  }
  friend bool operator==(const CompressionProblem&, const CompressionProblem&) = default;
};

/// Columns of equal length, from rest.
struct CompressionCurve {
  std::vector<double> time;            ///< [s]; empty for the slow path
  std::vector<double> deflection;      ///< [m]
  std::vector<double> force;           ///< of one plate, compression positive [N]
  std::vector<double> contact_radius;  ///< outermost node on the plate [m]
  std::vector<double> stored;          ///< hyperelastic energy of the long-term state [J]
  std::vector<double> work;            ///< of the plates, trapezoidal [J]
  std::vector<double> friction;        ///< lost by sliding on the plates so far [J]
};

/// Result of one compression.
struct CompressionResult {
  CompressionCurve curve;
  int cells = 0;
  int vertices = 0;
  long iterations = 0;  ///< of Newton's method, over all steps
  double wall_seconds = 0.0;
  /// Empty when complete; otherwise why the run ended early. No scalar of an
  /// incomplete result may be reported.
  std::string incomplete_because;
};

}  // namespace rebound
