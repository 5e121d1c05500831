#include "lumped/integration/composed/composed_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lumped/integration/check_mechanisms.hpp"
#include "lumped/integration/checked_setup.hpp"
#include "lumped/laws/make_law.hpp"
#include "lumped/mechanisms/adhesion.hpp"
#include "lumped/mechanisms/damping_factors.hpp"
#include "lumped/mechanisms/finite_sphere.hpp"
#include "lumped/mechanisms/pull_curves.hpp"
#include "lumped/mechanisms/reference_scales.hpp"
#include "lumped/mechanisms/relaxation.hpp"
#include "lumped/mechanisms/unloading_memory.hpp"

namespace rebound {

using Kind = ContactPhase::Kind;
using State = ComposedContact::State;

namespace {

Mechanisms checked(const LumpedProblem& problem, const AnyLaw& law) {
  check_mechanisms(problem.model.mechanisms, law, problem.sphere.radius());
  return problem.model.mechanisms;
}

}  // namespace

ComposedContact::ComposedContact(const LumpedProblem& problem)
    : law_(make_law(problem.model, problem.impact, problem.sphere)),
      mechanisms_(checked(problem, law_)),
      law_branch_(std::visit(
          []<class Law>(const Law& law) {
            if constexpr (law_has_branch<Law>) return law.branch();
            return RelaxationBranch{};
          },
          law_)),
      plate_(mechanisms_.plate),
      setup_(checked_setup(problem)),
      radius_(problem.sphere.radius()),
      elastic_(law_, mechanisms_, {.radius = radius_, .speed = setup_.speed}),
      damping_varies_(mechanisms_.damping != DampingFactors{}),
      added_damping_(std::visit(
          [this](const auto& law) {
            return added_damping_coefficient(law, mechanisms_.damping, radius_);
          },
          law_)),
      scales_(contact_scales(elastic_, setup_)),
      peak_force_(elastic_.elastic_force(scales_.deflection)),
      pull_off_(pull_off_force(mechanisms_.adhesion, radius_)),
      pull_scale_(std::visit([x = mechanisms_.pull.deflection_reach *
                                  radius_](const auto& law) { return law.elastic_force(x); },
                             law_)),
      body_compliance_(0.0) {
  const FiniteSphere& finite = mechanisms_.finite_sphere;
  if (finite.share != 0.0)
    body_compliance_ = body_compliance(
        {.share = finite.share,
         .poisson_ratio = finite.poisson_ratio,
         .radius = radius_,
         .reference_force = elastic_.elastic_force(reference_deflection_share * radius_)});
}

bool ComposedContact::needed(const LumpedProblem& problem) {
  return problem.model.mechanisms.act() || has_branch(problem.model.law);
}

std::size_t ComposedContact::state_count() const {
  const auto& branches = mechanisms_.further_relaxation;
  const bool further = branches[0].ratio != 0.0 || branches[1].ratio != 0.0;
  if (frame_moves()) return states;
  return further ? frame_displacement : further_relaxed;
}

State ComposedContact::state_scales() const {
  const double energy = 0.5 * setup_.mass * setup_.speed * setup_.speed;
  State scale = {scales_.deflection, setup_.speed, setup_.mass * setup_.speed, energy,
                 peak_force_,        peak_force_};
  // A stiff plate hardly moves, yet its motion is what the load cell reads.
  const double k = plate_.moves() ? plate_.stiffness : 1.0;
  scale[plate_displacement] = std::min(scales_.deflection, peak_force_ / k);
  scale[plate_velocity] = std::min(setup_.speed, peak_force_ / std::sqrt(k * plate_.mass));
  const double k_f = plate_.frame.moves() ? plate_.frame.stiffness : 1.0;
  scale[frame_displacement] = std::min(scales_.deflection, peak_force_ / k_f);
  scale[frame_velocity] = std::min(setup_.speed, peak_force_ / std::sqrt(k_f * plate_.frame.mass));
  const double omega = mode_angular_frequency(mechanisms_.mode);
  const double acceleration = peak_force_ / setup_.mass;
  scale[mode_displacement] = std::min(scales_.deflection, acceleration / (omega * omega));
  scale[mode_velocity] = std::min(setup_.speed, acceleration / omega);
  scale[further_relaxed] = scale[last_relaxed] = peak_force_;
  return scale;
}

State ComposedContact::initial_state() const {
  State y{};
  y[velocity] = setup_.speed;
  return y;
}

double ComposedContact::contact_share(const Phase& phase, const State& y) const {
  const double share = 1.0 - body_compliance_ * elastic_.stiffness(phase, y[approach]);
  constexpr double least_share = 0.05;
  return share > least_share ? share : std::numeric_limits<double>::quiet_NaN();
}

ComposedContact::Forces ComposedContact::forces(const Phase& phase, const State& y) const {
  const double x = y[approach];
  Forces f;
  f.elastic = elastic_.acting(phase, x);
  if (const RelaxationBranch& branch = mechanisms_.relaxation; branch.ratio != 0.0)
    f.branch = branch_force(branch, drive_of(branch, f.elastic, x), y[relaxed]);
  if (law_branch_.ratio != 0.0) f.branch += branch_force(law_branch_, f.elastic, y[law_relaxed]);
  for (std::size_t k = 0; k < mechanisms_.further_relaxation.size(); ++k)
    if (const RelaxationBranch& branch = mechanisms_.further_relaxation[k]; branch.ratio != 0.0)
      f.branch += branch_force(branch, drive_of(branch, f.elastic, x), y[further_relaxed + k]);
  const double rate = approach_rate(phase, y);
  f.damping = std::visit(
      [&](const auto& law) {
        return damping_varies_
                   ? damping_force(law, mechanisms_.damping, added_damping_, radius_, x, rate)
                   : law.damping_force(x, rate);
      },
      law_);
  if (pulls()) f.adhesion = -pull(phase, y);
  return f;
}

double ComposedContact::drive_of(const RelaxationBranch& branch, double elastic, double x) const {
  return branch_drive(branch, elastic, x / (reference_deflection_share * radius_));
}

double ComposedContact::deflection_left(const Phase& phase, const State& y) const {
  return remaining_deflection(mechanisms_.memory, y[approach],
                              phase.kind == Kind::loading ? y[approach] : phase.largest);
}

double ComposedContact::pull(const Phase& phase, const State& y) const {
  const PullCurves& curves = mechanisms_.pull;
  const double left = deflection_left(phase, y);
  const bool by_a_neck = phase.kind == Kind::pulled && left < 0.0;
  double pull = pull_off_;
  if (by_a_neck) pull *= neck_share(-left, mechanisms_.adhesion_reach * radius_);
  if (curves.act())
    pull += pull_scale_ * (by_a_neck ? pull_beyond(curves, -left, radius_)
                                     : pull_in_contact(curves, left, phase.largest, radius_,
                                                       phase.kind != Kind::loading));
  return pull;
}

ComposedContact::Forces ComposedContact::acting_forces(const Phase& phase, const State& y) const {
  if (!phase.apart()) return forces(phase, y);
  Forces f;
  if (phase.kind == Kind::pulled) f.adhesion = -pull(phase, y);
  return f;
}

void ComposedContact::derivative(const Phase& phase, const State& y, State& rate) const {
  const Forces f = acting_forces(phase, y);
  const double total = f.contact();
  const double closing = closing_speed(y);
  rate[approach] = approach_rate(phase, y);
  rate[velocity] = mechanisms_.gravity - total / setup_.mass;
  rate[impulse] = total;
  rate[dissipated] = (total - f.elastic) * closing;
  const auto relax = [&](const RelaxationBranch& branch, std::size_t state) {
    rate[state] = branch.ratio != 0.0
                      ? relaxed_rate(branch, drive_of(branch, f.elastic, y[approach]), y[state])
                      : 0.0;
  };
  relax(mechanisms_.relaxation, relaxed);
  relax(law_branch_, law_relaxed);
  relax(mechanisms_.further_relaxation[0], further_relaxed);
  relax(mechanisms_.further_relaxation[1], last_relaxed);
  // One by one: zeros for all states at once are compiled to an instruction that is slow to start.
  rate[plate_displacement] = rate[plate_velocity] = 0.0;
  rate[frame_displacement] = rate[frame_velocity] = 0.0;
  rate[mode_displacement] = rate[mode_velocity] = 0.0;
  if (plate_.moves()) {
    const PlateMotion plate = plate_motion(y), frame = frame_motion(y);
    const double extension_rate = plate.velocity - frame.velocity;
    rate[plate_displacement] = plate.velocity;
    rate[plate_velocity] = plate_acceleration(plate_, plate, frame, total);
    rate[dissipated] += plate_damping(plate_) * extension_rate * extension_rate;
    if (plate_.frame.moves()) {
      rate[frame_displacement] = frame.velocity;
      rate[frame_velocity] = frame_acceleration(plate_, plate, frame);
      rate[dissipated] += frame_damping(plate_.frame) * frame.velocity * frame.velocity;
    }
  }
  if (mechanisms_.mode.mass_fraction != 0.0) {
    const ModeMotion mode = mode_motion(y);
    const double outer_mass = (1.0 - mechanisms_.mode.mass_fraction) * setup_.mass;
    rate[mode_displacement] = mode.velocity;
    rate[mode_velocity] = mode_acceleration(mechanisms_.mode, mode, total / outer_mass);
    rate[dissipated] += mode_loss(mechanisms_.mode, mode, setup_.mass);
  }
}

double ComposedContact::centre_of_mass_deflection(const Phase& phase, const State& y) const {
  double x =
      y[approach] + y[plate_displacement] + mechanisms_.mode.mass_fraction * y[mode_displacement];
  if (body_compliance_ != 0.0 && phase.kind != Kind::pulled)
    x -= body_compliance_ * elastic_.acting(phase, y[approach]);
  return x;
}

double ComposedContact::contact_force(const Phase& phase, const State& y) const {
  return acting_forces(phase, y).contact();
}

double ComposedContact::instrument_force(const Phase& phase, const State& y) const {
  return plate_.moves() ? load_cell_force(plate_, plate_motion(y), frame_motion(y))
                        : contact_force(phase, y);
}

double ComposedContact::stored_energy(const Phase& phase, const State& y) const {
  double stored = elastic_.recoverable_energy(phase, y[approach]);
  if (body_compliance_ != 0.0) {
    const double force = elastic_.acting(phase, y[approach]);
    stored -= 0.5 * body_compliance_ * force * force;
  }
  return stored;
}

Closures ComposedContact::closures(const Phase& phase, const State& y, double time) const {
  const double m = setup_.mass;
  const double brought = 0.5 * m * setup_.speed * setup_.speed;
  const double stored = phase.apart() ? 0.0 : stored_energy(phase, y);
  double found = 0.5 * m * y[velocity] * y[velocity] + stored +
                 elastic_.lost_energy(phase, y[approach]) + y[dissipated] -
                 m * mechanisms_.gravity * centre_of_mass_deflection(phase, y);
  if (plate_.moves()) found += plate_energy(plate_, plate_motion(y), frame_motion(y));
  if (mechanisms_.mode.mass_fraction != 0.0)
    found += mode_energy(mechanisms_.mode, mode_motion(y), m);
  const double momentum = m * (setup_.speed - y[velocity]);
  const double weight = m * mechanisms_.gravity * time;
  return {.impulse = std::abs(y[impulse] - weight - momentum) / momentum,
          .energy = std::abs(found - brought) / brought};
}

}  // namespace rebound
