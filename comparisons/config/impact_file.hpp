#pragma once

#include <filesystem>

#include "comparisons/config/document.hpp"
#include "lumped/problem/fem_problem.hpp"
#include "lumped/problem/lumped_problem.hpp"

namespace rebound {

/// Reads an impact file of one tier, with every check that needs more than
/// one value:
///
///   density   50 to 20000 kg/m³ implied by mass and diameter: a slip of a
///             unit or a prefix moves it by a thousand or more
///   damping   given once: directly, or by restitution and formula
///   FE        zero-force separation; ν ≤ 0.45; shares of the instantaneous
///             modulus sum below 1; v below the shear wave speed √(μ/ρ) of
///             the unrelaxed material; either `mesh` or `cells`
///
/// Errors: Error(bad_input) with file, line, key path, value and range;
/// Error(input_output_failed) for a file that cannot be read.
LumpedProblem read_lumped_file(const std::filesystem::path& file);
FemProblem read_fem_file(const std::filesystem::path& file);

/// The same from a document in memory.
LumpedProblem read_lumped_problem(const Document& document);
FemProblem read_fem_problem(const Document& document);

/// The check of mass against diameter, for any file with a [sphere].
void check_density(const Document& document, const Sphere& sphere);

}  // namespace rebound
