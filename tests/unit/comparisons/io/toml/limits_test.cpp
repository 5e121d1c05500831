#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "comparisons/io/toml/describe_compression.hpp"
#include "comparisons/io/toml/describe_fem.hpp"
#include "comparisons/io/toml/describe_lumped.hpp"
#include "comparisons/io/toml/impact_file.hpp"
#include "comparisons/io/toml/key_text.hpp"
#include "comparisons/io/toml/toml_writer.hpp"
#include "comparisons/io/toml/units.hpp"
#include "fem/interface/check_problem.hpp"
#include "fem/interface/elastic_models.hpp"
#include "lumped/integration/simulate.hpp"
#include "lumped/laws/laws.hpp"
#include "tests/support/effect_cases.hpp"
#include "tests/support/refusals.hpp"
#include "tests/unit/comparisons/io/toml/number_walker.hpp"

/// For every number that an impact or a compression file can hold: a value just outside its
/// range is refused by the reader, with its place, and by the solver, with the same key and
/// the same words. The keys are those that `describe` declares, so a new one is among them.
namespace rebound {
namespace {

using testing::refusal_of;

std::string line_of(const std::string& text, int number) {
  std::istringstream stream(text);
  std::string line;
  for (int i = 0; i < number; ++i) std::getline(stream, line);
  return line;
}

struct Tally {
  std::string under{};              ///< only keys that begin so
  std::vector<std::string> keys{};  ///< without the places in lists
  int refusals = 0;
};

template <class Record, class Read, class Solve>
void expect_the_same_limits(const Record& record, const Read& read, const Solve& solve,
                            Tally& tally) {
  ASSERT_NO_THROW(read(Document::parse(write_toml(record), "f.toml"))) << write_toml(record);
  for (const NumberWalker::Number& number : numbers_of(record)) {
    if (!number.path.starts_with(tally.under)) continue;
    const std::vector<double> outside = values_outside(number);
    EXPECT_FALSE(outside.empty()) << number.path << " has no range";
    std::string plain = number.path;
    plain.erase(
        std::remove_if(plain.begin(), plain.end(), [](char c) { return c >= '0' && c <= '9'; }),
        plain.end());
    tally.keys.push_back(plain);
    for (const double value : outside) {
      SCOPED_TRACE(number.path + " = " + format_number(value));
      Record changed = record;
      NumberWalker put(number.path, value);
      describe(static_cast<Visitor&>(put), changed);
      const auto now = numbers_of(changed);
      const auto same = [&](const auto& other) {
        return other.path == number.path && other.value == value;
      };
      // The record's own sign for "not given", at an open limit.
      if (std::none_of(now.begin(), now.end(), same)) continue;
      const std::string text = write_toml(changed);
      const Error reading = refusal_of([&] { read(Document::parse(text, "f.toml")); });
      const Error solving = refusal_of([&] { solve(changed); });
      EXPECT_EQ(reading.code(), ExitCode::bad_input);
      EXPECT_EQ(reading.location().file, "f.toml");
      EXPECT_NE(line_of(text, reading.location().line).find(number.key.name), std::string::npos);
      EXPECT_NE(reading.location().value, "");
      EXPECT_EQ(reading.location().key, number.path);
      EXPECT_EQ(reading.location().allowed, allowed_text(number.key));
      EXPECT_EQ(solving.code(), ExitCode::bad_input);
      EXPECT_EQ(solving.location().key, number.path);
      EXPECT_EQ(solving.location().allowed, allowed_text(number.key));
      EXPECT_NE(solving.location().value, "");
      EXPECT_STREQ(solving.what(), reading.what());
      ++tally.refusals;
    }
  }
}

void expect_the_same_lumped_limits(const LumpedImpactFile& file, Tally& tally) {
  expect_the_same_limits(
      file, [](const Document& document) { read_lumped_impact(document); },
      [](const LumpedImpactFile& changed) {
        LumpedProblem problem = changed.problem;
        apply_effects(changed.effects, problem);
        simulate(problem);
      },
      tally);
}

void expect_the_same_fem_limits(const FemImpactFile& file, Tally& tally) {
  expect_the_same_limits(
      file, [](const Document& document) { read_fem_impact(document); },
      [](const FemImpactFile& changed) {
        FemProblem problem = changed.problem;
        apply_effects(changed.effects, problem);
        check(problem);
      },
      tally);
}

const Plate compliant{.stiffness = 5e7, .mass = 2.0, .damping_ratio = 0.02};

TEST(LimitsTest, EveryLumpedLaw) {
  Tally tally;
  for (const LawCard& law : all_laws()) {
    SCOPED_TRACE(law.name);
    LumpedImpactFile file{.problem = test::typical_problem(law.name), .effects = {}};
    file.problem.model.at_speed = {{.speed = 5.0, .parameters = file.problem.model.parameters}};
    file.problem.model.mechanisms.plate = compliant;
    expect_the_same_lumped_limits(file, tally);
  }
  expect_the_same_lumped_limits({.problem = test::problem_for_effects(), .effects = {}}, tally);
  EXPECT_GT(tally.refusals, 150);
}

TEST(LimitsTest, EveryEffect) {
  Tally tally{.under = "model.effect"};  // an effect may replace a number of its problem
  for (const Effect& effect : all_effects()) {
    SCOPED_TRACE(effect.card.name);
    EffectChoice choice = test::slight(effect);
    for (const auto& parameter : effect.card.parameters)
      choice.parameters[parameter.name] = parameter.default_value;
    if (effect.to_lumped)
      expect_the_same_lumped_limits({.problem = test::problem_for_effects(), .effects = {choice}},
                                    tally);
    if (effect.to_fem)
      expect_the_same_fem_limits({.problem = test::fem_problem_for_effects(), .effects = {choice}},
                                 tally);
  }
  EXPECT_GT(tally.refusals, 60);
}

/// A problem with every member that a file can hold, but for one elastic law's own.
FemProblem full_fem_problem() {
  FemProblem problem = test::fem_problem_for_effects();
  problem.material.branches = {
      {.ratio = 0.2, .relaxation_time = 1e-3},
      {.ratio = 0.1, .relaxation_time = 1e-4, .rate_exponent = 0.5, .reference_strain = 0.05}};
  problem.material.retardation_time = 1e-6;
  problem.material.strain = {
      .stiffening = 0.1, .softening = 0.2, .densification = 0.3, .mullins = 0.4};
  problem.material.layers = {{.from = 0.5, .modulus_factor = 2.0},
                             {.from = 0.8, .modulus_factor = 3.0}};
  problem.plate = compliant;
  problem.plate.friction = 0.3;
  problem.adhesion = {.work = 5.0, .range = 1e-3};
  problem.controls.output_interval = 1e-5;
  problem.controls.end_time = 0.01;
  return problem;
}

std::vector<Material> elastic_laws(const Material& other) {
  std::vector<Material> all(3, other);
  all[0].elastic = ElasticModel::mooney_rivlin;
  all[0].second_share = 0.25;
  all[1].elastic = ElasticModel::ogden;
  all[1].terms = {{.weight = 3.0, .exponent = 4.0}, {.weight = 1.0, .exponent = -2.0}};
  all[2].elastic = ElasticModel::hyperfoam;
  all[2].terms = {{.weight = 3.0, .exponent = 4.0, .beta = 2.0},
                  {.weight = 1.0, .exponent = -2.0, .beta = 2.0}};
  return all;
}

TEST(LimitsTest, EveryFemMaterial) {
  Tally tally;
  FemProblem problem = full_fem_problem();
  for (const Material& material : elastic_laws(problem.material)) {
    problem.material = material;
    expect_the_same_fem_limits({.problem = problem, .effects = {}}, tally);
  }
  EXPECT_GT(tally.refusals, 100);
  for (const char* key :
       {"sphere.mass", "impact.speed", "controls.field_frames", "model.cells",
        "model.plate.friction", "model.plate.mass", "model.adhesion.range",
        "model.material.poisson_ratio", "model.material.second_share",
        "model.material.branch[].ratio", "model.material.branch[].reference_strain",
        "model.material.layer[].from", "model.material.term[].beta", "model.material.mullins"})
    EXPECT_NE(std::find(tally.keys.begin(), tally.keys.end(), key), tally.keys.end()) << key;
}

TEST(LimitsTest, EveryCompression) {
  Tally tally;
  CompressionProblem problem;
  problem.sphere = test::core_a();
  problem.compression = {.deflection = 5e-3, .path = CompressionPath::triangle, .duration = 4e-3};
  problem.material = test::fem_problem_for_effects().material;
  for (const Material& material : elastic_laws(problem.material)) {
    problem.material = material;
    expect_the_same_limits(
        problem, [](const Document& document) { read_compression(document); },
        [](const CompressionProblem& changed) { check(changed); }, tally);
  }
  EXPECT_GT(tally.refusals, 40);
}

/// The printed unit and the SI number of a limit agree: a limit that is not zero is in SI.
TEST(LimitsTest, FiniteLimitsStandInTheirPrintedUnit) {
  const auto each = [](const auto& numbers) {
    for (const auto& number : numbers)
      for (const double limit : {number.key.range.lowest, number.key.range.highest})
        if (std::isfinite(limit) && limit != 0.0) {
          EXPECT_EQ(parse_unit(number.key.unit).factor(), 1.0) << number.path;
        }
  };
  each(numbers_of(FemImpactFile{.problem = full_fem_problem(), .effects = {}}));
  each(numbers_of(LumpedImpactFile{.problem = test::problem_for_effects(), .effects = {}}));
}

}  // namespace
}  // namespace rebound
