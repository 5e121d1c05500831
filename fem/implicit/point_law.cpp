#include "fem/implicit/point_law.hpp"

#include <cmath>
#include <unsupported/Eigen/AutoDiff>

#include "fem/interface/check_material.hpp"
#include "fem/materials/with_elastic.hpp"
#include "lumped/problem/error.hpp"

namespace rebound::fem {
namespace {

using Dual = Eigen::AutoDiffScalar<Eigen::Vector4d>;

template <class T>
Strain<T> strain_from(const Symmetric<T>& c) {
  using std::log;
  using std::sqrt;
  const T in_plane = c.rr * c.zz - c.rz * c.rz;
  const T determinant = in_plane * c.tt;
  Strain<T> strain;
  strain.right_cauchy_green = c;
  strain.jacobian = sqrt(determinant);
  strain.log_jacobian = 0.5 * log(determinant);
  const T inverse = 1.0 / in_plane;
  strain.inverse.rr = c.zz * inverse;
  strain.inverse.zz = c.rr * inverse;
  strain.inverse.rz = -c.rz * inverse;
  strain.inverse.tt = 1.0 / c.tt;
  return strain;
}

template <class T>
void weigh(Symmetric<T>& sum, double weight, const Symmetric<T>& part) {
  sum.rr += weight * part.rr;
  sum.zz += weight * part.zz;
  sum.tt += weight * part.tt;
  sum.rz += weight * part.rz;
}

Eigen::Vector4d vector_of(const Symmetric<double>& s) {
  return {s.rr, s.zz, s.tt, s.rz};
}

Symmetric<double> tensor_of(const Eigen::Vector4d& v) {
  return {v[0], v[1], v[2], v[3]};
}

}  // namespace

PointLaw::PointLaw(const Material& material)
    : constants_(viscoelastic_constants(material)), updates_(constants_.branches.size()) {
  check_convolution_alone(material, "model.scheme");
}

void PointLaw::set_step(double step) {
  for (std::size_t i = 0; i < updates_.size(); ++i) {
    const double x = step / constants_.branches[i].relaxation_time;
    updates_[i] = {std::exp(-x), std::isinf(x) ? 0.0 : -std::expm1(-x) / x};
  }
}

PointLaw::StressWeights PointLaw::weights() const {
  StressWeights sum{constants_.long_term_deviatoric, constants_.long_term_volumetric};
  for (std::size_t i = 0; i < updates_.size(); ++i) {
    sum.deviatoric += updates_[i].gain * constants_.branches[i].deviatoric_share;
    sum.volumetric += updates_[i].gain * constants_.branches[i].volumetric_share;
  }
  return sum;
}

StressResponse PointLaw::respond(const Symmetric<double>& c, const BranchState* states) const {
  const Symmetric<Dual> seeded{Dual(c.rr, 4, 0), Dual(c.zz, 4, 1), Dual(c.tt, 4, 2),
                               Dual(c.rz, 4, 3)};
  const Strain<Dual> strain = strain_from(seeded);
  const auto zero = [] { return Dual(0.0, Eigen::Vector4d::Zero()); };
  Symmetric<Dual> total{zero(), zero(), zero(), zero()};
  with_elastic(constants_.elastic, [&](const auto& elastic) {
    weigh(total, weights().deviatoric, elastic.deviatoric_stress(strain));
    weigh(total, weights().volumetric, elastic.volumetric_stress(strain));
  });
  StressResponse response;
  const Dual* components[4] = {&total.rr, &total.zz, &total.tt, &total.rz};
  for (int i = 0; i < 4; ++i) {
    response.stress[i] = components[i]->value();
    response.tangent.row(i) = components[i]->derivatives();
  }
  response.tangent.leftCols<3>() *= 2.0;  // dC = 2 dE; C_rz moves with 2 E_rz as it is
  for (int i = 0; i < branch_count(); ++i)
    response.stress += updates_[i].decay * vector_of(states[i].stress) -
                       updates_[i].gain * vector_of(states[i].drive);
  return response;
}

PointLaw::Parts PointLaw::parts(const Symmetric<double>& c) const {
  const Strain<double> strain = strain_from(c);
  return with_elastic(constants_.elastic, [&](const auto& elastic) {
    return Parts{vector_of(elastic.deviatoric_stress(strain)),
                 vector_of(elastic.volumetric_stress(strain))};
  });
}

Symmetric<double> PointLaw::stress(const Symmetric<double>& c, const BranchState* states) const {
  const Parts now = parts(c);
  Eigen::Vector4d total =
      weights().deviatoric * now.deviatoric + weights().volumetric * now.volumetric;
  for (int i = 0; i < branch_count(); ++i)
    total += updates_[i].decay * vector_of(states[i].stress) -
             updates_[i].gain * vector_of(states[i].drive);
  return tensor_of(total);
}

void PointLaw::accept(const Symmetric<double>& c, BranchState* states) const {
  if (branch_count() == 0) return;
  const Parts now = parts(c);
  for (int i = 0; i < branch_count(); ++i) {
    const BranchConstants& branch = constants_.branches[i];
    const Eigen::Vector4d drive =
        branch.deviatoric_share * now.deviatoric + branch.volumetric_share * now.volumetric;
    states[i].stress = tensor_of(updates_[i].decay * vector_of(states[i].stress) +
                                 updates_[i].gain * (drive - vector_of(states[i].drive)));
    states[i].drive = tensor_of(drive);
  }
}

double PointLaw::energy_of(const Symmetric<double>& c, double deviatoric_share,
                           double volumetric_share) const {
  const Strain<double> strain = strain_from(c);
  return with_elastic(constants_.elastic, [&](const auto& elastic) {
    return deviatoric_share * elastic.deviatoric_energy(strain) +
           volumetric_share * elastic.volumetric_energy(strain);
  });
}

double PointLaw::stored_energy(const Symmetric<double>& c) const {
  return energy_of(c, constants_.long_term_deviatoric, constants_.long_term_volumetric);
}

double PointLaw::driving_energy(const Symmetric<double>& c) const {
  return energy_of(c, 1.0 - constants_.long_term_deviatoric, 1.0 - constants_.long_term_volumetric);
}

Symmetric<double> PointLaw::relaxed_stress(const BranchState* states) const {
  Symmetric<double> sum{};
  for (int i = 0; i < branch_count(); ++i) {
    weigh(sum, 1.0, states[i].drive);
    weigh(sum, -1.0, states[i].stress);
  }
  return sum;
}

double PointLaw::held_energy(const Symmetric<double>& c, const BranchState* states) const {
  const Moduli& moduli = constants_.instantaneous;
  double sum = 0.0;
  for (int i = 0; i < branch_count(); ++i) {
    const BranchConstants& branch = constants_.branches[i];
    const auto complementary = [&](const Symmetric<double>& a) {
      const double trace = a.rr + a.zz + a.tt;
      const double square = a.rr * a.rr + a.zz * a.zz + a.tt * a.tt + 2.0 * a.rz * a.rz;
      const double volume = branch.volumetric_share * moduli.bulk;
      return (square - trace * trace / 3.0) / (4.0 * branch.deviatoric_share * moduli.shear) +
             (volume > 0.0 ? trace * trace / (18.0 * volume) : 0.0);
    };
    const double rounding = 1e-14 * branch.deviatoric_share * moduli.shear;
    sum += complementary(states[i].stress) *
           (energy_of(c, branch.deviatoric_share, branch.volumetric_share) + rounding) /
           (complementary(states[i].drive) + rounding);
  }
  return sum;
}

}  // namespace rebound::fem
