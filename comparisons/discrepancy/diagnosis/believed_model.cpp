#include "comparisons/discrepancy/diagnosis/believed_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "comparisons/io/toml/describe_effect.hpp"
#include "comparisons/io/toml/describe_fem.hpp"
#include "comparisons/io/toml/describe_impact.hpp"
#include "comparisons/io/toml/describe_lumped.hpp"
#include "comparisons/io/toml/impact_file.hpp"
#include "comparisons/io/toml/reader.hpp"
#include "comparisons/io/toml/toml_writer.hpp"

namespace rebound {
namespace {

/// An impact file of which only [model] is needed.
struct BelievedFile {
  LumpedImpactFile impact;
};
struct BelievedFemFile {
  FemImpactFile impact;
};

void describe(Visitor& visit, BelievedFile& file) {
  LumpedProblem& problem = file.impact.problem;
  describe_schema(visit);
  visit.visit_table({.name = "impact", .sentence = "Not used.", .presence = Presence::optional},
                    [&](Visitor& inner) { rebound::describe(inner, problem.impact); });
  visit.visit_table({.name = "sphere", .sentence = "The ball.", .presence = Presence::optional},
                    [&](Visitor& inner) { rebound::describe(inner, problem.sphere); });
  visit.visit_table({.name = "model", .sentence = "The contact law and its numbers."},
                    [&](Visitor& inner) {
                      describe_lumped_model(inner, problem.model);
                      describe_effects(inner, file.impact.effects);
                    });
  visit.table({.name = "controls", .sentence = "Not used.", .presence = Presence::optional},
              problem.controls);
}

void describe(Visitor& visit, BelievedFemFile& file) {
  FemProblem& problem = file.impact.problem;
  describe_schema(visit);
  visit.visit_table({.name = "impact", .sentence = "Not used.", .presence = Presence::optional},
                    [&](Visitor& inner) { rebound::describe(inner, problem.impact); });
  visit.visit_table({.name = "sphere", .sentence = "The ball.", .presence = Presence::optional},
                    [&](Visitor& inner) { rebound::describe(inner, problem.sphere); });
  visit.visit_table({.name = "model", .sentence = "The ball's material, and what it hits."},
                    [&](Visitor& inner) {
                      describe_fem_model(inner, problem);
                      describe_effects(inner, file.impact.effects);
                    });
  visit.table(
      {.name = "controls", .sentence = "Resolution in time.", .presence = Presence::optional},
      problem.controls);
}

void check_same_ball(const Document& document, const Sphere& believed, const Dataset& dataset) {
  // Five standard deviations, and what rounding of a printed number allows.
  constexpr double deviations = 5.0, rounding = 0.005;
  const auto check = [&](const char* key, double file, double data, double uncertainty) {
    if (std::abs(file - data) <= deviations * uncertainty + rounding * data) return;
    throw document.error_at(std::string("sphere.") + key,
                            fmt::format("the model's ball is not that of '{}': {:.6g} against "
                                        "{:.6g} in SI units",
                                        dataset.name, file, data),
                            "the data set's own value, or no [sphere]");
  };
  check("mass", believed.mass, dataset.sphere.mass, dataset.mass_uncertainty.value_or(0.0));
  check("diameter", believed.diameter, dataset.sphere.diameter,
        dataset.diameter_uncertainty.value_or(0.0));
}

/// A file without a ball is completed, and checked, with the ball and the fastest shot of the data.
BelievedModel read_believed_fem(const Document& document, const std::vector<Dataset>& datasets) {
  BelievedFemFile file;
  read_document(document, file);
  FemProblem& problem = file.impact.problem;
  if (document.root().contains("sphere") && datasets.size() == 1)
    check_same_ball(document, problem.sphere, datasets.front());
  for (const Dataset& dataset : datasets) {
    FemImpactFile of_data = file.impact;
    of_data.problem.sphere = dataset.sphere;
    for (const MeasuredImpact& shot : dataset.shots)
      of_data.problem.impact.speed = std::max(of_data.problem.impact.speed, shot.impact.speed);
    complete_impact(document, of_data);
    problem.mesh_file = of_data.problem.mesh_file;
  }
  return {.model = {}, .fem = problem, .effects = file.impact.effects};
}

}  // namespace

BelievedModel read_believed_model(const Document& document, const std::vector<Dataset>& datasets) {
  if (document.root()["model"]["tier"].value<std::string>() == "fem")
    return read_believed_fem(document, datasets);
  BelievedFile file;
  read_document(document, file);
  if (document.root().contains("sphere") && datasets.size() == 1)
    check_same_ball(document, file.impact.problem.sphere, datasets.front());
  return {.model = file.impact.problem.model, .effects = file.impact.effects};
}

DiagnosisRequest request_for(const Document& document, std::vector<Dataset> datasets) {
  BelievedModel model = read_believed_model(document, datasets);
  DiagnosisRequest request;
  request.datasets = std::move(datasets);
  request.believed = std::move(model.model);
  request.believed_fem = std::move(model.fem);
  request.believed_effects = std::move(model.effects);
  return request;
}

std::string extended_model_toml(const Diagnosis& diagnosis, std::size_t ball) {
  const HypothesisFit& fit = diagnosis.best();
  const auto fem = fit.model->fem();
  const auto& shots = diagnosis.seen->shots;
  const auto of_ball = std::find_if(shots.begin(), shots.end(),
                                    [&](const MeasuredImpact& one) { return one.ball == ball; });
  const MeasuredImpact& shot = of_ball == shots.end() ? shots.front() : *of_ball;
  if (fem) {
    FemImpactFile file{.problem = fem->problem(), .effects = effects_of_ball(fit.effects, ball)};
    file.problem.sphere = diagnosis.seen->balls[ball].sphere;
    file.problem.impact.speed = shot.impact.speed;
    file.problem.material = fit.model->material_at(fit.values, ball);
    return write_toml(file);
  }
  LumpedImpactFile file;
  file.problem.sphere = diagnosis.seen->balls[ball].sphere;
  file.problem.impact.speed = shot.impact.speed;
  file.problem.model = fit.model->believed_at(fit.values, ball);
  if (!file.problem.model.damping_formula.empty() && shot.restitution.value)
    file.problem.model.restitution = shot.restitution.value;
  file.effects = effects_of_ball(fit.effects, ball);
  return write_toml(file);
}

}  // namespace rebound
