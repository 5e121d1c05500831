#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace rebound {

/// An initial-value problem and its events, as CVODE is to see it.
struct CvodeSystem {
  std::size_t size = 0;
  std::function<void(const double* y, double* rate)> rate;
  std::function<void(const double* y, double* indicators)> indicators;
  /// Forward sensitivities s = ∂y/∂p, one vector a direction: ṡ = (∂f/∂y) s + ∂f/∂p.
  std::size_t directions = 0;
  std::function<void(const double* y, std::size_t direction, const double* s, double* s_rate)>
      variation{};
};

struct CvodeTolerances {
  double relative = 1e-9;
  std::vector<double> absolute;  ///< one per state
  double newton = 0.1;           ///< share of the local error left to Newton; 0.1 is CVODE's own
  std::vector<double> parameter_sizes{};  ///< one per direction: scales its errors
};

/// SUNDIALS CVODES (Adams, Newton with a dense matrix; sensitivities solved together with the
/// states) behind values and exceptions. Without directions it is CVODE.
///
/// Errors: Error(solver_failed) with CVODE's own name for what happened. A
///         rate that is no number makes CVODE shorten the step.
class CvodeSolver {
 public:
  CvodeSolver(CvodeSystem system, const CvodeTolerances& tolerances,
              std::span<const double> initial);
  ~CvodeSolver();
  CvodeSolver(const CvodeSolver&) = delete;
  CvodeSolver& operator=(const CvodeSolver&) = delete;

  double* state();
  /// ∂y/∂p of one direction; zero at the start unless written to before restart().
  double* variation(std::size_t direction);

  /// Starts anew from the present state; event_functions indicators that pass zero in
  /// the given directions (−1 falling, +1 rising).
  void restart(double time, std::span<const int> directions = {});

  struct Reached {
    double time = 0.0;
    bool at_event = false;
    std::vector<bool> events;  ///< which of the indicators are zero there
  };
  /// Up to `time` or the first event.
  Reached advance(double time, const char* doing);

 private:
  struct Handles;
  std::unique_ptr<Handles> handles_;
};

}  // namespace rebound
