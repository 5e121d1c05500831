#pragma once

#include <algorithm>
#include <array>
#include <optional>

#include "lumped/integration/contact_end.hpp"
#include "lumped/integration/contact_scales.hpp"
#include "lumped/mechanisms/elastic_force.hpp"
#include "lumped/mechanisms/internal_mode.hpp"
#include "lumped/mechanisms/moving_plate.hpp"
#include "lumped/problem/lumped_problem.hpp"
#include "lumped/problem/result.hpp"

namespace rebound {

/// Contact law and mechanisms as one system of differential equations.
///
///   δ̇ = (V − w − s ṙ)/(1 − c F_e′),   m V̇ = m g − F,   J̇ = F,
///   F = F_e + q + F_d − P,   Ḋ = (F − F_e) (V − w − s ṙ) + plate and mode losses,
///   and z, y, w, r, ṙ as their own files say
///
///   δ   approach of the contact, what the law sees [m]
///   X   = δ − c F_e + y + s r, its centre of mass [m]
///   V   velocity of the centre of mass [m/s]
///   F   contact force [N]
///   J   impulse of F [N s]
///   D   energy lost, or held in the branch [J]
///
/// Order of composition: the law's F_e takes its factors, then the memory of
/// the largest approach; relaxation (the law's own branch and up to three more) and finite sphere
/// see the result. Adhesion sees nothing of it.
///
/// Valid:   every law with every set of mechanisms; friction is refused.
/// Limit:   without mechanisms the bare law -> test ComposedContactTest.NothingIsTheBareLaw.
/// Caution: zero-force: contact ends where the force without adhesion falls to
///          zero, at pull-off; a plate or a mode that rings may bring ball and
///          plate together again, which belongs to the same contact. While they
///          are apart the branch relaxes to no force. A pull that reaches beyond the
///          plate belongs to the contact, which ends where the pull does.
class ComposedContact {
 public:
  enum Index {
    approach,
    velocity,
    impulse,
    dissipated,
    relaxed,
    law_relaxed,
    plate_displacement,
    plate_velocity,
    mode_displacement,
    mode_velocity,
    further_relaxed,
    last_relaxed,
    frame_displacement,
    frame_velocity,
    states
  };
  using State = std::array<double, states>;
  using Phase = ContactPhase;

  /// Is a problem a composed contact, or a law alone that its own integrators take?
  static bool needed(const LumpedProblem& problem);

  /// Errors: Error(bad_input) for a law (see make_law) or mechanisms that cannot be.
  explicit ComposedContact(const LumpedProblem& problem);

  const ContactSetup& setup() const { return setup_; }
  const ContactScales& scales() const { return scales_; }
  /// States that a problem has: the last four are those of further branches and of a frame.
  /// An integrator whose error is a mean over the states takes no more.
  std::size_t state_count() const;
  /// Sizes of the states; local errors are taken of them.
  State state_scales() const;
  State initial_state() const;

  void derivative(const Phase& phase, const State& y, State& rate) const;

  double centre_of_mass_deflection(const Phase& phase, const State& y) const;
  double contact_force(const Phase& phase, const State& y) const;
  /// What the instrument reads: the load cell where the plate moves [N].
  double instrument_force(const Phase& phase, const State& y) const;
  bool plate_moves() const { return plate_.moves(); }
  bool frame_moves() const { return plate_.moves() && plate_.frame.moves(); }

  /// Something that ends a phase: its indicator passes zero in a direction.
  enum class Event { turning, reloading, released, separated, ruptured, touching, gone };
  struct EventFunction {
    Event event;
    bool falling;  ///< passes zero downwards
  };
  struct EventFunctions {
    std::array<EventFunction, 3> list;
    int count = 0;
  };
  /// What is to be watched in a phase.
  EventFunctions event_functions(const Phase& phase) const;
  /// Turning: rate of approach. Reloading: approach past the largest. Released:
  /// force without adhesion. Separated: deflection left. Ruptured: reach of a pull beyond the
  /// plate, less the gap. Touching: the lesser of both, a millionth of its scale above zero. Gone:
  /// reach of the ringing parts beyond first touch.
  double indicator(Event event, const Phase& phase, const State& y) const;
  /// The same where the derivative at y is known.
  double indicator(Event event, const Phase& phase, const State& y, const State& rate) const;

  /// The phase after `event`, its energy step counted in y; nothing at the end. Where it is nothing
  /// or open, the contact has ended, for now at least.
  std::optional<Phase> next_phase(Event event, const Phase& phase, State& y) const;

  Closures closures(const Phase& phase, const State& y, double time) const;

 private:
  struct Forces {
    double elastic = 0.0, branch = 0.0, damping = 0.0, adhesion = 0.0;
    double without_adhesion() const { return elastic + branch + damping; }
    double contact() const { return without_adhesion() + adhesion; }
  };
  static PlateMotion plate_motion(const State& y) {
    return {y[plate_displacement], y[plate_velocity]};
  }
  static PlateMotion frame_motion(const State& y) {
    return {y[frame_displacement], y[frame_velocity]};
  }
  static ModeMotion mode_motion(const State& y) { return {y[mode_displacement], y[mode_velocity]}; }
  double closing_speed(const State& y) const {
    return y[velocity] - y[plate_velocity] - mechanisms_.mode.mass_fraction * y[mode_velocity];
  }
  double approach_rate(const Phase& phase, const State& y) const {
    const bool body_gives_way = body_compliance_ != 0.0 && phase.kind != Phase::Kind::pulled;
    return body_gives_way ? closing_speed(y) / contact_share(phase, y) : closing_speed(y);
  }
  /// 1 − c F_e′. NaN near the largest x the correction can give, and beyond: the step is refused.
  double contact_share(const Phase& phase, const State& y) const;
  /// As if they touched.
  Forces forces(const Phase& phase, const State& y) const;
  /// Those that act: of a pull alone, or none, while they are apart.
  Forces acting_forces(const Phase& phase, const State& y) const;
  double pull(const Phase& phase, const State& y) const;
  double drive_of(const RelaxationBranch& branch, double elastic, double x) const;
  /// Deflection that is left for the elastic force; negative: a gap.
  double deflection_left(const Phase& phase, const State& y) const;
  double stored_energy(const Phase& phase, const State& y) const;
  bool remembers() const;
  bool pulls() const { return pull_off_ != 0.0 || mechanisms_.pull.act(); }
  /// Gap at which the last pull ends; 0: none beyond the plate [m].
  double reach_of_pulls() const {
    const double neck = pull_off_ != 0.0 ? mechanisms_.adhesion_reach : 0.0;
    return radius_ * std::max(neck, mechanisms_.pull.gap_reach);
  }
  bool may_touch_again(const State& y) const;

  AnyLaw law_;
  Mechanisms mechanisms_;
  RelaxationBranch law_branch_;  ///< the law's own; none where its ratio is zero
  Plate plate_;
  ContactSetup setup_;
  double radius_;
  ElasticForce elastic_;
  bool damping_varies_;   ///< is there a factor on the law's damping, or a damper beside it
  double added_damping_;  ///< C of a damper without a formula [N s/m]
  ContactScales scales_;
  double peak_force_;       ///< elastic force at the scale deflection [N]
  double pull_off_;         ///< P [N]
  double pull_scale_;       ///< F_r of a pull without a formula [N]
  double body_compliance_;  ///< c [m/N]
};

}  // namespace rebound
