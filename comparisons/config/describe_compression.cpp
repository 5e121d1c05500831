#include "comparisons/config/describe_compression.hpp"

#include <fmt/format.h>

#include "comparisons/config/describe_material.hpp"
#include "comparisons/config/describe_impact.hpp"
#include "comparisons/config/impact_file.hpp"
#include "comparisons/config/reader.hpp"

namespace rebound {
namespace {

void describe(Visitor& visit, Compression& compression) {
  visit.whole({.name = "platens",
               .sentence = "2: between two platens, the deflection is their whole travel. 1: on one "
                           "plate, held by a uniform body force as in a slow impact; the deflection "
                           "is the centre of mass's.",
               .presence = Presence::optional,
               .range = from_to(1.0, 2.0)},
              compression.platens);
  visit.number({.name = "deflection",
                .sentence = "Largest deflection; at most 0.6 radii a plate.",
                .unit = "mm",
                .range = above(0.0)},
               compression.deflection);
  visit.whole({.name = "steps",
               .sentence = "Steps over the path, and rows of the curve.",
               .presence = Presence::optional,
               .range = from_to(1.0, 100000.0)},
              compression.steps);
  visit.choice<CompressionPath>(
      {.name = "path",
       .sentence = "Up to the deflection so slowly that every branch has relaxed; or up and down in "
                   "a given time, with the branches, without inertia.",
       .presence = Presence::optional},
      {{"slow", CompressionPath::slow},
       {"triangle", CompressionPath::triangle},
       {"half-sine", CompressionPath::half_sine}},
      compression.path);
  auto duration = compression.path == CompressionPath::slow && compression.duration == 0.0
                      ? std::nullopt
                      : std::optional(compression.duration);
  visit.number({.name = "duration",
                .sentence = "Time of the whole path; of triangle and half-sine alone.",
                .presence = Presence::optional,
                .unit = "ms",
                .range = above(0.0)},
               duration);
  compression.duration = duration.value_or(0.0);
}

void describe_model(Visitor& visit, CompressionProblem& problem) {
  std::string tier = "fem";
  visit.text({.name = "tier", .sentence = "Compression is of the FE tier.", .allowed = {"fem"}}, tier);
  visit.whole({.name = "cells",
               .sentence = "About how many nine-node cells, finer at the plate.",
               .presence = Presence::optional,
               .range = from_to(20.0, 20000.0)},
              problem.cells);
  visit.table({.name = "material", .sentence = "What the ball is made of."}, problem.material);
}

}  // namespace

void describe(Visitor& visit, CompressionProblem& problem) {
  describe_schema(visit);
  visit.visit_table({.name = "compression", .sentence = "Rigid smooth plates, without inertia."},
                    [&](Visitor& inner) { describe(inner, problem.compression); });
  visit.table({.name = "sphere", .sentence = "The ball."}, problem.sphere);
  visit.visit_table({.name = "model", .sentence = "The model of the ball."},
                    [&](Visitor& inner) { describe_model(inner, problem); });
}

CompressionProblem read_compression(const Document& document) {
  CompressionProblem problem;
  read_document(document, problem);
  const Compression& plan = problem.compression;
  check_density(document, problem.sphere);
  check_material(document, problem.material);
  const double largest = 0.6 * problem.sphere.radius() * plan.platens;
  if (plan.deflection > largest)
    throw document.error_at("compression.deflection", "beyond what the cells can follow",
                            fmt::format("at most {:.4g} mm for {} of a ball of this size", 1e3 * largest,
                                        plan.platens == 2 ? "two platens" : "one plate"));
  const bool slow = plan.path == CompressionPath::slow;
  if (slow && plan.duration != 0.0)
    throw document.error_at("compression.duration", "the slow path has no duration");
  if (!slow && plan.duration == 0.0)
    throw document.error_at("compression.path", "this path needs a duration", "duration = \"4 ms\"");
  return problem;
}

}  // namespace rebound
