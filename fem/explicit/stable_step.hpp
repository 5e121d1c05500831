#pragma once

#include "fem/interface/fem_problem.hpp"
#include "fem/kernel/cell_batches.hpp"

namespace rebound::fem {

/// The step of central differences, as the cells allow it.
///
///   Δt ≤ s f(s) 2/ω      ω² largest of the cells' bounds [1/s²]
///   s   controls.step_safety      f   DispersionCorrection::step_factor
///
/// It falls at once where the cells ask for it, to 3 % below what they allow, and grows by
/// 2 % a step where they allow 10 % more; controls.largest_step caps it. Changes are rare on
/// purpose: the coefficients of the branches follow each. The first is 3 % below, too: at rest
/// the cells ask for what they were built with up to rounding, which must not decide.
///
/// Limit:  rounding moves no step -> test StepSequenceTest.RoundingMovesNoStep
/// Source: Irons & Treharne 1971 (bound by cells).
class StableStep {
 public:
  /// The first step: 3 % below what the cells at rest allow.
  StableStep(const CellBatches& cells, const FemControls& controls);

  /// The step that follows, for the largest ω² of the step just done.
  void choose(double largest_frequency_squared);

  double now() const { return now_; }        ///< [s]
  double before() const { return before_; }  ///< the step that led here [s]
  double smallest() const { return smallest_; }
  /// Below 1e-4 of the first, or no number: the run leads nowhere.
  bool collapsed() const { return !(now_ > 1e-4 * first_); }

 private:
  double allowed(double frequency_squared) const;
  double capped(double step) const;

  double safety_, largest_;
  double first_, before_, now_, smallest_;
};

}  // namespace rebound::fem
