#include "comparisons/studies/campaign/each_number.hpp"

#include <gmock/gmock.h>

#include <map>

#include "comparisons/io/toml/describe_fem.hpp"
#include "comparisons/io/toml/describe_lumped.hpp"
#include "comparisons/io/toml/reader.hpp"
#include "comparisons/io/toml/toml_writer.hpp"

namespace rebound {
namespace {

const std::string ball = R"(schema = 1
[impact]
speed = "15 m/s"
[sphere]
mass = "89.6 g"
diameter = "66.2 mm"
)";

const std::string fem_model = R"([model]
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

template <class File>
File file_of(const std::string& text) {
  File file;
  read_document(Document::parse(text, "base.toml"), file);
  return file;
}

template <class File>
void set(File& file, const std::map<std::string, double>& numbers) {
  std::size_t found = 0;
  const EachNumber::Look look = [&](const std::string& path, const Key&, double& value) {
    if (const auto at = numbers.find(path); at != numbers.end()) {
      value = at->second;
      ++found;
    }
  };
  EachNumber visitor(look);
  describe(static_cast<Visitor&>(visitor), file);
  EXPECT_EQ(found, numbers.size());
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

TEST(EachNumberTest, WhatIsSetIsWhatAFileWithThatNumberGives) {
  auto file = file_of<FemImpactFile>(ball + fem_model);
  set(file, {{"impact.speed", 7.0},
             {"model.cells", 119.6},  // whole: the nearest
             {"model.material.branch[0].relaxation_time", 0.5e-3}});
  std::string text = replaced(ball + fem_model, "15 m/s", "7 m/s");
  text = replaced(replaced(text, "cells = 60", "cells = 120"), "0.3 ms", "0.5 ms");
  EXPECT_EQ(write_toml(file), write_toml(file_of<FemImpactFile>(text)));
}

TEST(EachNumberTest, ParametersOfALawAreReachedWithTheirUnits) {
  const std::string law =
      "[model]\ntier = \"lumped\"\nlaw = \"hunt-crossley\"\nstiffness = \"3.5e6 N/m^1.5\"\n"
      "damping = \"17.63e4 N.s/m^2.5\"\n";
  auto file = file_of<LumpedImpactFile>(ball + law);
  std::map<std::string, std::string> units;
  const EachNumber::Look look = [&](const std::string& path, const Key& key, double&) {
    units[path] = key.unit;
  };
  EachNumber visitor(look);
  describe(static_cast<Visitor&>(visitor), file);
  EXPECT_EQ(units.at("model.stiffness"), "N/m^1.5");
  set(file, {{"model.stiffness", 2e6}});
  const std::string text = replaced(ball + law, "3.5e6", "2e6");
  EXPECT_EQ(write_toml(file), write_toml(file_of<LumpedImpactFile>(text)));
}

}  // namespace
}  // namespace rebound
