#pragma once

#include <string>

#include "tests/cli/program.hpp"

namespace rebound::testing {

inline const std::string believed_lumped = R"(schema = 1
[model]
tier = "lumped"
law = "hunt-crossley"
stiffness = "3e6 N/m^1.5"
damping = "50000 N.s/m^2.5"
)";

/// An experiment made by `synthesize`, and what `diagnose` says of it beside a believed model.
class DiagnosedExperiment : public ProgramTest {
 protected:
  nlohmann::json diagnosis_of(const std::string& experiment, const std::string& believed) {
    folder.write("experiment.toml", experiment);
    folder.write("believed.toml", believed);
    EXPECT_EQ(rebound({"synthesize", "experiment.toml", "--out", "x"}).exit_code, 0);
    const Outcome outcome =
        rebound({"diagnose", "x/data", "--model", "believed.toml", "--out", "diagnosis", "--json"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
    return nlohmann::json::parse(outcome.output);
  }
};

}  // namespace rebound::testing
