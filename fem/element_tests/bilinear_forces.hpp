#pragma once

#include <algorithm>
#include <vector>

#include "fem/discretisation/discretisation.hpp"
#include "fem/explicit/prony_steps.hpp"
#include "fem/kernel/cell_batches.hpp"

namespace rebound::fem {

/// The explicit kernel on one body with one material: forces and energy as
/// functions of the displacement [node][2], with the unused node at the end.
class BilinearForces {
 public:
  BilinearForces(const Discretisation& body, const Material& material, const CellKernel& kernel,
                 double step = 1.0)
      : constants_(viscoelastic_constants(material)),
        kernel_(kernel),
        cells_(body, constants_, kernel.width),
        prony_(constants_, step),
        step_(step),
        history_(cells_.make_history()),
        force_(2 * (body.position.size() + 1)) {}

  std::size_t size() const { return force_.size(); }
  const CellSummary& summary() const { return summary_; }

  /// Internal forces [N]; with branches the body moves on by one step.
  const std::vector<double>& force(const std::vector<double>& displacement,
                                   const double* velocity = nullptr) {
    std::fill(force_.begin(), force_.end(), 0.0);
    summary_ = kernel_.internal_forces(cells_.arrays(), prony_.data(),
                                       {.displacement = displacement.data(), .velocity = velocity},
                                       history_.data(), force_.data());
    prony_.advance(step_);
    return force_;
  }
  /// The same, and where the energy is.
  CellEnergies advance(const std::vector<double>& displacement, const double* velocity = nullptr) {
    CellEnergies energies;
    std::fill(force_.begin(), force_.end(), 0.0);
    summary_ = kernel_.forces_and_energies(
        cells_.arrays(), prony_.data(), {.displacement = displacement.data(), .velocity = velocity},
        history_.data(), force_.data(), energies);
    prony_.advance(step_);
    return energies;
  }
  /// Internal forces of the last call [N].
  const std::vector<double>& last_force() const { return force_; }
  double energy(const std::vector<double>& displacement) const {
    return kernel_.stored_energy(cells_.arrays(), displacement.data(), history_.data());
  }

 private:
  ViscoelasticConstants constants_;
  const CellKernel& kernel_;
  CellBatches cells_;
  PronySteps prony_;
  double step_;
  std::vector<double> history_, force_;
  CellSummary summary_;
};

}  // namespace rebound::fem
