#include "comparisons/config/describe_fem.hpp"

#include "comparisons/config/describe_effect.hpp"
#include "comparisons/config/describe_impact.hpp"
#include "comparisons/config/describe_material.hpp"
#include "comparisons/config/optional_number.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {

void describe(Visitor& visit, AdhesiveTraction& adhesion) {
  visit.number({.name = "work",
                .sentence = "Work of adhesion: what it takes to part the ball's surface from the "
                            "plate, per area at rest.",
                .unit = "J/m^2",
                .range = at_least(0.0)},
               adhesion.work);
  number_unless(visit, 0.0,
                {.name = "range",
                 .sentence = "Gap at which the traction has faded; absent: where the Tabor number is "
                             "0.1, between a hundredth and a tenth of the radius.",
                 .unit = "mm",
                 .range = at_least(0.0)},
                adhesion.range);
}

void describe(Visitor& visit, FemControls& controls) {
  visit.number({.name = "step_safety",
                .sentence = "Time step over the stable time step; implicit: over a 180th of the "
                            "Hertz contact time.",
                .presence = Presence::optional,
                .range = above_up_to(0.0, 1.0)},
               controls.step_safety);
  visit.number({.name = "output_interval",
                .sentence = "Spacing of the trace; 0: a 200th of the Hertz contact time.",
                .presence = Presence::optional,
                .unit = "us",
                .range = at_least(0.0)},
               controls.output_interval);
  visit.number({.name = "end_time",
                .sentence = "Give up when contact lasts longer; 0: 20 Hertz contact times.",
                .presence = Presence::optional,
                .unit = "ms",
                .range = at_least(0.0)},
               controls.end_time);
  visit.whole({.name = "field_frames",
               .sentence = "Frames over the contact with stress, energy density, dissipation and contact "
                           "pressure, for ParaView (fields/impact.pvd) and the report; needs --out.",
               .presence = Presence::optional,
               .range = from_to(0.0, 10000.0)},
              controls.field_frames);
}

void describe_fem_model(Visitor& visit, FemProblem& problem) {
  std::string tier = "fem";
  visit.text({.name = "tier", .sentence = "The tier this file is for.", .allowed = {"fem"}}, tier);
  visit.choice<FemScheme>(
      {.name = "scheme",
       .sentence = "Explicit central differences on bilinear cells, or implicit generalised-alpha "
                   "on nine-node cells with a contact of its own: the independent check, a hundred "
                   "times slower; plate rigid and smooth.",
       .presence = Presence::optional},
      {{"explicit", FemScheme::explicit_steps}, {"implicit", FemScheme::implicit_steps}},
      problem.scheme);
  visit.text({.name = "mesh",
              .sentence = "A mesh of your own (Gmsh, groups \"axis\" and \"contact\"), instead of "
                          "`cells`; a relative path starts at this file's folder.",
              .presence = Presence::optional},
             problem.mesh_file);
  auto cells = problem.mesh_file.empty() ? std::optional(problem.cells) : std::nullopt;
  visit.whole({.name = "cells",
               .sentence = "About how many cells the generated mesh has. One of the implicit scheme "
                           "does the work of four.",
               .presence = Presence::optional,
               .range = from_to(20.0, 1e6)},
              cells);
  if (cells) problem.cells = *cells;
  visit.table({.name = "material", .sentence = "What the ball is made of."}, problem.material);
  visit.table({.name = "plate",
               .sentence = "What the ball hits; absent: rigid, without friction.",
               .presence = Presence::optional},
              problem.plate);
  visit.table({.name = "adhesion",
               .sentence = "Traction that pulls the surface to the plate; absent: none.",
               .presence = Presence::optional},
              problem.adhesion);
}

void describe(Visitor& visit, FemImpactFile& file) {
  FemProblem& problem = file.problem;
  describe_schema(visit);
  visit.table({.name = "impact", .sentence = "Normal impact on a plate at rest, no spin."},
              problem.impact);
  visit.table({.name = "sphere", .sentence = "The ball."}, problem.sphere);
  visit.visit_table({.name = "model", .sentence = "The model of the ball."},
                    [&](Visitor& inner) {
                      describe_fem_model(inner, problem);
                      describe_effects(inner, file.effects);
                    });
  visit.table({.name = "controls",
               .sentence = "Resolution in time, and what is recorded.",
               .presence = Presence::optional},
              problem.controls);
}

void describe(Visitor& visit, FemProblem& problem) {
  if (problem.gravity != 0.0)
    throw Error(ExitCode::bad_input,
                "a file has gravity as an effect: write the impact file this problem was made from");
  FemImpactFile file{.problem = problem, .effects = {}};
  describe(visit, file);
  problem = file.problem;
}

}  // namespace rebound
