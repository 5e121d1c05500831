#pragma once

#include "comparisons/evaluation/export/export_target.hpp"

namespace rebound {

struct ExportedDeck {
  std::string text;
  std::vector<std::string> differences;  ///< as its head lists them
  int nodes = 0, elements = 0;           ///< of the ball
  double end_time = 0.0;                 ///< [s]
};

/// The target of that name. Errors: Error(bad_input) with the names there are.
const ExportTarget& export_target(const std::string& name);

/// The deck of an impact, with a head that says what is not the same there.
///
/// The deck ends at `controls.end_time`, or where that is 0 after 1.25 Hertz contact times of the
/// relaxed ball.
///
/// Limit:  CalculiX returns what the FE tier returns -> test ExportedDeckTest.CalculixAgrees
/// Errors: Error(bad_input) with the key of any physics that the code has no part for, so that
///         no deck leaves it out in silence; those of check(problem).
ExportedDeck export_deck(const ExportTarget& target, const FemProblem& problem, const Mesh& mesh);

}  // namespace rebound
