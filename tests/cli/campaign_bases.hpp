#pragma once

#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "tests/cli/program.hpp"

namespace rebound::testing {

inline const std::string synthesis = R"(schema = 1
name = "three speeds"
seed = 3
[sphere]
mass = "89.6 g"
diameter = "66.2 mm"
mass_uncertainty = "0.5 g"
[model]
tier = "lumped"
law = "hunt-crossley"
stiffness = "3.2e6 N/m^1.5"
damping = "7e4 N.s/m^2.5"
[[model.effect]]
name = "relaxation"
size = 0.4
relaxation_time = "0.5 ms"
[instrument]
force_noise = "20 N"
force_gain_uncertainty = 0.01
[[shot]]
speed = "5 m/s"
restitution_uncertainty = 0.01
[[shot]]
speed = "15 m/s"
contact_time_uncertainty = "0.01 ms"
[[shot]]
speed = "25 m/s"
)";

inline std::string campaign_of(const std::string& base, const std::string& key,
                               const std::string& values) {
  return "schema = 1\nbase = \"" + base +
         "\"\n[design]\nkind = \"grid\"\n[[design.factor]]\nkey = \"" + key + "\"\nvalues = [" +
         values + "]\n";
}

class CampaignBases : public ProgramTest {
 protected:
  using Row = std::map<std::string, std::string>;

  void SetUp() override {
    folder.write("synthesis.toml", synthesis);
    folder.write("ball.toml", lumped_file);
  }

  nlohmann::json json_of(const std::vector<std::string>& arguments) const {
    const Outcome outcome = rebound(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors << outcome.output;
    return nlohmann::json::parse(outcome.output, nullptr, false);
  }

  /// Runs a campaign; its table by columns.
  std::vector<Row> rows(const std::string& text, const std::string& store) const {
    folder.write("campaign.toml", text);
    json_of({"campaign", "campaign.toml", "--out", store, "--json"});
    std::istringstream csv(rebound({"campaign", "query", "campaign.toml", "--out", store}).output);
    const auto fields = [](const std::string& line) {
      std::vector<std::string> all;
      std::istringstream parts(line + ",");
      for (std::string field; std::getline(parts, field, ',');) all.push_back(field);
      return all;
    };
    std::string line;
    std::getline(csv, line);
    const auto names = fields(line);
    std::vector<Row> table;
    while (std::getline(csv, line)) {
      const auto values = fields(line);
      EXPECT_EQ(values.size(), names.size()) << line;
      Row& row = table.emplace_back();
      for (std::size_t i = 0; i < names.size() && i < values.size(); ++i) row[names[i]] = values[i];
    }
    return table;
  }

  nlohmann::json refusal(const std::string& text) const {
    folder.write("bad.toml", text);
    const Outcome outcome = rebound({"campaign", "bad.toml", "--json", "--out", "bad"});
    EXPECT_EQ(outcome.exit_code, 2) << text;
    EXPECT_FALSE(there("bad"));
    return nlohmann::json::parse(outcome.output)["error"];
  }
};

}  // namespace rebound::testing
