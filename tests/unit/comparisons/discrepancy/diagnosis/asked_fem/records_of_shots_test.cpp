#include "comparisons/discrepancy/diagnosis/asked_fem/records_of_shots.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "comparisons/discrepancy/diagnosis/asked_fem/mesh_errors.hpp"

namespace rebound {
namespace {

constexpr double push_time = 1e-3, push = 1000.0;

/// Half a sine, read at 50 kHz with 10 N of white noise.
MeasuredImpact half_sine_push() {
  MeasuredImpact shot;
  shot.label = "10 m/s";
  shot.impact.speed = 10.0;
  for (int i = 0; i <= 50; ++i) {
    shot.trace.time.push_back(i * 2e-5);
    shot.trace.force.push_back(push * std::sin(std::numbers::pi * i / 50.0));
  }
  shot.noise.deviation = 10.0;
  return shot;
}

ModelledImpact modelled_push(const MeasuredImpact& shot, double restitution) {
  ModelledImpact impact;
  impact.trace = shot.trace;
  impact.trace.deflection.assign(shot.trace.time.size(), 0.0);
  impact.scalars.restitution = restitution;
  impact.scalars.contact_time = push_time;
  impact.scalars.peak_force = push;
  return impact;
}

std::vector<double> push_residuals(const Observations& seen, double restitution) {
  const std::vector<std::size_t> shots{0};
  RecordsOfShots records(seen, shots);
  std::vector<CalibrationParameter> unknowns;
  records.add_unknowns([](std::size_t) { return 0.0; }, unknowns);
  return records.residuals({0.0, 0.0}, {modelled_push(seen.shots.front(), restitution)}, {});
}

TEST(RecordsOfShotsTest, ARestitutionIsOneMoreResidual) {
  Observations seen;
  seen.shots = {half_sine_push()};
  const auto without = push_residuals(seen, 0.75);
  seen.shots.front().restitution = {.value = 0.8, .uncertainty = 0.01};
  const auto with = push_residuals(seen, 0.75);
  ASSERT_EQ(with.size(), without.size() + 1);
  EXPECT_NEAR(with.back(), -5.0, 1e-9);
  EXPECT_NEAR(push_residuals(seen, 0.8).back(), 0.0, 1e-9);
  seen.shots.front().restitution.uncertainty.reset();
  EXPECT_EQ(push_residuals(seen, 0.75).size(), without.size()) << "what has no error says nothing";
}

/// A shot that was faster than stated is stronger and shorter, as Hertz has it.
TEST(RecordsOfShotsTest, ASpeedWithinItsErrorIsAnUnknown) {
  constexpr double faster = 0.02;
  Observations seen;
  seen.shots = {half_sine_push()};
  MeasuredImpact& shot = seen.shots.front();
  const ModelledImpact as_stated = modelled_push(shot, 0.75);
  shot.speed_uncertainty = 0.1;
  const double force = std::pow(1.0 + faster, 1.2), time = std::pow(1.0 + faster, -0.2);
  for (std::size_t i = 0; i < shot.trace.time.size(); ++i) {
    const double phase = shot.trace.time[i] / (time * push_time);
    shot.trace.force[i] = phase < 1.0 ? force * push * std::sin(std::numbers::pi * phase) : 0.0;
  }
  const std::vector<std::size_t> shots{0};
  RecordsOfShots records(seen, shots);
  std::vector<CalibrationParameter> unknowns;
  records.add_unknowns([](std::size_t) { return 0.0; }, unknowns);
  ASSERT_EQ(unknowns.size(), 3u);
  ASSERT_TRUE(unknowns[1].prior);
  EXPECT_NEAR(unknowns[1].prior->deviation, 0.01, 1e-12);
  std::vector<double> values(3, 0.0);
  const auto largest = [&] {
    double most = 0.0;
    for (const double r : records.residuals(values, {as_stated}, {}))
      most = std::max(most, std::abs(r));
    return most;
  };
  EXPECT_GT(largest(), 1.0);
  values[1] = 1.0 / (1.0 + faster) - 1.0;  // stated over true, less one
  EXPECT_LT(largest(), 0.1);
}

/// A load cell has one gain. A gain of each shot would take up what an effect does to how the force
/// grows with the speed.
TEST(RecordsOfShotsTest, OneGainServesAllShots) {
  Observations seen;
  seen.gain_uncertainty = 0.02;
  seen.shots = {half_sine_push(), half_sine_push()};
  for (double& force : seen.shots[1].trace.force) force *= 1.1;
  const std::vector<std::size_t> shots{0, 1};
  RecordsOfShots records(seen, shots);
  std::vector<CalibrationParameter> unknowns;
  records.add_unknowns([](std::size_t) { return 0.0; }, unknowns);
  ASSERT_EQ(unknowns.size(), 3u) << "the gain, and a start of each shot";
  const ModelledImpact push_of_both = modelled_push(half_sine_push(), 0.75);
  const auto rows = records.residuals({0.1, 0.0, 0.0}, {push_of_both, push_of_both}, {});
  EXPECT_NEAR(std::abs(rows[25]), 10.0, 1e-6) << "a tenth of the peak over 10 N";
  EXPECT_NEAR(rows[51 + 25], 0.0, 1e-6);
  RecordsOfShots of_known_gain(seen, shots, 0.1);
  std::vector<CalibrationParameter> starts;
  of_known_gain.add_unknowns([](std::size_t) { return 0.0; }, starts);
  ASSERT_EQ(starts.size(), 2u);
  EXPECT_EQ(of_known_gain.residuals({0.0, 0.0}, {push_of_both, push_of_both}, {}), rows);
}

/// Faults of the measurement act on the records of a ball of FE as on those of a law.
TEST(RecordsOfShotsTest, AFaultActsOnTheRecord) {
  Observations seen;
  seen.shots = {half_sine_push()};
  for (double& force : seen.shots.front().trace.force) force = std::min(force, 0.8 * push);
  const std::vector<std::size_t> shots{0};
  RecordsOfShots records(seen, shots);
  std::vector<CalibrationParameter> unknowns;
  records.add_unknowns([](std::size_t) { return 0.0; }, unknowns);
  const ModelledImpact whole = modelled_push(half_sine_push(), 0.75);
  const auto largest = [&](const std::vector<EffectChoice>& effects) {
    double most = 0.0;
    for (const double r : records.residuals({0.0, 0.0}, {whole}, effects))
      most = std::max(most, std::abs(r));
    return most;
  };
  EXPECT_NEAR(largest({}), 20.0, 1e-6);
  EXPECT_NEAR(largest({{.name = "clipping", .size = 0.8 * push, .parameters = {}}}), 0.0, 1e-6);
  EXPECT_NEAR(largest({{.name = "relaxation", .size = 0.5, .parameters = {}}}), 20.0, 1e-6)
      << "what is physical is in the impact already";
}

/// Errors of a mesh are independent of those of the data: their squares add.
TEST(MeshErrorsTest, AddToThoseOfTheData) {
  Observations seen;
  seen.shots = {half_sine_push()};
  seen.shots.front().restitution = {.value = 0.8, .uncertainty = 0.003};
  ScalarShares shares{};
  shares[0] = 0.005;  // of the restitution
  const MeasuredImpact with = with_errors_of_mesh(seen, 0.01, shares).shots.front();
  EXPECT_NEAR(*with.restitution.uncertainty, 0.005, 1e-12);
  const auto before = push_residuals(seen, 0.75), after = push_residuals({.shots = {with}}, 0.75);
  EXPECT_NEAR(after.back() / before.back(), 0.6, 1e-9);
  EXPECT_EQ(with_errors_of_mesh(seen, 0.0, {}).shots.front().restitution.uncertainty,
            seen.shots.front().restitution.uncertainty);
}

// One halving and two told whole; in a search, which moves on to other balls, more of two.
TEST(MeshErrorsTest, AnErrorOfItsOrderIsToldWhole) {
  const auto at_edge = [](double edge) { return 3.0 + 0.2 * std::pow(edge, 1.5); };
  const auto told = [&](int halvings) {
    const double fine = at_edge(std::exp2(-halvings));
    return share_missing_beyond(halvings) * (at_edge(1.0) - fine) / (fine - at_edge(0.0));
  };
  EXPECT_NEAR(told(1), 1.0, 1e-12);
  EXPECT_NEAR(told(2), 1.0, 1e-12);
  EXPECT_DOUBLE_EQ(share_missing_in_a_search(1), share_missing_beyond(1));
  EXPECT_DOUBLE_EQ(share_missing_in_a_search(2), 0.4);
}

TEST(MeshErrorsTest, SharesAreThoseOfTheFirst) {
  ImpactScalars first, second;
  first.restitution = 0.8;
  second.restitution = 0.76;
  first.contact_time = first.peak_force = first.peak_deflection = first.mean_deflection = 1.0;
  second.contact_time = second.peak_force = second.peak_deflection = second.mean_deflection = 1.5;
  const ScalarShares shares = shares_added(first, second);
  EXPECT_NEAR(shares[0], -0.05, 1e-12);
  for (std::size_t k = 1; k < shares.size(); ++k) EXPECT_NEAR(shares[k], 0.5, 1e-12);
}

}  // namespace
}  // namespace rebound
