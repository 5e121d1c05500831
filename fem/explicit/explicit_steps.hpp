#pragma once

#include <memory>
#include <string>
#include <vector>

#include "fem/contact/plate_contact.hpp"
#include "fem/explicit/body_motion.hpp"
#include "fem/explicit/material_losses.hpp"
#include "fem/explicit/prony_steps.hpp"
#include "fem/explicit/stable_step.hpp"
#include "fem/impact/energy_check.hpp"
#include "fem/impact/impact_recorder.hpp"
#include "fem/interface/fem_problem.hpp"
#include "fem/interface/fem_result.hpp"
#include "fem/kernel/cell_batches.hpp"
#include "fem/output/impact_fields.hpp"
#include "lumped/problem/run_control.hpp"

namespace rebound::fem {

/// The state of an explicit impact and its one step: forces of the cells, plate, motion, samples.
/// explicit_impact.cpp runs it to its end.
class ExplicitImpact {
 public:
  ExplicitImpact(const Discretisation& body, const FemProblem& problem);
  FemResult run(const RunControl& control);

 private:
  void begin_approach();
  void step();
  void look_for_touch();
  void record_samples(const PlateStep& now);
  void update_energies(const BodyMotion::Means& body, const PlateStep& now);
  bool contact_is_over() const;
  FemResult finish(std::string incomplete_because);
  void conclude(FemResult& result) const;

  const Discretisation& body_;
  const FemProblem& problem_;
  const CellKernel& kernel_;
  const ViscoelasticConstants material_;
  const CellBatches cells_;
  const CellArrays& arrays_ = cells_.arrays();
  StableStep step_;
  BodyMotion motion_;
  std::vector<double> velocity_before_;  ///< half a step before the last sample's instant
  const AdhesiveTraction adhesion_;      ///< its range chosen
  std::unique_ptr<PlateContact> plate_;
  std::vector<double> history_;
  int pole_ = 0;  ///< the node farthest from the plate
  double expected_time_, end_time_;
  ImpactRecorder recorder_;
  std::unique_ptr<ImpactFields> fields_;  ///< null: none asked for
  CellSummary summary_;
  CellEnergies of_cells_;  ///< at the last sample
  MaterialLosses losses_;
  PronySteps prony_;
  long steps_ = 0;
  double time_ = 0.0;
  double constraint_work_ = 0.0, friction_work_ = 0.0;
  double contact_radius_ = 0.0, contact_radius_peak_ = 0.0;
  double last_contact_ = 0.0;
  bool approaching_ = false;  ///< pulled, and not touched yet: nothing is recorded
  double touch_speed_;        ///< [m/s]
  EnergyBalance energies_;
  EnergyCheck balance_;
};

}  // namespace rebound::fem
