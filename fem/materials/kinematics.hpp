#pragma once

#include <cmath>

namespace rebound::fem {

using std::exp;
using std::log;
using std::sqrt;

/// Is `x` above `bound`? Of a vector: in any lane.
inline bool any_above(double x, double bound) {
  return x > bound;
}

/// Symmetric tensor of an axisymmetric state without torsion.
/// T is `double` or a vector of doubles over cells.
template <class T>
struct Symmetric {
  T rr, zz, tt, rz;
};

/// Deformation gradient F_iJ = ∂x_i/∂X_J of an axisymmetric state.
template <class T>
struct Gradient {
  T rr, rz, zr, zz, tt;
};

/// What the materials need of the deformation: C = FᵀF and its inverse.
template <class T>
struct Strain {
  Symmetric<T> right_cauchy_green;
  Symmetric<T> inverse;
  T jacobian;      ///< J = det F
  T log_jacobian;  ///< ln J
};

template <class T>
inline T jacobian_of(const Gradient<T>& f) {
  return (f.rr * f.zz - f.rz * f.zr) * f.tt;
}

/// Strain measures of `f` where the caller knows 1/J and ln J of several points.
template <class T>
inline Strain<T> strain_of(const Gradient<T>& f, const T& log_jacobian, const T& inverse_jacobian) {
  Strain<T> strain;
  auto& c = strain.right_cauchy_green;
  c.rr = f.rr * f.rr + f.zr * f.zr;
  c.zz = f.rz * f.rz + f.zz * f.zz;
  c.rz = f.rr * f.rz + f.zr * f.zz;
  c.tt = f.tt * f.tt;
  const T in_plane = f.rr * f.zz - f.rz * f.zr;
  strain.jacobian = in_plane * f.tt;
  strain.log_jacobian = log_jacobian;
  const T inverse_in_plane = inverse_jacobian * f.tt;
  const T inverse_tt = inverse_jacobian * in_plane;
  const T inverse_determinant = inverse_in_plane * inverse_in_plane;
  strain.inverse.rr = c.zz * inverse_determinant;
  strain.inverse.zz = c.rr * inverse_determinant;
  strain.inverse.rz = -c.rz * inverse_determinant;
  strain.inverse.tt = inverse_tt * inverse_tt;
  return strain;
}

/// The same, 1/J taken here: one division serves both inverses.
template <class T>
inline Strain<T> strain_of(const Gradient<T>& f, const T& log_jacobian) {
  return strain_of(f, log_jacobian, T(1.0 / jacobian_of(f)));
}

template <class T>
inline Strain<T> strain_of(const Gradient<T>& f) {
  return strain_of(f, T(log(jacobian_of(f))));
}

/// First Piola–Kirchhoff stress P = F S.
template <class T>
inline Gradient<T> first_piola(const Gradient<T>& f, const Symmetric<T>& s) {
  return {f.rr * s.rr + f.rz * s.rz, f.rr * s.rz + f.rz * s.zz, f.zr * s.rr + f.zz * s.rz,
          f.zr * s.rz + f.zz * s.zz, f.tt * s.tt};
}

}  // namespace rebound::fem
