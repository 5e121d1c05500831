#include "comparisons/discrepancy/trials/generator/impact_simulation.hpp"

#include <algorithm>
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>

#include "comparisons/discrepancy/trials/generator/contact_force.hpp"

namespace trials {
namespace {

using State = std::vector<double>;

/// Places in the state vector: positions downwards, then speeds; branches from `first_branch`.
enum Place { ball, ball_rate, plate, plate_rate, frame, frame_rate, inner, inner_rate };
enum LaterPlace { second = inner_rate + 1, second_rate, slip, first_branch };

double spring_force(const Oscillator& o, double extension, double rate) {
  return o.stiffness * extension + o.damping * rate;
}

/// The equations of motion of one shot.
class Motion {
 public:
  Motion(const ImpactModel& model, const ShotOrder& shot) : model_(model), law_(model, shot) {}

  double contact_force(const State& s) const {
    return law_.force(approach(s), std::span<const double>(s).subspan(first_branch));
  }

  double distant_pull(const State& s) const {
    if (!model_.distant_pull) return 0.0;
    const auto& pull = *model_.distant_pull;
    return pull.strength * std::exp(std::min(0.0, s[ball] - s[plate]) / pull.range);
  }

  /// What the cell under the plate reads.
  double reading(const State& s) const {
    if (model_.plate)
      return spring_force(*model_.plate, s[plate] - s[frame], s[plate_rate] - s[frame_rate]);
    return contact_force(s) - distant_pull(s);
  }

  void operator()(const State& s, State& rate, double) const {
    const double force = contact_force(s), pull = distant_pull(s);
    rate.assign(s.size(), 0.0);
    for (int i = ball; i < slip; i += 2) rate[i] = s[i + 1];
    double on_ball = pull - force, ball_mass = model_.mass;
    if (model_.inner) {
      const double between =
          spring_force(*model_.inner, s[inner] - s[ball], s[inner_rate] - s[ball_rate]);
      on_ball += between;
      ball_mass -= model_.inner->mass;
      rate[inner_rate] = -between / model_.inner->mass;
    }
    if (model_.second_ball) {
      const double between = hertz_force(model_.second_ball->stiffness, s[second] - s[ball]);
      on_ball += between;
      rate[second_rate] = -between / model_.second_ball->mass;
    }
    rate[ball_rate] = on_ball / ball_mass;
    move_support(s, force - pull, rate);
    const Approach now = approach(s);
    if (model_.slip_length > 0.0 && now.deflection > 0.0)
      rate[slip] = (now.rate - s[slip] * std::abs(now.rate)) / model_.slip_length;
    law_.branch_rates(now, s.data() + first_branch, rate.data() + first_branch);
  }

  void remember(const State& s) { largest_ = std::max(largest_, s[ball] - s[plate]); }

  /// Speed of the centre of mass of the ball [m/s].
  double ball_speed(const State& s) const {
    if (!model_.inner) return s[ball_rate];
    const double share = model_.inner->mass / model_.mass;
    return share * s[inner_rate] + (1.0 - share) * s[ball_rate];
  }

  Approach approach(const State& s) const {
    const double x = s[ball] - s[plate];
    return {.deflection = x,
            .rate = s[ball_rate] - s[plate_rate],
            .largest = std::max(largest_, x),
            .slip = s[slip],
            .touch_speed = law_.touch_speed()};
  }

 private:
  void move_support(const State& s, double force, State& rate) const {
    if (!model_.plate) return;
    const double on_frame =
        spring_force(*model_.plate, s[plate] - s[frame], s[plate_rate] - s[frame_rate]);
    rate[plate_rate] = (force - on_frame) / model_.plate->mass;
    if (model_.frame)
      rate[frame_rate] =
          (on_frame - spring_force(*model_.frame, s[frame], s[frame_rate])) / model_.frame->mass;
  }

  const ImpactModel& model_;
  ContactForce law_;
  double largest_ = 0.0;
};

State initial_state(const ImpactModel& model, double speed, double start) {
  State s(first_branch + model.branches.size(), 0.0);
  s[ball] = s[inner] = speed * start;
  s[ball_rate] = s[inner_rate] = speed;
  s[second] = s[ball];
  s[second_rate] = speed;
  if (model.second_ball) s[second] -= speed * model.second_ball->delay;
  return s;
}

/// The ball is on its way out and nothing holds it.
bool has_left(const Approach& now, double force) {
  return now.largest > 0.0 && now.rate < 0.0 && force == 0.0;
}

}  // namespace

double SimulatedImpact::at(double time) const {
  const double place = (time - start) / step;
  if (place < 0.0 || force.empty()) return 0.0;
  const auto i = static_cast<std::size_t>(place);
  if (i + 1 >= force.size()) return force.back();
  return force[i] + (place - static_cast<double>(i)) * (force[i + 1] - force[i]);
}

SimulatedImpact simulate(const ImpactModel& model, const ShotOrder& shot,
                         const SimulationTimes& times) {
  constexpr double steps_of_contact = 2000.0, longest_contact = 8.0;
  SimulatedImpact result;
  result.step = times.expected_contact / steps_of_contact;
  // Touch, not the start of the record, falls on a step.
  const double steps_before = model.distant_pull ? std::ceil(times.before / result.step) : 0.0;
  result.start = -steps_before * result.step;
  Motion motion(model, shot);
  State s = initial_state(model, shot.speed, result.start);
  boost::numeric::odeint::runge_kutta4<State> scheme;
  const double first_speed = motion.ball_speed(s);
  double end = 0.0, before = motion.contact_force(s);
  for (int i = 0;; ++i) {
    const double time = result.start + i * result.step;
    const double force = motion.contact_force(s);
    if (i > 0) result.contact_impulse += 0.5 * result.step * (force + before);
    before = force;
    result.force.push_back(motion.reading(s));
    result.peak_force = std::max(result.peak_force, result.force.back());
    if (result.contact_time == 0.0 && has_left(motion.approach(s), force)) {
      result.contact_time = time;
      end = time + times.after;
    }
    if (result.contact_time > 0.0 && time >= end) break;
    if (result.contact_time == 0.0 && time > longest_contact * times.expected_contact)
      throw NoRebound("the ball does not come off the plate");
    scheme.do_step(std::ref(motion), s, time, result.step);
    motion.remember(s);
  }
  result.momentum_change = model.mass * (first_speed - motion.ball_speed(s));
  result.restitution = -motion.ball_speed(s) / shot.speed;
  return result;
}

}  // namespace trials
