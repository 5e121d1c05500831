#pragma once

#include <concepts>

#include "fem/materials/kinematics.hpp"

namespace rebound::fem {

/// An elastic model: what every law in this folder offers, for T = double, for
/// a vector of cells, and for a number that carries its derivatives.
///
///   W(C) = W_d + W_v,   S = S_d + S_v = 2 ∂W/∂C
///
///   deviatoric_stress, volumetric_stress  S_d, S_v: second Piola–Kirchhoff stress [Pa],
///                                         each the derivative of its energy
///   deviatoric_energy, volumetric_energy  W_d, W_v per reference volume [J/m³]
///   stiffness_growth(strain, m)           bound of the stiffest motion over its value at
///                                         rest, 1 at rest [-]; m bounds the eigenvalues of C⁻¹
///
/// At small strain S_d = 2μ dev ε and S_v = K tr ε 1, with `moduli` μ and K; either
/// part may relax alone. At rest stress and energy are zero.
///
/// To write one: copy blank_material.hpp and add its line to fem/interface/elastic_models.inc;
/// material_battery_test.cpp then tests all of this.
/// Caution: the arithmetic must hold for all three kinds of T. Name every
///          intermediate T (differentiated numbers are expressions otherwise),
///          choose by `a < b ? x : y` with both of type T, and use exp, log and
///          sqrt unqualified. Functions of a shared type that are not templates
///          over T have no place in a kernel, see ../kernel/README.md.
template <class Model, class T>
concept Elastic = requires(const Model& model, const Strain<T>& strain, const T& bound) {
  { model.moduli.shear } -> std::convertible_to<double>;
  { model.moduli.bulk } -> std::convertible_to<double>;
  { model.deviatoric_stress(strain) } -> std::same_as<Symmetric<T>>;
  { model.volumetric_stress(strain) } -> std::same_as<Symmetric<T>>;
  { model.deviatoric_energy(strain) } -> std::same_as<T>;
  { model.volumetric_energy(strain) } -> std::same_as<T>;
  { model.stiffness_growth(strain, bound) } -> std::same_as<T>;
};

}  // namespace rebound::fem
