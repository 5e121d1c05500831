#include "tests/cli/program.hpp"

namespace rebound::testing {
namespace {

struct BadFile {
  const char* name;
  const char* command;
  std::string text;
  int exit_code;
  int line;           ///< 0: not asked for
  const char* key;    ///< empty: not asked for
  const char* value;  ///< a part of it
  const char* allowed;
};

std::string lumped(const std::string& from, const std::string& to) {
  return replaced(lumped_file, from, to);
}
std::string fem(const std::string& from, const std::string& to) {
  return replaced(fem_file, from, to);
}

class BadInputTest : public ProgramTest, public ::testing::WithParamInterface<BadFile> {};

/// The message names file, line, key, value and range, and nothing is left behind.
TEST_P(BadInputTest, IsRefusedWithItsPlaceAndRange) {
  const BadFile& c = GetParam();
  folder.write("bad.toml", c.text);
  const Outcome outcome = rebound({c.command, "bad.toml", "--out", "results"});
  EXPECT_EQ(outcome.exit_code, c.exit_code) << outcome.errors;
  EXPECT_EQ(outcome.output, "");
  const std::string place = c.line > 0 ? "bad.toml:" + std::to_string(c.line) + ":" : "bad.toml";
  for (const std::string& part :
       {place, std::string(c.key), std::string(c.value), std::string(c.allowed)})
    EXPECT_NE(outcome.errors.find(part), std::string::npos) << part << "\n" << outcome.errors;
  EXPECT_FALSE(there("results/trace.csv"));
  EXPECT_FALSE(there("results/result.json"));
}

/// The same as one JSON object on standard output.
TEST_P(BadInputTest, IsOneJsonObjectWhenAskedFor) {
  const BadFile& c = GetParam();
  folder.write("bad.toml", c.text);
  const Outcome outcome = rebound({c.command, "bad.toml", "--json"});
  EXPECT_EQ(outcome.exit_code, c.exit_code);
  const auto json = nlohmann::json::parse(outcome.output);
  EXPECT_EQ(json["schema"], 1);
  const auto& error = json["error"];
  EXPECT_EQ(error["code"], c.exit_code);
  EXPECT_FALSE(error["message"].get<std::string>().empty());
  EXPECT_EQ(error["file"], "bad.toml");
  if (c.line > 0) {
    EXPECT_EQ(error["line"], c.line);
  }
  if (*c.key) {
    EXPECT_EQ(error["key"], c.key);
  }
  for (const char* name : {"line", "key", "value", "allowed"}) EXPECT_TRUE(error.contains(name));
}

INSTANTIATE_TEST_SUITE_P(
    Lumped, BadInputTest,
    ::testing::Values(BadFile{"NegativeMass", "lumped", lumped("89.6 g", "-89.6 g"), 2, 5,
                              "sphere.mass", "\"-89.6 g\"", "value > 0 g"},
                      BadFile{"ZeroSpeed", "lumped", lumped("15 m/s", "0 m/s"), 2, 3,
                              "impact.speed", "\"0 m/s\"", "0 < value <= 1000 m/s"},
                      BadFile{"UnitSlip", "lumped", lumped("66.2 mm", "33.1 m"), 2, 6,
                              "sphere.diameter", "\"33.1 m\"", "50 to 20000 kg/m^3"},
                      BadFile{"SpeedInTheWrongUnit", "lumped", lumped("15 m/s", "900 m/s"), 2, 3,
                              "impact.speed", "\"900 m/s\"", "0.6 radii"},
                      BadFile{"BareNumber", "lumped", lumped("\"15 m/s\"", "15"), 2, 3,
                              "impact.speed", "15", "1000 m/s"},
                      BadFile{"NaN", "lumped", lumped("\"15 m/s\"", "nan"), 2, 3, "impact.speed",
                              "nan", "1000 m/s"},
                      BadFile{"Infinite", "lumped", lumped("15 m/s", "inf m/s"), 2, 3,
                              "impact.speed", "inf", "1000 m/s"},
                      BadFile{"TooLarge", "lumped", lumped("15 m/s", "1e308 m/s"), 2, 3,
                              "impact.speed", "1e308", "1000 m/s"},
                      BadFile{"DecimalComma", "lumped", lumped("15 m/s", "1,5 m/s"), 2, 3,
                              "impact.speed", "1,5", "1000 m/s"},
                      BadFile{"UnquotedComma", "lumped", lumped("\"15 m/s\"", "1,5"), 2, 3,
                              "impact.speed", "1,5", ""},
                      BadFile{"WrongDimension", "lumped", lumped("N/m^1.5", "N/m"), 2, 10,
                              "model.stiffness", "N/m\"", "N/m^1.5"},
                      BadFile{"UnknownKey", "lumped", lumped("mass =", "masss ="), 2, 5,
                              "sphere.masss", "89.6 g", "mass | diameter"},
                      BadFile{"UnknownLaw", "lumped", lumped("hunt-crossley", "hunt-crosley"), 2, 9,
                              "model.law", "hunt-crosley", "linear-kelvin-voigt"},
                      BadFile{"DuplicateKey", "lumped",
                              lumped("[model]", "mass = \"1 g\"\n[model]"), 2, 7, "sphere.mass",
                              "1 g", ""},
                      BadFile{"MissingKey", "lumped", lumped("mass = \"89.6 g\"\n", ""), 2, 4,
                              "sphere.mass", "", "value > 0 g"},
                      BadFile{"Truncated", "lumped",
                              lumped_file.substr(0, lumped_file.find("crossley")), 2, 9,
                              "model.law", "hunt-", ""},
                      BadFile{"NotToml", "lumped", "{\"speed\": 15}\n", 2, 1, "", "speed", ""},
                      BadFile{"Binary", "lumped",
                              std::string("\x7f"
                                          "ELF\x02\x01\x01\0\0",
                                          9),
                              2, 1, "", "", ""},
                      BadFile{"Empty", "lumped", "", 2, 0, "schema", "", ""},
                      BadFile{"AnotherVersion", "lumped", lumped("schema = 1", "schema = 2"), 2, 1,
                              "schema", "2", "1"}),
    [](const auto& instance) { return std::string(instance.param.name); });

INSTANTIATE_TEST_SUITE_P(
    Fem, BadInputTest,
    ::testing::Values(BadFile{"PoissonRatio", "fem", fem("= 0.4", "= 0.5"), 2, 13,
                              "model.material.poisson_ratio", "0.5", "-1 < value <= 0.499"},
                      BadFile{"Incompressible", "fem", fem("= 0.4", "= 0.4995"), 2, 13,
                              "model.material.poisson_ratio", "0.4995", "0.499"},
                      BadFile{"IncompressibleOnceRelaxed", "fem",
                              fem("ratio = 0.3", "ratio = 0.995\nrelaxes = \"deviator\""), 2, 13,
                              "model.material.poisson_ratio", "0.4", "before and after relaxing"},
                      BadFile{"RelaxationTime", "fem", fem("0.3 ms", "0 ms"), 2, 16,
                              "model.material.branch[0].relaxation_time", "\"0 ms\"",
                              "value > 0 ms"},
                      BadFile{"Shares", "fem", fem("ratio = 0.3", "ratio = 1.0"), 2, 15,
                              "model.material.branch[0].ratio", "1.0", "below 1"},
                      BadFile{"Modulus", "fem", fem("10 MPa", "10 Pa"), 2, 3, "impact.speed",
                              "15 m/s", "shear wave speed"},
                      BadFile{"Plate", "fem", fem_file + "[model.plate]\nfriction = -0.3\n", 2, 18,
                              "model.plate.friction", "-0.3", ""}),
    [](const auto& instance) { return std::string(instance.param.name); });

class SeveralErrorsTest : public ProgramTest {};

TEST_F(SeveralErrorsTest, OfOneFileArePrintedTogetherInTheOrderOfItsLines) {
  folder.write("bad.toml", replaced(lumped("89.6 g", "-1 g"), "speed =", "sped ="));
  const Outcome outcome = rebound({"lumped", "bad.toml", "--out", "results"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.output, "");
  EXPECT_EQ(outcome.errors,
            "rebound: bad.toml:3:1: impact.sped = \"15 m/s\": this key is not known; did you mean "
            "\"speed\"?\n"
            "         allowed: speed | separation\n"
            "rebound: bad.toml:5:8: sphere.mass = \"-1 g\": the value is out of range\n"
            "         allowed: value > 0 g\n"
            "rebound: 2 errors in bad.toml\n");
  EXPECT_FALSE(there("results"));
}

TEST_F(SeveralErrorsTest, StandInOneJsonObjectTheFirstWhereOneIsExpected) {
  folder.write("bad.toml", replaced(lumped("89.6 g", "-1 g"), "speed =", "sped ="));
  const auto json = nlohmann::json::parse(rebound({"lumped", "bad.toml", "--json"}).output);
  ASSERT_EQ(json["errors"].size(), 2u);
  EXPECT_EQ(json["errors"][0], json["error"]);
  EXPECT_EQ(json["errors"][1]["key"], "sphere.mass");
  EXPECT_EQ(json["errors"][1]["line"], 5);
}

class NoSuchFileTest : public ProgramTest {};

TEST_F(NoSuchFileTest, IsAReadingFailureThatNamesTheFile) {
  for (const char* command : {"lumped", "fem"})
    for (const char* file : {"none.toml", "."}) {
      const Outcome outcome = rebound({command, file});
      EXPECT_EQ(outcome.exit_code, 4) << outcome.errors;
      EXPECT_NE(outcome.errors.find(file), std::string::npos) << outcome.errors;
    }
}

TEST_F(NoSuchFileTest, TheOneThatWasMeantIsNamed) {
  folder.write("ball.toml", lumped_file);
  EXPECT_NE(rebound({"lumped", "bal.toml"}).errors.find("did you mean ball.toml?"),
            std::string::npos);
  EXPECT_EQ(rebound({"lumped", "xyzzy.txt"}).errors.find("did you mean"), std::string::npos);
}

TEST_F(NoSuchFileTest, WhereADataSetIsAskedForSaysHowToMakeOne) {
  folder.write("ball.toml", lumped_file);
  for (const char* what : {"ball.toml", "nowhere", "."}) {
    const Outcome outcome = rebound({"inspect", what});
    EXPECT_EQ(outcome.exit_code, 4) << what;
    EXPECT_NE(outcome.errors.find("rebound init dataset --from FILE"), std::string::npos) << what;
  }
}

class RefusedWithAnOption : public ProgramTest {};

TEST_F(RefusedWithAnOption, NothingIsLeftBesideTheError) {
  folder.write("ball.toml", lumped_file + "[[model.effect]]\nname = \"relaxation\"\nsize = 0.1\n");
  const Outcome outcome = rebound({"lumped", "ball.toml", "--sensitivities", "--out", "results"});
  EXPECT_EQ(outcome.exit_code, 2) << outcome.errors;
  EXPECT_FALSE(there("results/result.json"));
  EXPECT_FALSE(there("results/trace.csv"));
}

TEST_F(RefusedWithAnOption, ItsNameValueAndRangeAreSaid) {
  folder.write("ball.toml", lumped_file);
  const std::string confidence = rebound({"drop", "ball.toml", "--confidence", "2"}).errors;
  EXPECT_NE(confidence.find("--confidence = 2: out of range"), std::string::npos) << confidence;
  EXPECT_NE(confidence.find("between 0 and 1"), std::string::npos) << confidence;
  EXPECT_NE(rebound({"lumped"}).errors.find("`rebound lumped --help`"), std::string::npos);
  EXPECT_NE(rebound({"help"}).errors.find("there is no such command"), std::string::npos);
}

}  // namespace
}  // namespace rebound::testing
