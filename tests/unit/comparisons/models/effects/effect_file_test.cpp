// [[model.effect]] and [model.plate] of impact files: reading, writing, refusing.
#include <gtest/gtest.h>

#include "comparisons/io/toml/describe_fem.hpp"
#include "comparisons/io/toml/describe_lumped.hpp"
#include "comparisons/io/toml/help_writer.hpp"
#include "comparisons/io/toml/impact_file.hpp"
#include "comparisons/io/toml/schema_writer.hpp"
#include "comparisons/io/toml/toml_writer.hpp"
#include "tests/support/effect_cases.hpp"
#include "tests/support/refusals.hpp"

namespace rebound {
namespace {

using testing::refusal_of;

const std::string file = R"(schema = 1
[impact]
speed = "15 m/s"
[sphere]
mass = "89.6 g"
diameter = "66.2 mm"
[model]
tier = "lumped"
law = "hunt-crossley"
stiffness = "3.5e6 N/m^1.5"
damping = "17.63e4 N.s/m^2.5"
)";

LumpedImpactFile read(const std::string& more) {
  return read_lumped_impact(Document::parse(file + more, "f.toml"));
}

Error refused(const std::string& more) {
  return refusal_of([&] { read_lumped_problem(Document::parse(file + more, "f.toml")); });
}

TEST(EffectFileTest, UnitsAreThoseOfTheCard) {
  const auto effects = read(R"([[model.effect]]
name = "plate-compliance"
size = "0.02 um/N"
mass = "1500 g"
[[model.effect]]
name = "relaxation"
size = 0.25
relaxation_time = "0.8 ms"
)")
                           .effects;
  ASSERT_EQ(effects.size(), 2u);
  EXPECT_EQ(effects[0].size, 0.02e-6);
  EXPECT_EQ(effects[0].parameters.at("mass"), 1.5);
  EXPECT_EQ(effects[0].parameters.at("damping_ratio"), 0.02);
  EXPECT_EQ(effects[1].parameters.at("relaxation_time"), 0.8e-3);
}

TEST(EffectFileTest, RefusesWithLineAndKey) {
  struct Case {
    const char *text, *key, *part;
    int line;
  };
  const Case cases[] = {
      {"[[model.effect]]\nname = \"permanent-sett\"\nsize = 0.1\n", "model.effect[0].name",
       "did you mean \"permanent-set\"", 13},
      {"[[model.effect]]\nname = \"permanent-set\"\n", "model.effect[0].size", "missing", 12},
      {"[[model.effect]]\nsize = 0.1\n", "model.effect[0].name", "missing force-exponent |", 12},
      {"[[model.effect]]\nname = \"permanent-set\"\nsize = 0.95\n", "model.effect[0].size",
       "0 <= value <= 0.9", 14},
      {"[[model.effect]]\nname = \"adhesion\"\nsize = 20\n", "model.effect[0].size", "J/m^2", 14},
      {"[[model.effect]]\nname = \"gravity\"\nsize = 1\nmass = \"1 kg\"\n", "model.effect[0].mass",
       "not known", 15},
      {"[[model.effect]]\nname = \"force-gain\"\nsize = 0.02\n", "model.effect[0].name",
       "synthesize", 13},
      {"[[model.effect]]\nname = \"plate-friction\"\nsize = 0.3\n", "model.effect[0].name",
       "no form in the lumped tier", 13},
      {"[[model.effect]]\nname = \"low-loss-damping-formula\"\nsize = 1\n", "model.effect[0].name",
       "restitution", 13},
      {"[model.plate]\nfriction = 0.3\n", "model.plate.friction", "no lumped form", 13},
      {"[model.plate]\nmass = \"2 kg\"\n", "model.plate.mass", "stiffness", 13},
  };
  for (const Case& c : cases) {
    SCOPED_TRACE(c.text);
    const Error error = refused(c.text);
    EXPECT_EQ(error.code(), ExitCode::bad_input);
    EXPECT_EQ(error.location().key, c.key);
    EXPECT_EQ(error.location().line, c.line);
    const std::string all = std::string(error.what()) + " " + error.location().allowed;
    EXPECT_NE(all.find(c.part), std::string::npos) << all;
  }
}

TEST(EffectFileTest, AnEffectThatCannotBeComposedIsRefusedWhenRead) {
  const Error error = refused("[[model.effect]]\nname = \"damping-exponent\"\nsize = -1.8\n");
  EXPECT_EQ(error.code(), ExitCode::bad_input);
}

TEST(EffectFileTest, PlateReadsAndWritesBack) {
  const LumpedImpactFile impact =
      read("[model.plate]\nstiffness = \"50 MN/m\"\nmass = \"2.5 kg\"\n");
  const Plate& plate = impact.problem.model.mechanisms.plate;
  EXPECT_EQ(plate.stiffness, 50e6);
  EXPECT_EQ(plate.mass, 2.5);
  EXPECT_EQ(plate.damping_ratio, 0.02);
  const std::string text = write_toml(impact);
  EXPECT_EQ(read_lumped_impact(Document::parse(text, "f")).problem, impact.problem);
  EXPECT_EQ(write_toml(impact.problem), text);
}

TEST(EffectFileTest, AnAppliedProblemIsNotWrittenWithoutItsEffects) {
  LumpedProblem problem = test::problem_for_effects();
  apply_effects({{"permanent-set", 0.05, {}}}, problem);
  EXPECT_THROW(write_toml(problem), Error);
  FemProblem fem = test::fem_problem_for_effects();
  apply_effects({{"gravity", 1.0, {}}}, fem);
  EXPECT_THROW(write_toml(fem), Error);
}

TEST(EffectFileTest, FemFileKeepsItsEffects) {
  FemImpactFile impact{.problem = test::fem_problem_for_effects(),
                       .effects = {{"relaxation", 0.2, {{"relaxation_time", 1e-3}}}}};
  const std::string text = write_toml(impact);
  const Document document = Document::parse(text, "f");
  EXPECT_EQ(write_toml(read_fem_impact(document)), text);
  EXPECT_EQ(read_fem_impact(document).problem, impact.problem);
  EXPECT_EQ(read_fem_problem(document).material.branches.size(), 2u);
}

TEST(EffectFileTest, HelpAndSchemaNameEveryEffectAndItsNumbers) {
  const std::string help = help_text<LumpedImpactFile>();
  const auto schema = json_schema<LumpedImpactFile>("file");
  const auto& properties = schema["properties"]["model"]["properties"];
  const auto& effect = properties["effect"]["items"]["properties"];
  EXPECT_TRUE(properties.contains("plate"));
  for (const Effect& each : all_effects()) {
    EXPECT_NE(help.find("with \"" + each.card.name + "\""), std::string::npos) << each.card.name;
    const auto& names = effect["name"]["enum"];
    EXPECT_NE(std::find(names.begin(), names.end(), each.card.name), names.end());
    for (const EffectParameterCard& parameter : each.card.parameters)
      EXPECT_TRUE(effect.contains(parameter.name)) << parameter.name;
  }
}

}  // namespace
}  // namespace rebound
