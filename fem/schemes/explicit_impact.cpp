#include "fem/schemes/explicit_impact.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>

#include "fem/contact/rigid_plate.hpp"
#include "fem/kernel/cell_batches.hpp"
#include "fem/output/field_writer.hpp"
#include "fem/output/shape_recorder.hpp"
#include "fem/schemes/impact_limits.hpp"
#include "fem/schemes/impact_recorder.hpp"
#include "fem/schemes/prony_steps.hpp"
#include "lumped/problem/scalars.hpp"

namespace rebound::fem {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

class ExplicitImpact {
 public:
  ExplicitImpact(const Discretisation& body, const FemProblem& problem);
  FemResult run(const RunControl& control);

 private:
  void step();
  void kick();
  struct Motion {
    double kinetic = 0.0;   ///< [J]
    double momentum = 0.0;  ///< away from the plate [kg m/s]
  };
  Motion motion() const;
  double force_power(double drift) const;
  void record_samples(const Motion& before);
  bool contact_is_over() const;
  void choose_next_step();
  FemResult finish(std::string incomplete_because);

  const Discretisation& body_;
  const FemProblem& problem_;
  const CellKernel& kernel_;
  const ViscoelasticConstants material_;
  const CellBatches cells_;
  const CellArrays& arrays_ = cells_.arrays();
  RigidPlate plate_;
  std::vector<double> history_;
  std::vector<double> displacement_, velocity_, force_, inverse_mass_;
  double total_mass_ = 0.0;
  int pole_ = 0;  ///< the node farthest from the plate
  double expected_time_, end_time_;
  ImpactRecorder recorder_;
  FieldWriter fields_;
  ShapeRecorder shapes_;
  CellSummary summary_;
  double first_step_ = 0.0, step_before_ = 0.0, step_ = 0.0, smallest_step_ = 0.0;
  PronySteps prony_;
  long steps_ = 0;
  double time_ = 0.0;
  double internal_work_ = 0.0, constraint_work_ = 0.0, initial_kinetic_ = 0.0;
  double contact_radius_ = 0.0, contact_radius_peak_ = 0.0;
  double last_contact_ = 0.0;
  EnergyBook book_;
  double worst_energy_error_ = 0.0;
};

/// First step: what the cells at rest allow. Called before any deformation.
double step_at_rest(const CellArrays& cells, int width, double safety) {
  const double* frequencies = cells.rest_frequency_squared;
  return safety * 2.0 / std::sqrt(*std::max_element(frequencies, frequencies + cells.batches * width));
}

ExplicitImpact::ExplicitImpact(const Discretisation& body, const FemProblem& problem)
    : body_(body),
      problem_(problem),
      kernel_(choose_cell_kernel()),
      material_(viscoelastic_constants(problem.material)),
      cells_(body, material_, problem.material.elastic, kernel_.width),
      plate_(body),
      history_(cells_.make_history()),
      expected_time_(expected_contact_time(problem, material_.instantaneous)),
      end_time_(problem.controls.end_time > 0 ? problem.controls.end_time : 20 * expected_time_),
      recorder_(problem.controls.output_interval > 0 ? problem.controls.output_interval
                                                     : expected_time_ / 200,
                expected_time_),
      fields_(body, problem, 1.3 * expected_time_),
      shapes_(body, problem.controls.shape_frames, 1.3 * expected_time_),
      first_step_(step_at_rest(arrays_, kernel_.width, problem.controls.step_safety)),
      step_before_(first_step_),
      step_(first_step_),
      smallest_step_(first_step_),
      prony_(material_, first_step_) {
  const std::size_t size = 2 * (body.position.size() + 1);  // one unused node for padding lanes
  displacement_.assign(size, 0.0);
  velocity_.assign(size, 0.0);
  force_.assign(size, 0.0);
  inverse_mass_.assign(size, 0.0);
  for (int node = 0; node < body.node_count(); ++node) {
    inverse_mass_[2 * node] = inverse_mass_[2 * node + 1] = 1.0 / body.mass[node];
    velocity_[2 * node + 1] = -problem.impact.speed;
    total_mass_ += body.mass[node];
  }
  for (const int node : body.axis_nodes) inverse_mass_[2 * node] = 0.0;
  initial_kinetic_ = motion().kinetic;
  pole_ = static_cast<int>(std::max_element(body.position.begin(), body.position.end(),
                                            [](const auto& a, const auto& b) { return a[1] < b[1]; }) -
                           body.position.begin());
}

ExplicitImpact::Motion ExplicitImpact::motion() const {
  double radial = 0.0, axial = 0.0, momentum = 0.0;
  for (int node = 0; node < body_.node_count(); ++node) {
    const double m = body_.mass[node];
    const double vr = velocity_[2 * node];
    const double vz = velocity_[2 * node + 1];
    radial += m * vr * vr;
    axial += m * vz * vz;
    momentum += m * vz;
  }
  return {.kinetic = 0.5 * (radial + axial), .momentum = momentum};
}

double ExplicitImpact::force_power(double drift) const {
  // Four sums at once: a single one waits on itself. The size is even.
  double sums[4] = {};
  std::size_t i = 0;
  for (; i + 4 <= force_.size(); i += 4)
    for (int k = 0; k < 4; ++k) sums[k] += force_[i + k] * velocity_[i + k];
  for (int k = 0; i < force_.size(); ++i, ++k) sums[k] += force_[i] * velocity_[i];
  return 0.5 * drift * ((sums[0] + sums[1]) + (sums[2] + sums[3]));
}

void ExplicitImpact::kick() {
  const double span = 0.5 * (step_before_ + step_);
  for (std::size_t i = 0; i < velocity_.size(); ++i)
    velocity_[i] -= span * force_[i] * inverse_mass_[i];
}

/// Energies at the current instant t_n, from the velocities half a step
/// before and after; samples placed by the linear motion over the step.
void ExplicitImpact::record_samples(const Motion& before) {
  const Motion after = motion();
  const double kinetic = 0.5 * (before.kinetic + after.kinetic);
  const double centre_speed = 0.5 * (before.momentum + after.momentum) / total_mass_;
  book_.kinetic_centre_of_mass = 0.5 * total_mass_ * centre_speed * centre_speed;
  book_.kinetic_vibration = kinetic - book_.kinetic_centre_of_mass;
  book_.stored = kernel_.stored_energy(arrays_, displacement_.data());
  // An elastic body has no branches: its internal work is then not used, and
  // the balance below holds the stress against the energy it derives from.
  book_.branches = material_.branches.empty() ? 0.0 : internal_work_ - book_.stored;
  book_.contact_constraint = -constraint_work_;
  const double found = kinetic + book_.stored + book_.branches + book_.contact_constraint;
  worst_energy_error_ =
      std::max(worst_energy_error_, std::abs(found - initial_kinetic_) / initial_kinetic_);

  double mean_height = 0.0;
  for (int node = 0; node < body_.node_count(); ++node)
    mean_height += body_.mass[node] * displacement_[2 * node + 1];
  mean_height /= total_mass_;
  const double speed_now = after.momentum / total_mass_;
  while (recorder_.next_sample() < time_ + step_) {
    const double ahead = recorder_.next_sample() - time_;
    recorder_.add_sample(
        {.deflection = -(mean_height + ahead * speed_now),
         .pole_deflection = -(displacement_[2 * pole_ + 1] + ahead * velocity_[2 * pole_ + 1]),
         .contact_radius = contact_radius_},
        book_);
  }
}

void ExplicitImpact::choose_next_step() {
  const double allowed =
      problem_.controls.step_safety * 2.0 / std::sqrt(summary_.largest_frequency_squared);
  step_before_ = step_;
  // Steps change rarely: the branch coefficients follow every change.
  if (allowed < step_)
    step_ = 0.97 * allowed;
  else if (allowed > 1.1 * step_)
    step_ *= 1.02;
  smallest_step_ = std::min(smallest_step_, step_);
}

void ExplicitImpact::step() {
  std::fill(force_.begin(), force_.end(), 0.0);
  summary_ = kernel_.internal_forces(arrays_, prony_.data(), displacement_.data(),
                                     history_.data(), force_.data());
  const bool sampling = recorder_.next_sample() < time_ + step_;
  const Motion before = sampling ? motion() : Motion{};

  internal_work_ += force_power(step_before_);
  plate_.remember(velocity_);
  kick();
  const StepSpan span{.kick = 0.5 * (step_before_ + step_), .drift = step_};
  const PlateStep plate = plate_.hold_back(displacement_, velocity_, span);
  constraint_work_ += plate.constraint_work;
  contact_radius_ = plate.contact_radius;
  contact_radius_peak_ = std::max(contact_radius_peak_, contact_radius_);
  recorder_.add_impulse(plate.impulse, time_ - 0.5 * step_before_, time_ + 0.5 * step_);
  if (plate.impulse > 0.0) last_contact_ = time_ + 0.5 * step_;
  if (sampling) record_samples(before);
  internal_work_ += force_power(step_);

  for (std::size_t i = 0; i < displacement_.size(); ++i)
    displacement_[i] += step_ * velocity_[i];
  time_ += step_;
  ++steps_;
  fields_.write_due_frames(time_, displacement_, velocity_);
  shapes_.record_if_due(time_, displacement_);
  choose_next_step();
  prony_.advance(step_);
}

bool ExplicitImpact::contact_is_over() const {
  if (last_contact_ == 0.0 || time_ < 1.02 * last_contact_) return false;
  if (!(motion().momentum > 0.0)) return false;
  // Vibration of the lowest spheroidal mode (η = ω R/c_s ≈ 2.65) with all the
  // energy left in the body; the surface moves more than the mean, hence 4.
  const double shear_speed = std::sqrt(material_.long_term_deviatoric *
                                       material_.instantaneous.shear / body_.density);
  const double frequency = 2.65 * shear_speed / problem_.sphere.radius();
  const double left = book_.kinetic_vibration + book_.stored;
  const double amplitude = 4.0 * std::sqrt(2.0 * std::max(left, 0.0) / total_mass_) / frequency;
  return plate_.gap(displacement_) > amplitude;
}

FemResult ExplicitImpact::run(const RunControl& control) {
  std::string incomplete;
  constexpr int look_around_every = 32;
  while (incomplete.empty()) {
    step();
    if (!(summary_.smallest_jacobian > 0.0))
      incomplete = "a cell was turned inside out (Jacobian <= 0)";
    else if (!(step_ > 1e-4 * first_step_))
      incomplete = "the stable step fell below 1e-4 of its first value";
    else if (time_ > end_time_)
      incomplete = "the contact had not ended by the end time";
    if (!incomplete.empty() || steps_ % look_around_every != 0) continue;
    // NaN is never below or above anything: no comparison above would see it.
    if (!std::isfinite(motion().kinetic)) incomplete = "the motion is no longer finite";
    if (!incomplete.empty()) break;
    if (contact_is_over()) break;
    if (control.interrupted && control.interrupted()) incomplete = "interrupted";
    if (control.progress) control.progress(std::min(0.99, time_ / (1.3 * expected_time_)));
  }
  return finish(std::move(incomplete));
}

FemResult ExplicitImpact::finish(std::string incomplete_because) {
  FemResult result;
  result.trace = recorder_.trace();
  result.energies = recorder_.energies();
  result.cells = arrays_.cells;
  result.vertices = body_.node_count();
  result.steps = steps_;
  result.smallest_step = smallest_step_;
  result.kernel = kernel_.name;
  result.incomplete_because = std::move(incomplete_because);
  fields_.write_collection();
  result.shapes = shapes_.history();
  if (!result.incomplete_because.empty()) return result;

  const double v0 = problem_.impact.speed;
  const double rebound = recorder_.total_impulse() / total_mass_ - v0;
  const double rebound_by_momentum = motion().momentum / total_mass_;
  result.scalars = derive_scalars(result.trace, problem_.impact, last_contact_, rebound);
  result.restitution_momentum = rebound_by_momentum / v0;
  const double expected_impulse = total_mass_ * (v0 + rebound_by_momentum);
  result.closures.impulse =
      std::abs(integral(result.trace.time, result.trace.force) - expected_impulse) /
      expected_impulse;
  result.closures.energy = worst_energy_error_;
  result.contact_radius_peak = contact_radius_peak_;
  result.vibrational_energy_share = (book_.kinetic_vibration + book_.stored) / initial_kinetic_;
  result.contact_constraint_share = book_.contact_constraint / initial_kinetic_;
  return result;
}

}  // namespace

FemResult run_explicit_impact(const Discretisation& body, const FemProblem& problem,
                              const RunControl& control) {
  check_problem(problem);
  const auto start = Clock::now();
  ExplicitImpact impact(body, problem);
  const double setup = seconds_since(start);
  const auto loop = Clock::now();
  FemResult result = impact.run(control);
  result.wall_seconds = seconds_since(loop);
  result.setup_seconds = setup;
  return result;
}

}  // namespace rebound::fem
