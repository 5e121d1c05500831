#pragma once

#include <functional>
#include <memory>
#include <string>

#include "fem/interface/compression.hpp"
#include "fem/interface/fem_problem.hpp"
#include "fem/interface/fem_result.hpp"
#include "lumped/problem/run_control.hpp"
#include "meshes/mesh.hpp"

/// The narrow interface of the module that is loaded on first use, so that the
/// program itself links no deal.II and no MPI.
namespace rebound {

/// A body cut into cells, ready for any number of impacts. The object is not
/// changed by them: several may run at once.
class FemBody {
 public:
  virtual ~FemBody() = default;

  /// Runs one impact. Interruption returns a result marked incomplete; a
  /// solver failure does the same, so that what was known can be written.
  /// Errors: Error(bad_input) for a problem outside the tier's range.
  virtual FemResult simulate(const FemProblem& problem, const RunControl& control) const = 0;
};

/// Module "rebound_fem": FE impacts on a given mesh.
class FemTier {
 public:
  virtual ~FemTier() = default;

  /// Errors: Error(bad_input) for a mesh that cannot be used.
  virtual std::shared_ptr<const FemBody> prepare(const Mesh& mesh, double mass) const = 0;

  /// One impact on a mesh of its own.
  FemResult simulate(const FemProblem& problem, const Mesh& mesh, const RunControl& control) const {
    return prepare(mesh, problem.sphere.mass)->simulate(problem, control);
  }

  /// Presses a sphere without inertia; `mesh` is its lower half between two platens.
  /// Errors and interruption as FemBody::simulate.
  virtual CompressionResult compress(const CompressionProblem& problem, const Mesh& mesh,
                                     const RunControl& control) const = 0;

  /// Versions of what the module was built with, for provenance.
  virtual std::string versions() const = 0;
};

/// Runs one FE impact; whoever made it holds mesh and module. May be called
/// from several threads at once.
using FemRunner = std::function<FemResult(const FemProblem&)>;

/// Name of the entry point: an `extern "C"` function that takes the caller's
/// interface_stamp (a generated header) and returns an object living as long as the module, or null
/// when the stamp is not the module's own.
inline constexpr const char* fem_entry_point = "rebound_fem_tier";

}  // namespace rebound
