#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/accuracy/numerical_error/scalar_error.hpp"
#include "fem/interface/modules.hpp"

namespace rebound {

/// A scalar of an FE result that carries an error bar, under its key.
struct ScalarOfResult {
  const char* key;
  double (*value)(const FemResult&);
};
const std::vector<ScalarOfResult>& scalars_with_error();

/// What one run of the family took.
struct FamilyMember {
  int cells = 0;
  double speed = 0.0;  ///< [m/s]
  double step_safety = 0.0;
  long steps = 0;
  double wall_seconds = 0.0;
};

/// What the other way for branches to act would change, on the middle mesh. No error of cells or
/// steps: two laws that agree at small strain, and data alone can choose between them.
struct ModelForm {
  Relaxation other = Relaxation::multiplicative;
  std::vector<double> difference;  ///< other less this one, in the order of scalars_with_error()
};

/// An FE trace with its numerical error bar.
///
/// `result` is that of the finest mesh; its trace has two columns more,
/// force_uncertainty_N and deflection_uncertainty_m.
struct ReferenceImpact {
  FemResult result;
  std::vector<ScalarError> errors;   ///< in the order of scalars_with_error()
  std::vector<FamilyValues> values;  ///< what the bars are made of, in that order
  std::vector<FamilyMember> family;
  /// Empty: no branches, a scheme or a branch that has one form alone, or that form did not run
  /// to the end.
  std::optional<ModelForm> model_form;
  int contact_nodes = 0;  ///< of the coarsest mesh, within the largest contact radius
};

/// A trace is called a reference when peak force, peak deflection, contact time by
/// its tail and restitution are each known to this share of their value.
inline constexpr double reference_limit = 0.005;

/// A family whose coarsest mesh has fewer nodes in contact is not where errors fall as its
/// bars assume: restitution at low speed was six bars off with two.
inline constexpr int fewest_contact_nodes = 8;
inline constexpr const char* contact_nodes_key = "contact_nodes";

/// Those of the four that are not, contact_nodes_key first where those are too few. Empty: a
/// reference.
std::vector<std::string> beyond_reference_limit(const ReferenceImpact& reference);

/// What is known to the limit, or what is not, in words.
std::string words_of_reference(std::vector<std::string> beyond);

/// Runs one impact on a mesh and its two refinements by cutting cells into
/// four; on the middle one also with half the step, and at four speeds nearby.
///
/// Five speeds within ± 10 % on the middle mesh give the scatter about a parabola: the true value
/// is smooth in speed; what is not comes from nodes that engage and leave one by one. The peak of
/// the force is raised by ripple on any mesh: the root mean square of what the window means of the
/// two finer meshes differ by about it. scalar_error() says what of these a bar is made of.
///
/// The step's share is of second order in it and taken on the middle mesh,
/// where the step is twice that of the result: an upper estimate.
/// Band of the trace: largest |fine − medium| within ± 1/50 of the contact
/// time, as the ripple of the contact front wanders in time.
///
/// Bars say what cells and step do; not whether the material is right.
/// Limit: covers case d, case d′ and the values of 65 000 cells
///        -> tests ReferenceImpactTest, ReferenceBar.
/// Errors: Error(solver_failed) when a member does not complete;
///         Error(interrupted). No bar is ever given from fewer members.
ReferenceImpact run_reference(const FemTier& tier, const FemProblem& problem, const Mesh& coarse,
                              const RunControl& control);

}  // namespace rebound
