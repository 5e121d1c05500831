#pragma once

#include <algorithm>
#include <array>
#include <tuple>
#include <vector>

#include "lumped/integration/composed/composed_contact.hpp"
#include "lumped/integration/fast/dormand_prince.hpp"
#include "lumped/problem/trace.hpp"

namespace rebound {

/// How a composed contact ended.
struct ComposedEnd {
  double time = 0.0;  ///< contact time [s]
  ComposedContact::State state{};
  ContactPhase phase;
};

/// One step of a composed contact.
struct ComposedStepEnd {
  double time;    ///< where it begins [s]
  double length;  ///< [s]
  ContactPhase phase;
  ComposedContact::State state, rate;          ///< where it begins
  ComposedContact::State end_state, end_rate;  ///< where it ends
};

/// All states at a fraction of a step, by cubic Hermite polynomials. Only the first `Used` move;
/// the others are zero.
template <std::size_t Used = ComposedContact::states>
ComposedContact::State state_within(const ComposedStepEnd& step_end, double fraction) {
  const double s = fraction, r = 1.0 - s;
  const double value0 = r * r * (1.0 + 2.0 * s), slope0 = step_end.length * s * r * r;
  const double value1 = s * s * (1.0 + 2.0 * r), slope1 = -step_end.length * s * s * r;
  ComposedContact::State y;
  for (std::size_t i = 0; i < Used; ++i)
    y[i] = value0 * step_end.state[i] + slope0 * step_end.rate[i] + value1 * step_end.end_state[i] +
           slope1 * step_end.end_rate[i];
  std::fill(y.begin() + Used, y.end(), 0.0);
  return y;
}

/// Integrates a composed contact by explicit steps in time: Dormand–Prince
/// 5(4), local error of every state below the tolerance times its scale.
///
/// Turning points, reloading, separation and touching again are ends of steps:
/// the step is shortened until the indicator is zero, and the next one starts
/// in the new phase. Samples come from cubic Hermite polynomials of all states.
///
/// Valid:   every law, every set of mechanisms, both separation rules.
/// Limit:   same scalars as CVODE -> test
/// EffectBattery.EnergyBalanceClosesAndCvodeAgreesWithTheFastPath. Caution: explicit: a branch far
/// faster or a plate far stiffer than the
///          contact needs many steps; simulate() takes those.
/// Errors:  Error(solver_failed) when the contact does not end, turns or parts more than 400 times,
///          or steps run out -> test PullCurvesTest.ABallThatIsHeldAndBouncesIsGivenUp.
class ComposedIntegrator {
 public:
  explicit ComposedIntegrator(const ComposedContact& contact);
  ~ComposedIntegrator();
  ComposedIntegrator(const ComposedIntegrator&) = delete;
  ComposedIntegrator& operator=(const ComposedIntegrator&) = delete;

  const ComposedEnd& integrate();

  /// At the instants of fill_sample_instants().
  Trace sample(const LumpedControls& controls) const;

  const std::vector<ComposedStepEnd>& step_ends() const { return step_ends_; }

 private:
  using State = ComposedContact::State;
  using Event = ComposedContact::Event;
  using Step = DormandPrinceStep<ComposedContact::states>;

  using EventFunctions = ComposedContact::EventFunctions;
  using Indicators = std::array<double, std::tuple_size_v<decltype(EventFunctions::list)>>;

  struct Start {
    double time = 0.0;
    ContactPhase phase;
    State state{}, rate{};
    EventFunctions watched;
    Indicators indicators{};  ///< of what is watched
  };
  /// An event within a step, and how far into it.
  struct Found {
    Event event = Event::gone;
    double length = 0.0;
    bool any = false;
    Indicators indicators{};  ///< where the whole step ends
  };

  Step step_of(const Start& start, double length) const;
  double error_norm(const Step& step) const;
  double indicator_after(Event event, const Start& start, double length) const;
  double locate(Event event, const Start& start, double before, double length) const;
  void watch(Start& start) const;
  Found first_event(const Start& start, const Step& step, double length) const;
  void keep(const Start& start, const Step& step, double length);
  bool finish_if_over(const Found& found, Start& start);

  const ComposedContact& contact_;
  std::size_t states_used_;
  State weight_{};  ///< 1 / absolute tolerance of each state
  ComposedEnd end_;
  std::vector<ComposedStepEnd> step_ends_;
  std::size_t step_ends_at_release_ = 0;
};

}  // namespace rebound
