// What is measured beside the force: deflections, scalars of other instruments, slow tests.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "comparisons/discrepancy/diagnosis/fits/slow_comparisons.hpp"
#include "comparisons/discrepancy/diagnosis/fits/static_force.hpp"
#include "comparisons/discrepancy/diagnosis/observations/observe.hpp"
#include "tests/unit/comparisons/discrepancy/diagnosis/hidden_cases.hpp"

namespace rebound {
namespace {

using testing::believed_law;
using testing::experiment_with;
using testing::measured_data;

SynthesisFile with_deflections(std::int64_t seed) {
  SynthesisFile file = experiment_with({}, seed);
  file.instrument.deflection = DeflectionOrigin::independent;
  file.instrument.deflection_noise = 2e-5;
  file.instrument.deflection_gain_uncertainty = 0.005;
  return file;
}

std::size_t rows_of(const HypothesisFit& fit, ObservedQuantity what) {
  const auto& rows = fit.model->rows();
  return static_cast<std::size_t>(std::count_if(
      rows.begin(), rows.end(), [&](const DataRow& row) { return row.what == what; }));
}

double chi_square_of(const HypothesisFit& fit, ObservedQuantity what) {
  double sum = 0.0;
  for (std::size_t i = 0; i < fit.data_rows(); ++i)
    if (fit.model->rows()[i].what == what) sum += fit.residuals[i] * fit.residuals[i];
  return sum;
}

bool warns(const Observations& seen, const std::string& words) {
  return std::any_of(seen.warnings.begin(), seen.warnings.end(), [&](const std::string& warning) {
    return warning.find(words) != std::string::npos;
  });
}

const Estimate& estimate_of(const HypothesisFit& fit, const std::string& name) {
  const auto& all = fit.search.estimates;
  return *std::find_if(all.begin(), all.end(), [&](const Estimate& one) {
    return one.name.compare(0, name.size(), name) == 0;
  });
}

TEST(DeflectionRowsTest, AreAsFarFromTheTrueModelAsTheirNoise) {
  for (int seed = 1; seed <= 10; ++seed) {
    const Observations seen = observe({measured_data(with_deflections(seed))});
    const HypothesisFit fit = fit_hypothesis(seen, {.believed = believed_law()});
    const auto rows = static_cast<double>(rows_of(fit, ObservedQuantity::deflection));
    ASSERT_GT(rows, 100.0);
    // Four standard deviations of a χ², and the numbers that the deflections alone determine.
    EXPECT_NEAR(chi_square_of(fit, ObservedQuantity::deflection), rows,
                4.0 * std::sqrt(2.0 * rows) + 8.0);
  }
}

// Forces alone tell how much energy is lost from the shape of the pulse; the gain goes with it.
TEST(DeflectionRowsTest, TellTheGainAndTheDampingBetterThanForcesAlone) {
  for (int seed = 5; seed <= 7; ++seed) {
    SynthesisFile file = with_deflections(seed);
    file.instrument.deflection_gain_uncertainty = 0.001;
    Dataset dataset = measured_data(file);
    const Hypothesis believed{.believed = believed_law()};
    const Observations both = observe({dataset});
    const HypothesisFit with = fit_hypothesis(both, believed);
    dataset.instrument.deflection = DeflectionOrigin::integrated;
    const Observations forces = observe({dataset});
    const HypothesisFit without = fit_hypothesis(forces, believed);
    for (const char* name : {"damping", "force gain"})
      EXPECT_LT(estimate_of(with, name).standard_error,
                0.8 * estimate_of(without, name).standard_error);
  }
}

TEST(DeflectionRowsTest, IntegratedOnesHoldNothingAndThatIsSaid) {
  SynthesisFile file = experiment_with({}, 5);
  file.instrument.deflection = DeflectionOrigin::integrated;
  const Observations seen = observe({measured_data(file)});
  EXPECT_TRUE(warns(seen, "integrated from the force"));
  const HypothesisFit fit = fit_hypothesis(seen, {.believed = believed_law()});
  EXPECT_EQ(rows_of(fit, ObservedQuantity::deflection), 0u);
}

TEST(DeflectionRowsTest, NoiseThatTheScatterContradictsIsReplaced) {
  SynthesisFile file = with_deflections(6);
  file.sampling.before = 1e-3;
  Dataset dataset = measured_data(file);
  dataset.instrument.deflection_noise = 1e-4;
  const Observations seen = observe({dataset});
  EXPECT_TRUE(warns(seen, "deflections scatter by"));
  EXPECT_NEAR(seen.shots[0].deflection_noise.deviation, 2e-5, 5e-6);
}

TEST(DeflectionRowsTest, DataWithThemAgreeWhereNothingIsHidden) {
  int agree = 0;
  for (int seed = 11; seed <= 14; ++seed)
    agree += testing::diagnose_hidden(with_deflections(seed)).verdict == DiagnosisVerdict::agrees;
  EXPECT_GE(agree, 3);
}

TEST(ScalarsBesideAHistoryTest, TakePartWhereAnInstrumentOfTheirOwnGaveThem) {
  Dataset dataset = measured_data(experiment_with({}, 7));
  dataset.shots[0].peak_force = {.value = 700.0, .uncertainty = 10.0};
  dataset.shots[0].peak_deflection = {.value = 3e-3, .uncertainty = 1e-4};
  const auto takes_part = [&](Measured MeasuredImpact::*scalar) {
    return (observe({dataset}).shots[0].*scalar).has_error();
  };
  EXPECT_FALSE(takes_part(&MeasuredImpact::peak_force));
  EXPECT_FALSE(takes_part(&MeasuredImpact::peak_deflection));
  EXPECT_TRUE(observe({dataset}).shots[0].peak_force.is_stated());  // to be compared
  dataset.instrument.independent_scalars = {"peak_force"};
  dataset.instrument.deflection = DeflectionOrigin::independent;
  EXPECT_TRUE(takes_part(&MeasuredImpact::peak_force));
  EXPECT_TRUE(takes_part(&MeasuredImpact::peak_deflection));
}

/// What a law and a branch beside it give when they are loaded slowly, times a factor.
Quasistatic slow_curve(const LumpedModel& model, double factor, int platens) {
  const LumpedProblem problem{
      .sphere = {.mass = 89.6e-3, .diameter = 66.2e-3}, .impact = {.speed = 15.0}, .model = model};
  Quasistatic test{.platens = platens, .curve = ForceDeflectionCurve{}, .force_uncertainty = 0.02};
  for (int i = 1; i <= 200; ++i) {
    const double deflection = 4e-5 * i;
    test.curve->deflection.push_back(platens * deflection);
    test.curve->force.push_back(factor * static_force(problem, deflection, 10.0));
  }
  return test;
}

TEST(StaticForceTest, RelaxesFromInstantaneousToRelaxed) {
  LumpedProblem problem{.sphere = {.mass = 0.09, .diameter = 0.066}, .impact = {.speed = 5.0}};
  problem.model.parameters = {{"exponent", 1.5}, {"stiffness", 1e6}, {"damping", 0.0}};
  const double relaxed = 1e6 * std::pow(1e-3, 1.5);
  EXPECT_NEAR(static_force(problem, 1e-3, 10.0), relaxed, 1e-9 * relaxed);
  problem.model.mechanisms.relaxation = {.ratio = 0.5, .relaxation_time = 1e-3};
  EXPECT_NEAR(static_force(problem, 1e-3, 1e3), relaxed, 1e-6 * relaxed);
  EXPECT_NEAR(static_force(problem, 1e-3, 1e-9), 1.5 * relaxed, 1e-5 * relaxed);
}

TEST(SlowCompressionTest, HoldsWhereTheLawHolds) {
  for (int platens : {1, 2})
    for (int seed = 1; seed <= 5; ++seed) {
      const SynthesisFile file = experiment_with({}, seed);
      Dataset dataset = measured_data(file);
      dataset.quasistatic = {slow_curve(file.lumped, 1.0, platens)};
      const Observations seen = observe({dataset});
      const HypothesisFit fit = fit_hypothesis(seen, {.believed = believed_law()});
      EXPECT_EQ(rows_of(fit, ObservedQuantity::quasistatic), 9u);
      const Estimate& factor = estimate_of(fit, "slow over impact");
      EXPECT_NEAR(factor.value, 0.0, 4.0 * factor.standard_error);
      EXPECT_LT(chi_square_of(fit, ObservedQuantity::quasistatic), 9.0);
    }
}

// A ball that is softer when it is slow: the fit stands as it was, and the difference is said.
TEST(SlowCompressionTest, ASofterBallIsComparedAndSpoilsNoFit) {
  for (int seed = 1; seed <= 5; ++seed) {
    const SynthesisFile file = experiment_with({}, seed);
    Dataset dataset = measured_data(file);
    const Hypothesis believed{.believed = believed_law()};
    const HypothesisFit alone = fit_hypothesis(observe({dataset}), believed);
    dataset.quasistatic = {slow_curve(file.lumped, 0.4, 2)};
    const Observations seen = observe({dataset});
    const HypothesisFit fit = fit_hypothesis(seen, believed);
    EXPECT_NEAR(estimate_of(fit, "stiffness").value, estimate_of(alone, "stiffness").value,
                0.1 * estimate_of(alone, "stiffness").standard_error);
    EXPECT_LT(fit.chi_square - alone.chi_square, std::log(static_cast<double>(fit.data_rows())));
    const std::vector<DataCheck> checks = compare_slow_tests(seen, fit);
    ASSERT_EQ(checks.size(), 1u);
    EXPECT_NEAR(checks[0].measured, 0.4, 4.0 * checks[0].error);
    EXPECT_TRUE(checks[0].compared_only);
    EXPECT_NE(checks[0].mended_by.find("memory"), std::string::npos);
  }
}

// With memory the relaxed force is the test's own: what another explanation lets go costs it as
// much as a number.
TEST(SlowCompressionTest, SpeaksForMemoryWhereItIsWhatWasHidden) {
  int speaks = 0;
  constexpr int seeds = 4;
  for (int seed = 1; seed <= seeds; ++seed) {
    const SynthesisFile file =
        experiment_with({{"relaxation", 1.0, {{"relaxation_time", 3e-4}}}}, seed);
    Dataset dataset = measured_data(file);
    const auto lead = [&] {
      const Observations seen = observe({dataset});
      const auto criterion = [&](EffectChoice effect) {
        return fit_hypothesis(seen, {.believed = believed_law(), .effects = {effect}})
            .information_criterion;
      };
      return criterion({"hysteresis", 0.2, {}}) -
             criterion({"relaxation", 0.8, {{"relaxation_time", 3e-4}}});
    };
    const double without = lead();
    dataset.quasistatic = {slow_curve(file.lumped, 1.0, 1)};
    speaks += lead() - without > 3.0 ? 1 : 0;
  }
  EXPECT_GE(speaks, 3);
}

TEST(SlowComparisonsTest, TheLawItselfIsOne) {
  const SynthesisFile file = experiment_with({}, 3);
  Dataset dataset = measured_data(file);
  Quasistatic stiffness{.platens = 2, .stiffness = {.value = 3.2e6 / std::pow(2.0, 1.5)}};
  dataset.quasistatic = {stiffness};
  const Observations seen = observe({dataset});
  const HypothesisFit fit = fit_hypothesis(seen, {.believed = believed_law()});
  EXPECT_EQ(rows_of(fit, ObservedQuantity::quasistatic), 0u);  // no uncertainty: compared only
  const std::vector<DataCheck> checks = compare_slow_tests(seen, fit);
  ASSERT_EQ(checks.size(), 1u);
  EXPECT_NEAR(checks[0].measured, 1.0, 2.0 * checks[0].error);
  EXPECT_TRUE(checks[0].mended_by.empty());
}

TEST(SlowComparisonsTest, APlatenTooManyABlockAndPooledPeaksAreSaid) {
  Dataset dataset = measured_data(experiment_with({}, 3));
  dataset.quasistatic = {{.platens = 1, .stiffness = {.value = 3.2e6 / std::pow(2.0, 1.5)}}};
  dataset.block_tests = {{.modulus = {.value = 1.94e6, .uncertainty = 1e5}}};
  dataset.pooled_peaks = {{.speed = 15.0, .force = 3.2e3, .deflection = 9e-3}};
  const Observations seen = observe({dataset});
  const HypothesisFit fit = fit_hypothesis(seen, {.believed = believed_law()});
  const std::vector<DataCheck> checks = compare_slow_tests(seen, fit);
  ASSERT_EQ(checks.size(), 4u);
  EXPECT_NE(checks[0].mended_by.find("two platens"), std::string::npos);
  // (4/3) E/(1 − ν²) √R over 3.2e6, in the middle of ν from 0.2 to 0.5.
  const double hertz = 4.0 / 3.0 * 1.94e6 * std::sqrt(33.1e-3) * 0.5 * (1.0 / 0.96 + 1.0 / 0.75);
  EXPECT_NEAR(checks[1].measured, hertz / 3.2e6, 0.05 * hertz / 3.2e6);
  for (const DataCheck& one : checks) EXPECT_TRUE(one.compared_only);
}

}  // namespace
}  // namespace rebound
