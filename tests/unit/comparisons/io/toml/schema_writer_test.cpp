#include "comparisons/io/toml/schema_writer.hpp"

#include <gtest/gtest.h>

#include "comparisons/io/toml/describe_fem.hpp"
#include "comparisons/io/toml/describe_lumped.hpp"
#include "comparisons/io/toml/help_writer.hpp"
#include "lumped/laws/laws.hpp"

namespace rebound {
namespace {

TEST(SchemaWriterTest, NestsTablesAndLists) {
  const auto schema = json_schema<FemProblem>("fem");
  const auto& material = schema["properties"]["model"]["properties"]["material"];
  EXPECT_EQ(material["properties"]["poisson_ratio"]["maximum"], 0.499);
  EXPECT_EQ(material["properties"]["youngs_modulus"]["x-unit"], "MPa");
  const auto& branch = material["properties"]["branch"];
  EXPECT_EQ(branch["type"], "array");
  EXPECT_EQ(branch["items"]["required"], (std::vector<std::string>{"ratio", "relaxation_time"}));
  EXPECT_EQ(branch["items"]["additionalProperties"], false);
}

TEST(SchemaWriterTest, HoldsTheParametersOfEveryLaw) {
  const auto schema = json_schema<LumpedProblem>("lumped");
  const auto& model = schema["properties"]["model"];
  const auto& at_speed = model["properties"]["at_speed"]["items"];
  for (const LawCard& law : all_laws())
    for (const ParameterCard& card : law.parameters) {
      EXPECT_TRUE(model["properties"].contains(card.name)) << law.name << " " << card.name;
      EXPECT_TRUE(at_speed["properties"].contains(card.name)) << law.name << " " << card.name;
    }
  // What only some laws need is required of none.
  EXPECT_EQ(model["required"], (std::vector<std::string>{"tier", "law"}));
}

TEST(HelpWriterTest, NamesEveryKeyWithItsUnitRangeAndSentence) {
  const std::string text = help_text<FemProblem>();
  EXPECT_NE(text.find("model.material.branch.relaxation_time  [value > 0 ms; required]"),
            std::string::npos);
  EXPECT_NE(text.find("Time constant of the branch."), std::string::npos);
  EXPECT_NE(text.find("controls.step_safety  [0 < value <= 1; default 0.9]"), std::string::npos);
}

}  // namespace
}  // namespace rebound
