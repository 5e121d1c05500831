// Newton's method that finds no state, through the program: exit 3, no scalar, what was known kept.
#include "tests/cli/program.hpp"

namespace rebound::testing {
namespace {

class NewtonFailure : public ProgramTest {
 protected:
  /// Of stall.toml: exit 3 with the reason, no scalar, and what was known marked as incomplete.
  void expect_no_scalar(const std::string& reason) {
    const Outcome outcome = rebound({"fem", "stall.toml", "--json", "--out", "stall"});
    EXPECT_EQ(outcome.exit_code, 3) << outcome.output << outcome.errors;
    const auto json = nlohmann::json::parse(outcome.output);
    EXPECT_FALSE(json.contains("restitution"));
    EXPECT_FALSE(json.contains("peak_force_N"));
    EXPECT_EQ(json["error"]["code"], 3);
    const std::string message = json["error"]["message"];
    EXPECT_NE(message.find(reason), std::string::npos) << message;
    EXPECT_NE(message.find("what is known is in stall"), std::string::npos) << message;
    EXPECT_TRUE(there("stall/incomplete.json"));
    EXPECT_TRUE(there("stall/trace-incomplete.csv"));
    EXPECT_FALSE(there("stall/result.json"));
    EXPECT_FALSE(there("stall/trace.csv"));
  }
};

/// A foam that stiffens steeply, at its shear wave speed: the search halves its change eight times
/// and every state still turns a cell inside out.
TEST_F(NewtonFailure, OfTheImplicitSchemeReportsNoScalar) {
  folder.write("stall.toml", R"(schema = 1
[impact]
speed = "25 m/s"
[sphere]
mass = "89.6 g"
diameter = "66.2 mm"
[model]
tier = "fem"
scheme = "implicit"
cells = 20
[model.material]
elastic = "hyperfoam"
youngs_modulus = "2 MPa"
poisson_ratio = 0.1
[[model.material.term]]
weight = 1
exponent = 12
)");
  expect_no_scalar("inside out");
}

/// A plate of a milligram on a spring that hardly holds it: 60 iterations find no equilibrium of
/// ball and plate, nor do they in steps cut in half six times. At 2 MPa the path to that end is
/// chaotic: rounding decides whether a cell is turned inside out first.
TEST_F(NewtonFailure, OfAPlateThatHasNoWeightReportsNoScalar) {
  folder.write("stall.toml", R"(schema = 1
[impact]
speed = "20 m/s"
[sphere]
mass = "89.6 g"
diameter = "66.2 mm"
[model]
tier = "fem"
scheme = "implicit"
cells = 20
[model.material]
elastic = "neo-hookean"
youngs_modulus = "50 MPa"
poisson_ratio = 0.4
[model.plate]
stiffness = "1e-6 MN/m"
mass = "1e-6 kg"
damping_ratio = 0
)");
  expect_no_scalar("Newton's method did not converge");
}

}  // namespace
}  // namespace rebound::testing
