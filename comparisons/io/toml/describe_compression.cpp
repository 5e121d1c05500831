#include "comparisons/io/toml/describe_compression.hpp"

#include "comparisons/io/toml/describe_impact.hpp"
#include "comparisons/io/toml/describe_material.hpp"
#include "comparisons/io/toml/impact_file.hpp"
#include "comparisons/io/toml/reader.hpp"
#include "comparisons/models/fem_access/mesh_for.hpp"
#include "fem/interface/check_problem.hpp"

namespace rebound {
namespace {

void describe(Visitor& visit, Compression& compression) {
  visit.number<&Compression::platens>(
      compression,
      {.sentence = "2: between two platens, the deflection is their whole travel. 1: on one "
                   "plate, held by a uniform body force as in a slow impact; the deflection "
                   "is the centre of mass's.",
       .presence = Presence::optional});
  visit.number<&Compression::deflection>(
      compression, {.sentence = "Largest deflection; at most 0.6 radii a plate."});
  visit.number<&Compression::steps>(
      compression,
      {.sentence = "Steps over the path, and rows of the curve.", .presence = Presence::optional});
  visit.choice(
      {.name = "path",
       .sentence =
           "Up to the deflection so slowly that every branch has relaxed; or up and down in "
           "a given time, with the branches, without inertia.",
       .presence = Presence::optional},
      compression.path);
  visit.number<&Compression::duration>(
      compression, {.sentence = "Time of the whole path; of triangle and half-sine alone.",
                    .presence = Presence::optional});
  visit.number<&Compression::friction>(compression,
                                       {.sentence = "Coulomb coefficient of the plates; 0: smooth.",
                                        .presence = Presence::optional});
}

void describe_model(Visitor& visit, CompressionProblem& problem) {
  std::string tier = "fem";
  visit.text({.name = "tier", .sentence = "Compression is of the FE tier.", .allowed = {"fem"}},
             tier);
  visit.text(
      {.name = "mesh",
       .sentence = "A mesh of your own instead of `cells`, as in an impact file; between two "
                   "platens of the lower half, its upper edge in no group.",
       .presence = Presence::optional},
      problem.mesh_file);
  visit.number<&CompressionProblem::cells>(
      problem,
      {.sentence = "About how many nine-node cells, finer at the plate.",
       .presence = Presence::optional},
      takes_cells(problem.mesh_file));
  visit.table({.name = "material", .sentence = "What the ball is made of."}, problem.material);
}

}  // namespace

void describe(Visitor& visit, CompressionProblem& problem) {
  describe_schema(visit);
  visit.visit_table({.name = "compression", .sentence = "Rigid plates, without inertia."},
                    [&](Visitor& inner) { describe(inner, problem.compression); });
  visit.table({.name = "sphere", .sentence = "The ball."}, problem.sphere);
  visit.visit_table({.name = "model", .sentence = "The model of the ball."},
                    [&](Visitor& inner) { describe_model(inner, problem); });
}

CompressionProblem read_compression(const Document& document) {
  CompressionProblem problem;
  read_document(document, problem);
  resolve_mesh(document, problem.mesh_file);
  check_density(document, problem.sphere);
  document.locating([&] { check(problem); });
  return problem;
}

}  // namespace rebound
