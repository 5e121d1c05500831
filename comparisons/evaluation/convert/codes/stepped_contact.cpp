#include "comparisons/evaluation/convert/codes/stepped_contact.hpp"

#include <algorithm>

#include "lumped/problem/error.hpp"

namespace rebound {

Observed stepped_impact(const SteppedContact& contact) {
  const double h = contact.step, k = contact.spring / contact.mass,
               c = contact.dashpot / contact.mass;
  constexpr int most_steps = 1'000'000;
  const bool predicted = contact.stepping == ContactStepping::predicted;
  double x = (predicted ? contact.late - 1.0 : contact.late) * h * contact.speed;
  double v = contact.speed, peak = 0.0, last_push = 0.0;
  for (int i = 1; i <= most_steps; ++i) {
    const double slope = predicted && x < 0.0 ? h * k + c : h * k;
    const double free = contact.stepping == ContactStepping::semi_implicit
                            ? v - h * (k * x + c * v)
                            : (v - slope * x) / (1.0 + h * c + h * h * k);
    const double next = std::min(v, free);  // a contact pushes, and does not pull
    if (next < v) last_push = i * h;
    peak = std::max(peak, contact.mass * (v - next) / h);
    v = next;
    x += h * v;
    if (x <= 0.0 && v <= 0.0)
      return {.restitution = -v / contact.speed, .contact_time = last_push, .peak_force = peak};
  }
  throw Error(ExitCode::solver_failed, "the ball does not come back in this code's steps");
}

}  // namespace rebound
