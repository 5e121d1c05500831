// Impacts that end without a result: what is written, what is not, and the exit code.
#include <chrono>

#include "tests/cli/program.hpp"

namespace rebound::testing {
namespace {

class IncompleteImpact : public ProgramTest {};

TEST_F(IncompleteImpact, AContactThatDoesNotEndInTimeReportsNoScalar) {
  std::filesystem::create_directories(folder.path() / "results");
  folder.write("results/report.html", "of an earlier run");
  folder.write("a.toml", fem_file + "[controls]\nend_time = \"0.5 ms\"\n");
  const Outcome outcome = rebound({"fem", "a.toml", "--json", "--out", "results"});
  EXPECT_EQ(outcome.exit_code, 3) << outcome.output;
  const auto json = nlohmann::json::parse(outcome.output);
  EXPECT_EQ(json["error"]["code"], 3);
  EXPECT_FALSE(json.contains("restitution"));
  EXPECT_FALSE(there("results/result.json"));
  EXPECT_FALSE(there("results/trace.csv"));
  EXPECT_FALSE(there("results/report.html"));
  ASSERT_TRUE(there("results/incomplete.json"));
  const auto kept = nlohmann::json::parse(read_whole(folder.path() / "results/incomplete.json"));
  EXPECT_FALSE(kept.contains("restitution"));
  EXPECT_TRUE(there("results/trace-incomplete.csv"));
}

TEST_F(IncompleteImpact, TheImplicitSchemeStopsWithWhatIsKnown) {
  const std::string implicit =
      replaced(fem_file, "cells = 60", "scheme = \"implicit\"\ncells = 60");
  // A ball so soft that it hits at nearly its shear wave speed.
  std::string soft =
      replaced(implicit, "youngs_modulus = \"10 MPa\"", "youngs_modulus = \"1.1 MPa\"");
  soft =
      replaced(soft.substr(0, soft.find("[[model.material.branch]]")), "cells = 60", "cells = 100");
  folder.write("soft.toml", replaced(soft, "speed = \"15 m/s\"", "speed = \"25 m/s\""));
  folder.write("long.toml", replaced(implicit, "cells = 60", "cells = 1000"));
  const Outcome turned = rebound({"fem", "soft.toml", "--out", "turned"});
  EXPECT_EQ(turned.exit_code, 3) << turned.errors;
  EXPECT_NE(turned.errors.find("inside out"), std::string::npos) << turned.errors;
  const Outcome stopped =
      rebound({"fem", "long.toml", "--out", "stopped"}, {.interrupt_after_ms = 1500});
  EXPECT_EQ(stopped.exit_code, 130) << stopped.errors;
  for (const std::string name : {"turned", "stopped"}) {
    EXPECT_TRUE(there(name + "/incomplete.json"));
    EXPECT_TRUE(there(name + "/trace-incomplete.csv"));
    EXPECT_FALSE(there(name + "/result.json"));
  }
}

/// An impact at the edge of what a body can stand, near its shear wave speed.
std::string violent(const std::string& material) {
  return "schema = 1\n[impact]\nspeed = \"25 m/s\"\n[sphere]\nmass = \"89.6 g\"\n"
         "diameter = \"66.2 mm\"\n[model]\ntier = \"fem\"\ncells = 100\n[model.material]\n" +
         material;
}

TEST_F(IncompleteImpact, ABodyThatIsTurnedInsideOutReportsNoScalar) {
  const std::string foam =
      "elastic = \"hyperfoam\"\nyoungs_modulus = \"2 MPa\"\n"
      "poisson_ratio = 0.1\n[[model.material.term]]\nweight = 1\n";
  const std::map<std::string, std::string> bodies{
      {"foam", violent(foam + "exponent = -40\n")},
      {"locking",
       violent("elastic = \"neo-hookean\"\nyoungs_modulus = \"1.3 MPa\"\npoisson_ratio = 0.3\n"
               "strain_stiffening = 1000\n")},
      {"plateau",
       violent("elastic = \"neo-hookean\"\nyoungs_modulus = \"4 MPa\"\npoisson_ratio = 0.3\n"
               "strain_softening = 0.95\n")}};
  for (const auto& [name, text] : bodies) {
    folder.write(name + ".toml", text);
    const Outcome outcome = rebound({"fem", name + ".toml", "--json", "--out", name});
    EXPECT_EQ(outcome.exit_code, 3) << name << outcome.output << outcome.errors;
    const auto json = nlohmann::json::parse(outcome.output);
    EXPECT_FALSE(json.contains("restitution")) << name;
    const std::string message = json["error"]["message"];
    EXPECT_NE(message.find("inside out"), std::string::npos) << message;
    EXPECT_EQ(message.find("unstable") != std::string::npos, name == "plateau") << message;
    EXPECT_TRUE(there(name + "/incomplete.json"));
    EXPECT_TRUE(there(name + "/trace-incomplete.csv"));
    EXPECT_FALSE(there(name + "/result.json"));
  }
}

TEST_F(IncompleteImpact, AMaterialThatIsUnstableInTheStrainItReachesIsAWarning) {
  const std::string plateau = violent(
      "elastic = \"neo-hookean\"\nyoungs_modulus = \"40 MPa\"\npoisson_ratio = "
      "0.3\nstrain_softening = 0.9\n");
  const auto warnings_of = [&](const std::string& text) {
    folder.write("a.toml", text);
    const Outcome outcome = rebound({"fem", "a.toml", "--json"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
    return nlohmann::json::parse(outcome.output)["warnings"];
  };
  const auto warned = warnings_of(plateau);
  ASSERT_EQ(warned.size(), 1u);
  EXPECT_NE(warned[0].get<std::string>().find("unstable beyond a strain of"), std::string::npos);
  EXPECT_TRUE(
      warnings_of(replaced(plateau, "strain_softening = 0.9", "strain_softening = 0.5")).empty());
}

TEST_F(IncompleteImpact, AnInterruptedRunKeepsWhatIsKnown) {
  folder.write("a.toml", replaced(fem_file, "cells = 60", "cells = 40000"));
  // The run takes most of a minute. Where the signal comes before the first step there is nothing
  // to keep, so later ones are tried until it meets the steps.
  for (const int after_ms : {1000, 3000, 6000, 12000}) {
    const Outcome outcome =
        rebound({"fem", "a.toml", "--json", "--out", "results"}, {.interrupt_after_ms = after_ms});
    EXPECT_EQ(outcome.exit_code, 130) << outcome.output << outcome.errors;
    EXPECT_EQ(nlohmann::json::parse(outcome.output)["error"]["code"], 130);
    EXPECT_FALSE(there("results/result.json"));
    if (there("results/incomplete.json")) return;
  }
  FAIL() << "no interrupted run kept what was known";
}

TEST_F(IncompleteImpact, ASetUpIsInterruptedWithinASecond) {
  // Uninterrupted, setting up so many cells takes half a minute in which nothing looks.
  folder.write("a.toml", replaced(fem_file, "cells = 60", "cells = 400000"));
  constexpr int after_ms = 2500;
  const auto start = std::chrono::steady_clock::now();
  const Outcome outcome =
      rebound({"fem", "a.toml", "--json", "--out", "results"}, {.interrupt_after_ms = after_ms});
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  EXPECT_EQ(outcome.exit_code, 130) << outcome.errors;
  EXPECT_EQ(nlohmann::json::parse(outcome.output)["error"]["code"], 130);
  EXPECT_LT(took.count(), 1e-3 * after_ms + 2.0);  // a second, and a busy machine's share
  EXPECT_FALSE(there("results/result.json"));
}

}  // namespace
}  // namespace rebound::testing
