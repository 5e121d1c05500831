#pragma once

#include <optional>
#include <string>

#include "fem/impact/energy_check.hpp"
#include "fem/impact/impact_recorder.hpp"
#include "fem/implicit/adhesive_sides.hpp"
#include "fem/implicit/equilibrium.hpp"
#include "fem/implicit/generalised_alpha.hpp"
#include "fem/implicit/implicit_fields.hpp"
#include "fem/implicit/plate_motion.hpp"
#include "fem/implicit/separation_time.hpp"
#include "fem/interface/fem_problem.hpp"
#include "fem/interface/fem_result.hpp"
#include "lumped/problem/run_control.hpp"

namespace rebound::fem {

/// One impact of the implicit scheme: run_implicit_impact() says what it solves. Its steps are in
/// implicit_steps.cpp, its beginning, samples and end in implicit_impact.cpp.
class ImplicitImpact {
 public:
  ImplicitImpact(const Mesh& mesh, const FemProblem& problem);
  FemResult run(const RunControl& control);

 private:
  void begin_approach();
  bool approach(double step, const RunControl& control);
  bool advance(double step, int cuts);
  Eigen::VectorXd first_guess(double step) const;
  EquilibriumTask task_of(double step) const;
  bool nearly_incompressible() const { return forces_.law().constants().mean_dilatation; }
  void accept(double step, MotionState next);
  void add_plate_work(double step, const Eigen::VectorXd& change, const Eigen::VectorXd& reactions,
                      double force);
  void show_to_fields(double step, const MotionState& next);
  void sample();
  void fill(EnergyBalance& balance) const;
  bool contact_is_over() const;
  FemResult finish(std::string incomplete_because);
  void conclude(FemResult& result) const;

  const FemProblem& problem_;
  QuadraticBody body_;
  BodyForces forces_;
  AdhesiveTraction traction_;  ///< its range chosen
  std::optional<AdhesiveSides> adhesion_;
  EquilibriumSearch search_;
  ActiveSet held_;
  std::optional<PlateMotion> plate_;  ///< where it moves
  GeneralisedAlpha method_;
  MotionState now_;
  Eigen::VectorXd last_change_;
  double expected_time_, end_time_, interval_;
  int steps_per_sample_;
  ImpactRecorder recorder_;
  std::optional<ImplicitFields> fields_;  ///< where they are asked for
  bool approaching_ = false;              ///< pulled, and not touched yet: nothing is recorded
  double touch_speed_;                    ///< [m/s]
  EnergyBalance energies_;
  std::string failure_;
  int pole_ = 0;
  long steps_ = 0;
  double smallest_step_;
  double constraint_work_ = 0.0, friction_work_ = 0.0;
  SeparationTime separation_;  ///< of the plate's push, adhesion not in it
  double pull_ = 0.0;          ///< of adhesion [N]
  double contact_radius_ = 0.0, contact_radius_peak_ = 0.0;
  EnergyCheck balance_;
};

}  // namespace rebound::fem
