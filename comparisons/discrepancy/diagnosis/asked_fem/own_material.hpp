#pragma once

#include <vector>

#include "comparisons/discrepancy/diagnosis/fits/hypothesis_fit.hpp"
#include "comparisons/inference/calibration/calibration_problem.hpp"
#include "comparisons/inference/calibration/observations.hpp"
#include "fem/interface/material.hpp"

/// What a ball of FE that hides nothing may be made of, and its numbers in a search.
///
///   neo-Hookean with one or two branches that have faded within the contact: loss without memory
namespace rebound {

/// Where a search for the material starts: Hertz from the lumped peak of the first of `shots`, less
/// what one branch of all stress adds.
/// Errors: Error(solver_failed) without a shot.
Material guess_fem_material(const Observations& seen, const std::vector<std::size_t>& shots,
                            const HypothesisFit& lumped);

/// Other kinds of ball, near one of one branch of all stress: with a slower branch beside it, and
/// with a branch of the deviator alone.
std::vector<Material> other_kinds_near(const Material& fitted, const Material& guess);

/// The same ball of another elastic law: Mooney and Rivlin's with three tenths of its modulus in
/// the second term, Ogden's of exponent 3, a hyperfoam of exponent 4. Neo-Hookean is Ogden's of 2.
std::vector<Material> other_laws_near(const Material& fitted);

/// How many numbers a search has for a material of this kind.
inline std::size_t numbers_of(const Material& kind) {
  return 2 + 2 * kind.branches.size();
}

/// Numbers in which a search describes a material: ln E, the Poisson ratio, and of each branch ln
/// of ratio and time. Bounds are those about a guess, which says the contact time.
/// Limit:  start and back gives the material again -> test OwnMaterial.ComesBackFromItsNumbers
class MaterialUnknowns {
 public:
  /// `start` says how many branches there are and what they relax.
  MaterialUnknowns(const Material& guess, const Material& start);

  std::size_t count() const { return numbers_of(kind_); }
  void add(std::vector<CalibrationParameter>& unknowns) const;
  /// `x`: the numbers come first in it.
  Material at(const std::vector<double>& x) const;

 private:
  Material guess_;
  Material kind_;
};

}  // namespace rebound
