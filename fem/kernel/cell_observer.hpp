#pragma once

#include "fem/kernel/cell_kernel.hpp"

/// What a kernel knows of each integration point and does not tell: for pictures.
/// Functions of their own in files of their own, so that the kernels that make
/// the forces stay as they are whether anyone looks or not.
namespace rebound::fem {

/// Doubles per integration point and lane that an observer carries: F − 1 and P
/// (rr, rz, zr, zz, tt) of the last instant, and the work so far. Zeros are rest.
inline constexpr int observed_stride = 11;
/// Doubles per integration point and lane of energies: stored, held by branches.
inline constexpr int observed_energies = 2;

/// Both functions look at one instant and are called before the kernel's forces of
/// that instant, with the same arguments: branches have then not moved on yet.
/// Numbers are those before a layer's factor (CellBatches::layer_factor).
struct CellObserver {
  /// The work of all stresses up to this instant, by the rule that the energy balance
  /// has for the nodes:
  ///
  ///   w ← w + ½ (P + P_before) : (F − F_before)     [J/m³], per reference volume
  ///
  ///   P   first Piola–Kirchhoff stress, branches and viscous stress included [Pa]
  ///
  /// `observed`: [batch][point][observed_stride][width].
  void (*advance)(const CellArrays&, const BranchStep*, const CellMotion& motion,
                  const double* history, double* observed);
  /// Energy of the long-term state after any softening, whose integral is
  /// CellKernel::stored_energy, and that of the branches by multiplicative split;
  /// a branch by convolution has none that is known [J/m³].
  /// `energies`: [batch][point][observed_energies][width].
  void (*energies)(const CellArrays&, const BranchStep*, const double* displacement,
                   const double* history, double* energies);
};

/// The observer of a kernel's width and instruction set.
const CellObserver& observer_of(const CellKernel& kernel);

}  // namespace rebound::fem
