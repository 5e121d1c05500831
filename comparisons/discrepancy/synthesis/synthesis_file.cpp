#include "comparisons/discrepancy/synthesis/synthesis_file.hpp"

#include <fmt/format.h>

#include "comparisons/discrepancy/synthesis/random_effects.hpp"
#include "comparisons/io/dataset/describe_dataset.hpp"
#include "comparisons/io/toml/describe_effect.hpp"
#include "comparisons/io/toml/describe_fem.hpp"
#include "comparisons/io/toml/describe_impact.hpp"
#include "comparisons/io/toml/describe_lumped.hpp"
#include "comparisons/io/toml/impact_file.hpp"
#include "comparisons/io/toml/reader.hpp"

namespace rebound {
namespace {

constexpr Presence optional = Presence::optional;

void describe_model(Visitor& visit, SynthesisFile& file) {
  visit.cases(
      {"lumped", "fem"}, file.tier == Tier::fem ? "fem" : "lumped",
      [&](const std::string& tier) { file.tier = tier == "fem" ? Tier::fem : Tier::lumped; },
      [&](Visitor& inner) {
        if (file.tier == Tier::fem)
          describe_fem_model(inner, file.fem);
        else
          describe_lumped_model(inner, file.lumped);
      });
  describe_effects(visit, file.effects);
}

void describe_sphere(Visitor& visit, SynthesisFile& file) {
  describe(visit, file.sphere);
  visit.number({.name = "mass_uncertainty",
                .sentence = "One standard deviation of the stated mass; the true one is drawn.",
                .presence = optional,
                .unit = "g",
                .range = at_least(0.0)},
               file.mass_uncertainty);
}

/// A plain impact file holds one impact, seen through an ideal instrument.
bool is_impact_file(const Document& document) {
  return document.root().contains("impact") && !document.root().contains("shot");
}

SynthesisFile from_impact_file(const Document& document) {
  SynthesisFile file;
  const auto take = [&](const auto& impact) {
    file.sphere = impact.problem.sphere;
    file.effects = impact.effects;
    file.shots.push_back({.speed = impact.problem.impact.speed});
  };
  if (document.root()["model"]["tier"].value<std::string>() == "fem") {
    const FemImpactFile impact = read_fem_impact(document);
    take(impact);
    file.tier = Tier::fem;
    file.fem = impact.problem;
  } else {
    const LumpedImpactFile impact = read_lumped_impact(document);
    take(impact);
    file.lumped = impact.problem.model;
  }
  return file;
}

void check_shots(const Document& document, const SynthesisFile& file) {
  if (file.shots.empty())
    throw document.error_at("shot", "the experiment has no shots", "[[shot]] tables, or [impact]");
  for (std::size_t i = 0; i < file.shots.size(); ++i) {
    const SynthesisShot& shot = file.shots[i];
    if (!shot.history && !shot.restitution_uncertainty && !shot.contact_time_uncertainty)
      throw document.error_at(fmt::format("shot[{}]", i), "nothing is seen of the shot",
                              "history = true, or a restitution_uncertainty or "
                              "contact_time_uncertainty");
  }
}

}  // namespace

void describe(Visitor& visit, SynthesisShot& shot) {
  visit.number({.name = "speed",
                .sentence = "Approach speed, as the data set will state it.",
                .unit = "m/s",
                .range = above_up_to(0.0, 1000.0)},
               shot.speed);
  visit.whole({.name = "repeats",
               .sentence = "How many such impacts.",
               .presence = optional,
               .range = from_to(1.0, 1000.0)},
              shot.repeats);
  visit.flag({.name = "history", .sentence = "Record the force history.", .presence = optional},
             shot.history);
  visit.number({.name = "speed_uncertainty",
                .sentence = "One standard deviation of the stated speed; true ones are drawn.",
                .presence = optional,
                .unit = "m/s",
                .range = at_least(0.0)},
               shot.speed_uncertainty);
  visit.number({.name = "restitution_uncertainty",
                .sentence = "Measure the restitution as well, with this standard deviation.",
                .presence = optional,
                .range = above_up_to(0.0, 1.0)},
               shot.restitution_uncertainty);
  visit.number({.name = "contact_time_uncertainty",
                .sentence = "Measure the contact time as well, with this standard deviation.",
                .presence = optional,
                .unit = "ms",
                .range = above(0.0)},
               shot.contact_time_uncertainty);
}

void describe(Visitor& visit, SynthesisSampling& sampling) {
  visit.number({.name = "rate",
                .sentence = "Samples of the force per second.",
                .presence = optional,
                .unit = "kHz",
                .range = above_up_to(0.0, 1e8)},
               sampling.rate);
  visit.number({.name = "before",
                .sentence = "Recorded before first touch.",
                .presence = optional,
                .unit = "ms",
                .range = from_to(0.0, 1.0)},
               sampling.before);
  visit.number({.name = "after",
                .sentence = "Recorded after separation.",
                .presence = optional,
                .unit = "ms",
                .range = from_to(0.0, 1.0)},
               sampling.after);
  visit.number({.name = "trigger_jitter",
                .sentence = "One standard deviation of the place of first touch in the record.",
                .presence = optional,
                .unit = "ms",
                .range = from_to(0.0, 0.1)},
               sampling.trigger_jitter);
}

void describe(Visitor& visit, RandomEffects& random) {
  visit.whole({.name = "count",
               .sentence = "How many effects are drawn beside those of the model; the truth says "
                           "which.",
               .range = from_to(0.0, 4.0)},
              random.count);
  visit.texts({.name = "among",
               .sentence = "Names that are drawn from; absent: all that the tier has a form for, "
                           "without free forms.",
               .presence = optional},
              random.among);
}

void describe(Visitor& visit, SynthesisFile& file) {
  describe_schema(visit);
  visit.text({.name = "name", .sentence = "What the data set is called.", .presence = optional},
             file.name);
  visit.whole({.name = "seed",
               .sentence = "Of every number that is drawn.",
               .presence = optional,
               .range = from_to(0.0, 9e15)},
              file.seed);
  visit.visit_table({.name = "sphere", .sentence = "The ball, as the data set will state it."},
                    [&](Visitor& inner) { describe_sphere(inner, file); });
  visit.visit_table({.name = "model", .sentence = "What really happens: a model of either tier."},
                    [&](Visitor& inner) { describe_model(inner, file); });
  visit.table({.name = "instrument",
               .sentence = "The measuring chain as the data set will state it. Its uncertainties "
                           "are honest: the true gain is drawn from them.",
               .presence = optional},
              file.instrument);
  visit.table({.name = "sampling", .sentence = "How the force is sampled.", .presence = optional},
              file.sampling);
  visit.table(
      {.name = "random",
       .sentence = "Effects drawn by the seed: kind, sign where both are possible, and size, "
                   "a third to three times what would surprise nobody.",
       .presence = optional},
      file.random);
  visit.list({.name = "shot", .sentence = "One impact; repeat for more.", .presence = optional},
             file.shots);
}

SynthesisFile read_uncompleted_synthesis(const Document& document) {
  SynthesisFile file;
  if (document.root()["model"]["tier"].value<std::string>() == "fem") file.tier = Tier::fem;
  read_document(document, file);
  return file;
}

void complete_synthesis(const Document& document, SynthesisFile& file) {
  check_density(document, file.sphere);
  check_shots(document, file);
  draw_effects(document, file);
  resolve_mesh(document, file.fem.mesh_file);
}

SynthesisFile read_synthesis(const Document& document) {
  if (is_impact_file(document)) return from_impact_file(document);
  SynthesisFile file = read_uncompleted_synthesis(document);
  complete_synthesis(document, file);
  return file;
}

}  // namespace rebound
