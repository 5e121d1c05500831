#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "comparisons/models/parallel/in_parallel.hpp"
#include "lumped/problem/error.hpp"
#include "lumped/problem/run_control.hpp"

namespace rebound {

/// `fit(i)` for every i below `count`, side by side. One that has no answer is left empty: a search
/// may end at numbers that an effect cannot have.
///
/// Errors: Error(interrupted); those of `fit` but Error(solver_failed) and Error(bad_input).
template <class Fit, class FitOf>
std::vector<std::optional<Fit>> fit_each(std::size_t count, const RunControl& control,
                                         const FitOf& fit) {
  std::vector<std::optional<Fit>> fits(count);
  in_parallel(count, [&](std::size_t i) {
    if (control.interrupted && control.interrupted())
      throw Error(ExitCode::interrupted, "interrupted while effects were fitted");
    try {
      fits[i] = fit(i);
    } catch (const Error& error) {
      if (error.code() != ExitCode::solver_failed && error.code() != ExitCode::bad_input) throw;
    }
  });
  return fits;
}

/// What `ask` says of these numbers, asked once. Where it throws nothing is kept, and the next call
/// asks again: a search may come back to numbers at which a ball does not rebound.
/// Limit: an error is no answer -> test EachFitTest.AnErrorIsNotKept.
template <class Answer, class Ask>
const Answer& kept_answer(std::map<std::vector<double>, Answer>& kept, std::vector<double> numbers,
                          const Ask& ask) {
  auto place = kept.find(numbers);
  if (place == kept.end()) place = kept.emplace(std::move(numbers), ask()).first;
  return place->second;
}

}  // namespace rebound
