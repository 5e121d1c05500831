#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/support/run_program.hpp"
#include "tests/support/temporary_folder.hpp"

namespace rebound::testing {

inline const std::string lumped_file = R"(schema = 1
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

inline const std::string fem_file = R"(schema = 1
[impact]
speed = "15 m/s"
[sphere]
mass = "89.6 g"
diameter = "66.2 mm"
[model]
tier = "fem"
cells = 60
[model.material]
elastic = "neo-hookean"
youngs_modulus = "10 MPa"
poisson_ratio = 0.4
[[model.material.branch]]
ratio = 0.3
relaxation_time = "0.3 ms"
)";

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  if (at == std::string::npos) throw std::runtime_error("nothing to replace: " + from);
  return text.replace(at, from.size(), to);
}

/// One test's folder, and the program run in it.
class ProgramTest : public ::testing::Test {
 protected:
  Outcome rebound(std::vector<std::string> arguments) const {
    return rebound(std::move(arguments), {});
  }
  Outcome rebound(std::vector<std::string> arguments, Invocation run) const {
    arguments.insert(arguments.begin(), REBOUND_PROGRAM);
    run.arguments = std::move(arguments);
    run.folder = folder.path();
    return run_program(run);
  }
  bool there(const std::string& name) const {
    return std::filesystem::exists(folder.path() / name);
  }

  TemporaryFolder folder;
};

}  // namespace rebound::testing
