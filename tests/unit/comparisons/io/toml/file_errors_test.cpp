#include "comparisons/io/toml/file_errors.hpp"

#include <gtest/gtest.h>

#include "comparisons/io/toml/impact_file.hpp"
#include "comparisons/io/toml/reader.hpp"

namespace rebound {
namespace {

const std::string lumped_text = R"(schema = 1
[impact]
speed = "15 m/s"
[sphere]
mass = "89.6 g"
diameter = "66.2 mm"
[model]
tier = "lumped"
law = "hunt-crossley"
exponent = 1.5
stiffness = "3.5e6 N/m^1.5"
damping = "17.63e4 N.s/m^2.5"
)";

/// "line key: message" of each error, in the order in which they are told.
using Told = std::vector<std::string>;
std::string told(const Error& error) {
  return std::to_string(error.location().line) + " " + error.location().key + ": " + error.what();
}

template <class Read>
Told told_by(const Read& read) {
  Told all;
  try {
    read();
  } catch (const FileErrors& errors) {
    for (const Error& error : errors.errors()) all.push_back(told(error));
    EXPECT_EQ(all.front(), told(errors));
  } catch (const Error& error) {
    all.push_back(told(error));
  }
  return all;
}

Told told_of(const std::string& text) {
  return told_by([&] { read_lumped_problem(Document::parse(text, "f.toml")); });
}

std::string with(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(FileErrorsTest, AllOfAFileComeInTheOrderOfItsLines) {
  const Told all = told_of(R"(schema = 1
[impact]
sped = "15 m/s"
[sphere]
mass = "-89.6 g"
[model]
tier = "lumped"
law = "hunt-crossley"
damping = 12
stiffness = "3.5e6 N/m"
dampng_formula = "exact"
plate = 3
[[model.effect]]
name = "relaxation"
size = -2
relaxation_time = 0.5
colour = "red"
[control]
)");
  std::string lines;
  for (const std::string& one : all) lines += one + "\n";
  EXPECT_EQ(lines, R"(3 impact.sped: this key is not known; did you mean "speed"?
4 sphere.diameter: this key is missing
5 sphere.mass: the value is out of range
9 model.damping: a number with its unit is needed, such as "12 N.s/m^2.5"
10 model.stiffness: "3.5e6 N/m" is in N/m, which is not a multiple of N/m^1.5
11 model.dampng_formula: this key is not known; did you mean "damping_formula"?
12 model.plate: a table [model.plate] is needed here
15 model.effect[0].size: the value is out of range
16 model.effect[0].relaxation_time: a number with its unit is needed, such as "0.5 s"
17 model.effect[0].colour: this key is not known
18 control: this key is not known; did you mean "controls"?
)");
}

TEST(FileErrorsTest, EachHasItsPlaceValueAndRange) {
  const std::string text =
      with(with(lumped_text, "89.6 g", "-1 g"), "hunt-crossley", "hunt-crosley");
  try {
    read_lumped_problem(Document::parse(text, "f.toml"));
    FAIL();
  } catch (const FileErrors& errors) {
    ASSERT_EQ(errors.errors().size(), 2u);
    const ErrorLocation& mass = errors.errors()[0].location();
    EXPECT_EQ(mass.file, "f.toml");
    EXPECT_EQ(mass.line, 5);
    EXPECT_EQ(mass.column, 8);
    EXPECT_EQ(mass.value, "\"-1 g\"");
    EXPECT_EQ(mass.allowed, "value > 0 g");
    EXPECT_EQ(errors.errors()[1].location().line, 9);
    EXPECT_EQ(errors.code(), ExitCode::bad_input);
  }
}

TEST(FileErrorsTest, EveryElementOfAListIsLookedAt) {
  struct Speeds {
    std::vector<double> values;
  } speeds;
  const Document document =
      Document::parse("speeds = [\"5 m/s\", 6,\n\"7 ms\", \"-1 m/s\"]\n", "f.toml");
  const Told all = told_by([&] {
    Reader reader(document);
    reader.visit_numbers({.name = "speeds", .unit = "m/s", .range = above(0.0)}, speeds.values);
    reader.finish();
  });
  ASSERT_EQ(all.size(), 3u);
  EXPECT_TRUE(all[0].starts_with("1 speeds: a number with its unit")) << all[0];
  EXPECT_TRUE(all[1].starts_with("2 speeds: \"7 ms\" is in ms")) << all[1];
  EXPECT_TRUE(all[2].starts_with("2 speeds: the value is out of range")) << all[2];
}

TEST(FileErrorsTest, KeysThatFollowFromARefusedChoiceAreNotJudged) {
  EXPECT_EQ(told_of(with(lumped_text, "hunt-crossley", "hunt-crosley")),
            Told{"9 model.law: this name is not known; did you mean \"hunt-crossley\"?"});
  EXPECT_EQ(told_of(with(lumped_text, "law =", "lwa =")),
            Told{"9 model.lwa: this key is not known; did you mean \"law\"?"});
  EXPECT_EQ(told_of(with(lumped_text, "law = \"hunt-crossley\"\n", "")),
            Told{"7 model.law: this key is missing"});
  EXPECT_EQ(told_of(with(lumped_text, "\"lumped\"", "\"lumpd\"")),
            Told{"8 model.tier: this name is not known; did you mean \"lumped\"?"});
  EXPECT_EQ(told_of(lumped_text + "[[model.effect]]\nname = \"relaxaton\"\nsize = 0.4\n"
                                  "relaxation_time = \"1 ms\"\n"),
            Told{"14 model.effect[0].name: this name is not known; did you mean \"relaxation\"?"});
  EXPECT_EQ(told_of(lumped_text + "[[model.effect]]\nsize = 0.4\n"),
            Told{"13 model.effect[0].name: this key is missing"});
  EXPECT_EQ(told_of(with(lumped_text, "hunt-crossley", "x") + "[[model.at_speed]]\n"
                                                              "damping = \"1 N.s/m^2.5\"\n"
                                                              "speed = \"0 m/s\"\n"),
            (Told{"9 model.law: this name is not known",
                  "15 model.at_speed[0].speed: the value is out of range"}));
}

TEST(FileErrorsTest, AUnitThatFollowsFromARefusedValueIsNotJudged) {
  const std::string other = with(lumped_text, "N/m^1.5", "N/m^2");
  EXPECT_EQ(told_of(with(other, "= 1.5", "= \"2\"")),
            Told{"10 model.exponent: a plain number is needed, without quotes"});
  EXPECT_EQ(told_of(with(other, "= 1.5", "= 1.5")).size(), 1u);  // judged where it is known
}

TEST(FileErrorsTest, NothingIsComputedFromARefusedValue) {
  // The diameter implies an absurd density with any mass: that check waits for a mass.
  EXPECT_EQ(told_of(with(with(lumped_text, "89.6 g", "89.6 s"), "66.2 mm", "66.2 m")),
            Told{"5 sphere.mass: \"89.6 s\" is in s, which is not a multiple of kg"});
  EXPECT_EQ(told_of(with(lumped_text, "66.2 mm", "66.2 m")).size(), 1u);
}

TEST(FileErrorsTest, OneAloneIsAPlainError) {
  try {
    read_lumped_problem(Document::parse(with(lumped_text, "89.6 g", "-1 g"), "f.toml"));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(dynamic_cast<const FileErrors*>(&error), nullptr);
    EXPECT_EQ(told(error), "5 sphere.mass: the value is out of range");
  }
}

}  // namespace
}  // namespace rebound
