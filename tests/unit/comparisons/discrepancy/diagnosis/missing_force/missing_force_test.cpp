#include "comparisons/discrepancy/diagnosis/missing_force/missing_force.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <ostream>

#include "comparisons/discrepancy/diagnosis/missing_force/missing_force_pictures.hpp"
#include "comparisons/discrepancy/diagnosis/output/diagnosis_json.hpp"
#include "comparisons/discrepancy/diagnosis/output/diagnosis_text.hpp"
#include "tests/unit/comparisons/discrepancy/diagnosis/hidden_cases.hpp"
#include "tests/unit/comparisons/discrepancy/diagnosis/missing_force/added_force_cases.hpp"

namespace rebound {

namespace testing {

/// Names the force where GoogleTest prints the parameter of a test.
void PrintTo(const AddedForce* added, std::ostream* out) {
  *out << added->name;
}

}  // namespace testing

namespace {

using testing::AddedForce;
using testing::Experiment;
using testing::TrueImpact;

constexpr int seeds = 4;
constexpr double unseen_speed = 12.0;
const std::vector<double> fitted_speeds{5.0, 9.0, 16.0, 25.0};

/// One synthetic experiment, and what was found in it.
struct Found {
  std::vector<TrueImpact> impacts;
  Observations seen, unseen;
  HypothesisFit fit;
  MissingForce missing;
};

LumpedModel believed_law() {
  LumpedModel model;
  model.parameters = {{"exponent", 1.5}, {"stiffness", 3.5e6}, {"damping", 8e4}};
  return model;
}

std::unique_ptr<Found> found_in(const AddedForce& added, int seed) {
  auto found = std::make_unique<Found>();
  for (const double speed : fitted_speeds)
    found->impacts.push_back(testing::true_impact({}, added, speed));
  auto all = found->impacts;
  all.push_back(testing::true_impact({}, added, unseen_speed));
  const Observations both = testing::observed(all, {}, static_cast<std::uint64_t>(seed));
  std::vector<bool> fitted(all.size(), true);
  fitted.back() = false;
  found->seen = subset(both, fitted);
  fitted.flip();
  found->unseen = subset(both, fitted);
  found->fit = fit_hypothesis(found->seen, {.believed = believed_law()});
  found->missing = find_missing_force(found->seen, found->fit, &found->unseen);
  return found;
}

/// What is truly missing at one speed: as the record is read with the numbers that were found.
testing::TrueMissing truth_of(const Found& found, std::size_t shot, int seed) {
  std::map<std::string, double> value;
  for (std::size_t i = 0; i < found.missing.values.size(); ++i)
    value[found.fit.model->unknowns()[i].name] = found.missing.values[i];
  const LumpedModel law = found.fit.model->believed_at(found.missing.values, 0);
  const MeasuredImpact& measured = found.seen.shots[shot];
  const double start = testing::start_of_contact(found.impacts[shot], {}) -
                       found.fit.model->first_touch(found.missing.values, shot);
  return {found.impacts[shot],
          {.stiffness = law.parameters.at("stiffness"), .damping = law.parameters.at("damping")},
          testing::true_gain({}, static_cast<std::uint64_t>(seed)),
          {.gain = value.at("force gain"),
           .baseline = value.at("force baseline"),
           .speed = measured.impact.speed / (1.0 + value.at("speed error, " + measured.label)),
           .late = start}};
}

/// Share of the points at which the band holds the truth, over all speeds.
double coverage_of(const Found& found, int seed) {
  int covered = 0, points = 0;
  for (std::size_t k = 0; k < found.missing.curves.size(); ++k) {
    const MissingForceCurve& curve = found.missing.curves[k];
    const testing::TrueMissing truth = truth_of(found, k, seed);
    for (std::size_t i = 0; i < curve.force.size(); ++i, ++points) {
      const double true_force = truth.at(curve.deflection[i], curve.velocity[i] > 0.0);
      covered += true_force >= curve.low[i] && true_force <= curve.high[i] ? 1 : 0;
    }
  }
  return static_cast<double>(covered) / points;
}

class MissingForceTest : public ::testing::TestWithParam<const AddedForce*> {};

TEST_P(MissingForceTest, BandCoversAndPredictsTheUnseenSpeed) {
  const AddedForce& added = *GetParam();
  double coverage = 0.0, after = 0.0;
  int within = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    const auto found = found_in(added, seed);
    const MissingForce& missing = found->missing;
    ASSERT_TRUE(missing.found()) << missing.not_found_because;
    ASSERT_EQ(missing.curves.size(), fitted_speeds.size());
    const double one = coverage_of(*found, seed);
    coverage += one / seeds;
    after += *missing.unseen_after / seeds;
    within += *missing.unseen_after > 0.8 && *missing.unseen_after < 1.25 ? 1 : 0;
    std::string words;
    for (const std::string& word : missing.in_words) words += "; " + word;
    fmt::print("{} seed {}: covered {:.3f}, unseen {:.2f} -> {:.2f}{}\n", added.name, seed, one,
               *missing.unseen_before, *missing.unseen_after, words);
  }
  fmt::print("{}: covered {:.3f}, unseen {:.2f}, within in {} of {}\n", added.name, coverage, after,
             within, seeds);
  EXPECT_GE(coverage, 0.90);
  EXPECT_GT(after, 0.8);
  EXPECT_LT(after, 1.25);
  EXPECT_GE(within, seeds - 1);  // of all forces and seeds together 19 in 20
}

INSTANTIATE_TEST_SUITE_P(Forces, MissingForceTest,
                         ::testing::Values(&testing::nothing, &testing::friction, &testing::cubic,
                                           &testing::maxwell, &testing::loading_only),
                         [](const auto& one) { return one.param->name; });

TEST(MissingForceRecordTest, SaysWhyItWasNotFound) {
  const std::vector<TrueImpact> impacts{testing::true_impact({}, testing::nothing, 9.0)};
  const Observations seen = testing::observed(impacts, {}, 1);
  LumpedModel believed = believed_law();
  believed.mechanisms.mode = {.mass_fraction = 0.1, .frequency = 3e3, .damping_ratio = 0.1};
  const HypothesisFit fit = fit_hypothesis(seen, {.believed = believed});
  const MissingForce missing = find_missing_force(seen, fit);
  EXPECT_EQ(missing.not_found_because, "the ball of the believed model has an inner mass");
  EXPECT_TRUE(missing.curves.empty());
}

TEST(MissingForceRecordTest, IsPartOfADiagnosis) {
  const Diagnosis d =
      testing::diagnose_hidden(testing::experiment_with({{"hysteresis", 0.3, {}}}, 5));
  ASSERT_TRUE(d.missing_force && d.missing_force->found());
  const Json json = to_json(d);
  const Json& missing = json.at("missing_force");
  ASSERT_EQ(missing.at("curves").size(), 2U);  // of three speeds one is left out
  const Json& curve = missing.at("curves").at(0);
  for (const char* key : {"velocity_m_s", "force_N", "low_N", "high_N"})
    EXPECT_EQ(curve.at(key).size(), curve.at("deflection_m").size()) << key;
  EXPECT_LT(missing.at("held_out_with").get<double>(),
            missing.at("held_out_without").get<double>());
  EXPECT_NE(to_text(d).find("missing force"), std::string::npos);
  const auto figures = missing_force_figures(*d.missing_force);
  ASSERT_EQ(figures.size(), 3U);
  for (const auto& figure : figures) {
    ASSERT_EQ(figure.series.size(), 2U);
    for (const auto& series : figure.series) EXPECT_EQ(series.y_low.size(), series.x.size());
  }
}

}  // namespace
}  // namespace rebound
