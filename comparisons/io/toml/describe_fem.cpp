#include "comparisons/io/toml/describe_fem.hpp"

#include "comparisons/io/toml/describe_effect.hpp"
#include "comparisons/io/toml/describe_impact.hpp"
#include "comparisons/io/toml/describe_material.hpp"
#include "comparisons/models/fem_access/mesh_for.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {

void describe(Visitor& visit, AdhesiveTraction& adhesion) {
  visit.number<&AdhesiveTraction::work>(
      adhesion, {.sentence = "Work of adhesion: what it takes to part the ball's surface from the "
                             "plate, per area at rest."});
  visit.number<&AdhesiveTraction::range>(
      adhesion,
      {.sentence = "Gap at which the traction has faded; absent: where the Tabor number is "
                   "0.1, between a hundredth and a tenth of the radius."});
}

void describe(Visitor& visit, FemControls& controls) {
  visit.number<&FemControls::step_safety>(
      controls, {.sentence = "Time step over the stable time step; implicit: over a 180th of the "
                             "Hertz contact time.",
                 .presence = Presence::optional});
  visit.number<&FemControls::output_interval>(
      controls, {.sentence = "Spacing of the trace; 0: a 200th of the Hertz contact time.",
                 .presence = Presence::optional});
  visit.number<&FemControls::end_time>(
      controls, {.sentence = "Give up when contact lasts longer; 0: 20 Hertz contact times.",
                 .presence = Presence::optional});
  visit.number<&FemControls::field_frames>(
      controls,
      {.sentence = "Frames over the contact with stress, energy density, dissipation and contact "
                   "pressure, for ParaView (fields/impact.pvd) and the report; needs --out.",
       .presence = Presence::optional});
}

void describe_fem_model(Visitor& visit, FemProblem& problem) {
  std::string tier = "fem";
  visit.text({.name = "tier", .sentence = "The tier this file is for.", .allowed = {"fem"}}, tier);
  if (visit.refused("tier")) return;  // a model of another kind
  visit.choice(
      {.name = "scheme",
       .sentence = "Explicit central differences on bilinear cells, or implicit generalised-alpha "
                   "on nine-node cells with a contact of its own: the independent check, a hundred "
                   "times slower.",
       .presence = Presence::optional},
      problem.scheme);
  visit.text(
      {.name = "mesh",
       .sentence = "A mesh of your own instead of `cells`, half the ball's section with x the "
                   "radius and y the height: Gmsh's .msh or .geo with physical curves "
                   "\"axis\" and \"contact\", or .step (meshed with about `cells`); a "
                   "relative path starts at this file's folder.",
       .presence = Presence::optional},
      problem.mesh_file);
  visit.number<&FemProblem::cells>(
      problem,
      {.sentence = "About how many cells the generated mesh has. One of the implicit scheme "
                   "does the work of four.",
       .presence = Presence::optional},
      takes_cells(problem.mesh_file));
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
  visit.visit_table({.name = "model", .sentence = "The model of the ball."}, [&](Visitor& inner) {
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
    throw Error(
        ExitCode::bad_input,
        "a file has gravity as an effect: write the impact file this problem was made from");
  FemImpactFile file{.problem = problem, .effects = {}};
  describe(visit, file);
  problem = file.problem;
}

}  // namespace rebound
