#pragma once

#include <string>
#include <vector>

#include "fem/discretisation/discretisation.hpp"
#include "lumped/problem/fem_problem.hpp"

namespace rebound::fem {

/// Writes VTU frames of the moving body and the PVD that lists them, for
/// ParaView. Does nothing when the problem asks for no frames.
///
/// Point data: displacement [m], velocity [m/s]. Cell positions are those at
/// rest; "Warp By Vector" with `displacement` shows the shape.
/// Files: frame-0000.vtu … and impact.pvd in `controls.field_directory`.
/// Errors: Error(input_output_failed) when a file cannot be written.
class FieldWriter {
 public:
  FieldWriter(const Discretisation& body, const FemProblem& problem, double expected_duration);

  /// Writes the frame that is due at `time`, if any.
  void write_due_frames(double time, const std::vector<double>& displacement,
                        const std::vector<double>& velocity);
  void write_collection() const;

 private:
  const Discretisation& body_;
  std::string directory_;
  double interval_ = 0.0;  ///< zero: off
  double next_ = 0.0;
  std::vector<std::pair<double, std::string>> frames_;
};

}  // namespace rebound::fem
