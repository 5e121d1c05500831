// `export` as a user meets it.
#include <fstream>
#include <sstream>

#include "tests/cli/program.hpp"

namespace rebound::testing {
namespace {

class ExportCommand : public ProgramTest {
 protected:
  void SetUp() override {
    folder.write("elastic.toml", elastic());
    folder.write("relaxing.toml", fem_file);
  }
  static std::string elastic() {
    return replaced(fem_file.substr(0, fem_file.find("[[model.material.branch]]")),
                    "\"neo-hookean\"", "\"neo-hookean-isochoric\"");
  }
  std::string text_of(const std::string& name) const {
    std::ifstream in(folder.path() / name);
    std::stringstream all;
    all << in.rdbuf();
    return all.str();
  }
};

TEST_F(ExportCommand, WritesTheDeckAndSaysWhatIsDifferent) {
  const auto outcome = rebound({"export", "elastic.toml", "--to", "calculix", "--out", "ball.inp"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_NE(outcome.output.find("ball.inp: "), std::string::npos);
  EXPECT_NE(outcome.errors.find("rebound: calculix: contact by a penalty"), std::string::npos);
  const std::string deck = text_of("ball.inp");
  EXPECT_NE(deck.find("** - contact by a penalty"), std::string::npos);
  EXPECT_NE(deck.find("*DYNAMIC"), std::string::npos);
  ASSERT_EQ(rebound({"export", "elastic.toml", "--to", "abaqus", "--out", "made"}).exit_code, 0);
  EXPECT_TRUE(there("made/impact.inp"));
  ASSERT_EQ(rebound({"export", "relaxing.toml", "--to", "febio", "--out", "made"}).exit_code, 0);
  EXPECT_TRUE(there("made/impact.feb"));
}

TEST_F(ExportCommand, TheDeckAloneOnStandardOutput) {
  const auto plain = rebound({"export", "elastic.toml", "--to", "calculix"});
  ASSERT_EQ(plain.exit_code, 0) << plain.errors;
  EXPECT_TRUE(plain.output.starts_with("** Rebound"));
  EXPECT_TRUE(plain.output.ends_with("*END STEP\n"));
  const auto outcome = rebound({"export", "elastic.toml", "--to", "calculix", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  const auto json = nlohmann::json::parse(outcome.output);
  EXPECT_EQ(json["schema"], 1);
  EXPECT_EQ(json["to"], "calculix");
  EXPECT_EQ(json["deck"].get<std::string>(), plain.output);
  EXPECT_GT(json["elements"], 50);
  EXPECT_GT(json["end_time_s"], 2e-3);
  EXPECT_EQ(json["differences"].size(), 2u);
}

TEST_F(ExportCommand, HelpListsTheTargets) {
  const auto outcome = rebound({"export", "--help"});
  EXPECT_EQ(outcome.exit_code, 0);
  for (const char* word :
       {"calculix", "abaqus", "febio", "ls-dyna", "fenicsx", "--to", "youngs_modulus"})
    EXPECT_NE(outcome.output.find(word), std::string::npos) << word;
}

TEST_F(ExportCommand, LostPhysicsIsRefusedWithItsLine) {
  folder.write("mullins.toml",
               replaced(elastic(), "poisson_ratio = 0.4", "poisson_ratio = 0.4\nmullins = 0.3"));
  const std::pair<std::vector<std::string>, const char*> cases[] = {
      {{"export", "mullins.toml", "--to", "febio", "--out", "deck"}, "model.material.mullins"},
      {{"export", "relaxing.toml", "--to", "calculix", "--out", "deck"}, "model.material.branch"}};
  for (auto [arguments, key] : cases) {
    const auto outcome = rebound(arguments);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.errors.find(key), std::string::npos) << outcome.errors;
    EXPECT_NE(outcome.errors.find(".toml:"), std::string::npos) << outcome.errors;
    EXPECT_FALSE(there("deck"));
  }
}

TEST_F(ExportCommand, BadUsage) {
  const auto unknown = rebound({"export", "elastic.toml", "--to", "nastran"});
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_NE(unknown.errors.find("calculix, abaqus, febio, ls-dyna, fenicsx"), std::string::npos)
      << unknown.errors;
  EXPECT_EQ(rebound({"export", "elastic.toml"}).exit_code, 2);
  EXPECT_EQ(rebound({"export", "elastic.toml", "--to", "febio", "--out", "ball.inp"}).exit_code, 2);
  EXPECT_FALSE(there("ball.inp"));
  folder.write("lumped.toml", lumped_file);
  EXPECT_EQ(rebound({"export", "lumped.toml", "--to", "febio"}).exit_code, 2);
  EXPECT_EQ(rebound({"export", "nothing.toml", "--to", "febio"}).exit_code, 4);
}

TEST_F(ExportCommand, APlaceThatCannotBeWritten) {
  folder.write("file", "in the way");
  for (const char* place : {"file/deck.inp", "file/deck"}) {
    const auto outcome = rebound({"export", "elastic.toml", "--to", "calculix", "--out", place});
    EXPECT_EQ(outcome.exit_code, 4) << place;
    EXPECT_NE(outcome.errors.find("file"), std::string::npos) << outcome.errors;
  }
}

}  // namespace
}  // namespace rebound::testing
