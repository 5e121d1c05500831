#pragma once

#include <filesystem>

#include "comparisons/io/toml/document.hpp"
#include "comparisons/io/toml/impact_record.hpp"

namespace rebound {

/// Reads an impact file of one tier, with every check that needs more than
/// one value:
///
///   density   50 to 20000 kg/m³ implied by mass and diameter: a slip of a
///             unit or a prefix moves it by a thousand or more
///   damping   given once: directly, or by restitution and formula
///   FE        zero-force separation; ν ≤ 0.499; shares of the instantaneous
///             modulus sum below 1; v below the shear wave speed √(μ/ρ) of
///             the unrelaxed material; either `mesh` or `cells`
///   plate     mass and damping ratio beside a stiffness only; no friction
///   effects   with a form in the tier, each once, their requirements met
///
/// What comes back has the effects applied.
/// Errors: Error(bad_input) with file, line, key path, value and range;
/// Error(input_output_failed) for a file that cannot be read.
LumpedProblem read_lumped_file(const std::filesystem::path& file);
FemProblem read_fem_file(const std::filesystem::path& file);

/// The same from a document in memory.
LumpedProblem read_lumped_problem(const Document& document);
FemProblem read_fem_problem(const Document& document);

/// The file as it stands: its problem without its effects, and the effects.
/// Faults of the measurement are allowed among them here.
LumpedImpactFile read_lumped_impact(const Document& document);
FemImpactFile read_fem_impact(const Document& document);

/// What follows a reading: every check of the above, parameters that follow from others, the mesh's
/// path; for whoever read a record and changed its numbers. Gives the problem that is solved, with
/// the effects that act on the impact. Errors: as above, with the place in `document`.
LumpedProblem complete_impact(const Document& document, LumpedImpactFile& file);
FemProblem complete_impact(const Document& document, FemImpactFile& file);

/// The problem of a file with the file's effects applied.
/// Errors: those of apply_effects, with the place in the file.
LumpedProblem applied(const LumpedImpactFile& file, const Document& document);
FemProblem applied(const FemImpactFile& file, const Document& document);

/// A mesh file as given becomes an absolute path, relative ones from the document's folder, so that
/// the effective configuration means the same file elsewhere. Errors: Error(bad_input) for cells
/// beside a mesh that has its own.
void resolve_mesh(const Document& document, std::string& mesh_file);

/// The check of mass against diameter, for any file with a [sphere].
void check_density(const Document& document, const Sphere& sphere);

}  // namespace rebound
