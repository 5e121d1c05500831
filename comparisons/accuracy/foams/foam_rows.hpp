#pragma once

#include <filesystem>

#include "comparisons/accuracy/foams/published_foam.hpp"
#include "comparisons/accuracy/verification/verification_row.hpp"
#include "fem/interface/material_laws.hpp"

namespace rebound {

/// Rows of `rebound verify`: initial modulus, Poisson ratio and stated stresses
/// of published foams, found from the FE materials' uniaxial states.
///
///   E = dP/dλ,  ν = −da/dλ  at λ = 1, by central differences of 1e-5
///   mean stress over a range of strain by Simpson's rule
///
/// Tolerance: the source's uncertainty, or 1e-6 where the value follows from the constants.
VerificationTable verify_foams(const MaterialLaws& laws, const std::vector<PublishedFoam>& foams);

/// Writes `foams.csv` and `foams.html`, the curves beside what is stated.
void write_foam_curves(const MaterialLaws& laws, const std::vector<PublishedFoam>& foams,
                       const std::filesystem::path& folder);

}  // namespace rebound
