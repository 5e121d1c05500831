#include "fem/explicit/explicit_steps.hpp"

#include <algorithm>

#include "fem/contact/moving_plate.hpp"
#include "fem/contact/rigid_plate.hpp"
#include "fem/impact/adhesive_approach.hpp"
#include "fem/impact/impact_conclusion.hpp"
#include "fem/interface/adhesive_range.hpp"

namespace rebound::fem {
namespace {

std::unique_ptr<PlateContact> make_plate(const Discretisation& body, const FemProblem& problem,
                                         const AdhesiveTraction& adhesion) {
  const Plate& plate = problem.plate;
  if (plate.moves()) return std::make_unique<MovingPlate>(body, plate, adhesion);
  return std::make_unique<RigidPlate>(
      body, PlateSurface{.friction = plate.friction, .adhesion = adhesion});
}

/// Kinetic energy of the discrete body at `speed`, of which `motion` lacks `behind`.
double kinetic_at_touch(const BodyMotion& motion, double speed, double behind) {
  const double to_touch = speed / (speed - behind);
  return motion.kinetic() * to_touch * to_touch;
}

}  // namespace

// Velocities belong to half steps: the first, half a step before the touch, is
// that much less under gravity.
ExplicitImpact::ExplicitImpact(const Discretisation& body, const FemProblem& problem)
    : body_(body),
      problem_(problem),
      kernel_(choose_cell_kernel()),
      material_(viscoelastic_constants(problem.material)),
      cells_(body, material_, kernel_.width),
      step_(cells_, problem.controls),
      motion_(body, problem.impact.speed - 0.5 * step_.now() * problem.gravity,
              {body, cells_.cell_frequency_squared(), problem.controls.step_safety}),
      adhesion_(chosen_adhesion(problem, material_.instantaneous)),
      plate_(make_plate(body, problem, adhesion_)),
      history_(cells_.make_history()),
      expected_time_(expected_contact_time(problem, material_.instantaneous)),
      end_time_(problem.controls.end_time > 0 ? problem.controls.end_time : 20 * expected_time_),
      recorder_(problem.controls.output_interval > 0 ? problem.controls.output_interval
                                                     : expected_time_ / 200,
                expected_time_,
                problem.plate.moves() ? Reading::load_cell : Reading::contact_force),
      fields_(ImpactFields::create_if_requested(problem, {body, cells_, kernel_, material_},
                                                expected_time_)),
      prony_(material_, step_.now()),
      touch_speed_(problem.impact.speed),
      balance_(
          kinetic_at_touch(motion_, problem.impact.speed, 0.5 * step_.now() * problem.gravity)) {
  pole_ =
      static_cast<int>(std::max_element(body.position.begin(), body.position.end(),
                                        [](const auto& a, const auto& b) { return a[1] < b[1]; }) -
                       body.position.begin());
  if (adhesion_.acts()) begin_approach();
}

/// At the edge of the adhesive range, in the time before zero.
void ExplicitImpact::begin_approach() {
  approaching_ = true;
  auto& z = motion_.displacement;
  const auto lift = [&](double height) {
    for (int node = 0; node < body_.node_count(); ++node) z[2 * node + 1] = height;
  };
  const AdhesiveApproach start = adhesive_approach(problem_, adhesion_.reach(), [&](double height) {
    lift(height);
    return plate_->adhesive_energy(z);
  });
  lift(start.height);
  for (int node = 0; node < body_.node_count(); ++node)
    motion_.velocity[2 * node + 1] = 0.5 * step_.now() * problem_.gravity - start.speed;
}

/// Time zero is where the next two steps reach the plate.
void ExplicitImpact::look_for_touch() {
  const double speed = -motion_.momentum() / motion_.total_mass();
  const double gap = plate_->gap(motion_.displacement) + plate_->state().displacement;
  if (gap > 2.0 * speed * step_.now()) return;
  approaching_ = false;
  time_ = 0.0;
  touch_speed_ = speed + 0.5 * step_.before() * problem_.gravity;
}

/// Energies at the current instant t_n, from the velocities half a step before
/// and after. Half of what the plate takes at that instant is in their mean.
void ExplicitImpact::update_energies(const BodyMotion::Means& body, const PlateStep& now) {
  const double mass = motion_.total_mass();
  const double centre_speed = body.momentum / mass;
  energies_.kinetic_centre_of_mass = 0.5 * mass * centre_speed * centre_speed;
  energies_.kinetic_vibration = body.kinetic - energies_.kinetic_centre_of_mass;
  losses_.put_into(energies_, of_cells_);
  energies_.contact_constraint = 0.5 * now.constraint_work - constraint_work_;
  energies_.friction = friction_work_ == 0.0 ? 0.0 : 0.5 * now.friction_work - friction_work_;
  energies_.adhesion = plate_->adhesive_energy(motion_.displacement);
  const PlateState plate = plate_->state();
  energies_.plate_kinetic = plate.kinetic;
  energies_.plate_spring = plate.spring;
  energies_.plate_damper = plate.damper;
  energies_.gravity =
      problem_.gravity > 0.0 ? mass * problem_.gravity * motion_.mean_height() : 0.0;
  balance_.check(energies_);
}

/// Samples are placed by the linear motion over the step.
void ExplicitImpact::record_samples(const PlateStep& now) {
  const BodyMotion::Means body = motion_.means_since(velocity_before_);
  update_energies(body, now);
  const double mean_height = motion_.mean_height();
  const double speed_now = body.momentum_now / motion_.total_mass();
  const PlateState plate = plate_->state();
  const int pole = 2 * pole_ + 1;
  while (recorder_.next_sample() < time_ + step_.now()) {
    const double ahead = recorder_.next_sample() - time_;
    recorder_.add_sample(
        {.deflection = -(mean_height + ahead * speed_now),
         .pole_deflection = -(motion_.displacement[pole] + ahead * motion_.velocity[pole]),
         .contact_radius = contact_radius_,
         .plate_displacement = plate.displacement + ahead * plate.velocity},
        energies_);
  }
}

void ExplicitImpact::step() {
  const double behind = step_.before(), ahead = step_.now();
  const CellMotion now{.displacement = motion_.displacement.data(),
                       .velocity = motion_.velocity.data()};
  ImpactFields* const fields = approaching_ ? nullptr : fields_.get();
  if (fields) fields->see(time_, prony_.data(), now, history_);
  std::fill(motion_.force.begin(), motion_.force.end(), 0.0);
  const bool sampling = !approaching_ && recorder_.next_sample() < time_ + ahead;
  summary_ = sampling ? kernel_.forces_and_energies(arrays_, prony_.data(), now, history_.data(),
                                                    motion_.force.data(), of_cells_)
                      : kernel_.internal_forces(arrays_, prony_.data(), now, history_.data(),
                                                motion_.force.data());
  losses_.advance(summary_, behind);
  if (sampling) velocity_before_ = motion_.velocity;

  plate_->remember(motion_.velocity);
  const StepSpan span{.kick = 0.5 * (behind + ahead), .drift = ahead};
  motion_.kick(span.kick, problem_.gravity);
  if (fields) fields->before_plate(motion_.velocity);
  const PlateStep plate = plate_->apply_contact(motion_.displacement, motion_.velocity, span);
  constraint_work_ += plate.constraint_work;
  friction_work_ += plate.friction_work;
  contact_radius_ = plate.contact_radius;
  contact_radius_peak_ = std::max(contact_radius_peak_, contact_radius_);
  const double start = time_ - 0.5 * behind, end = time_ + 0.5 * ahead;
  if (fields) fields->after_plate(motion_.velocity, end);
  if (!approaching_) {
    recorder_.add_impulse(plate.impulse - plate.pull, start, end);
    recorder_.add_reading(plate.reading, start, end);
  }
  if (plate.impulse > 0.0) last_contact_ = end;
  if (sampling) record_samples(plate);

  motion_.drift(ahead);
  plate_->drift(ahead);
  time_ += ahead;
  ++steps_;
  step_.choose(summary_.largest_frequency_squared);
  prony_.advance(step_.now());
  if (approaching_) look_for_touch();
}

}  // namespace rebound::fem
