#include <gtest/gtest.h>

#include <set>

#include "tests/unit/comparisons/discrepancy/trials/generator/example.hpp"

namespace trials::testing {
namespace {

constexpr double alpha = 0.3;

/// Largest difference of two records over the peak force of the baseline.
double difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest / example_scales(alpha).force;
}

TEST(TrialForms, EveryFamilyHasFormsAndNoNameOccursTwice) {
  std::set<std::string> names, families;
  for (const EffectForm& form : all_forms()) {
    EXPECT_TRUE(names.insert(form.name).second) << form.name;
    families.insert(form.family);
  }
  EXPECT_EQ(families, (std::set<std::string>{"elastic", "rate", "memory", "history", "surface",
                                             "dynamics", "measurement", "out_of_family"}));
}

TEST(TrialForms, EveryFormIsTheBaselineAtSizeZero) {
  for (const EffectForm& form : all_forms())
    EXPECT_EQ(record_with(form, 0.0, alpha), record_with(all_forms().front(), 0.0, alpha))
        << form.name;
}

/// Seeded fault that this catches: a form that is not the baseline in the limit, but switched.
TEST(TrialForms, EveryFormTendsToTheBaselineWithItsSize) {
  const std::vector<double> baseline = record_with(all_forms().front(), 0.0, alpha);
  for (const EffectForm& form : all_forms())
    EXPECT_LT(difference(record_with(form, 1e-6, alpha), baseline), 2e-3) << form.name;
}

TEST(TrialForms, EveryFormChangesTheRecordAtItsLargestSize) {
  const std::vector<double> baseline = record_with(all_forms().front(), 0.0, alpha);
  for (const EffectForm& form : all_forms())
    EXPECT_GT(difference(record_with(form, form.largest, alpha), baseline), 0.01) << form.name;
}

TEST(TrialForms, ElasticFormsLoseNoEnergyWithoutDamping) {
  for (const EffectForm* form : forms_of("elastic"))
    EXPECT_NEAR(impact_with(*form, form->largest, 0.0).restitution, 1.0, 1e-5) << form->name;
}

TEST(TrialForms, DissipatingFormsLoseEnergyWithoutOtherDamping) {
  for (const char* family : {"memory", "history", "surface"})
    for (const EffectForm* form : forms_of(family)) {
      const bool conserves = form->name == "dmt";  // its pull is a function of x alone
      const double restitution = impact_with(*form, 0.5 * form->largest, 0.0).restitution;
      if (conserves)
        EXPECT_NEAR(restitution, 1.0, 1e-3) << form->name;
      else
        EXPECT_LT(restitution, 0.9999) << form->name;
    }
}

TEST(TrialForms, ImpulseIsTheChangeOfMomentum) {
  for (const EffectForm& form : all_forms()) {
    if (form.name == "magnet" || form.name == "second-ball") continue;  // other forces on the ball
    const SimulatedImpact impact = impact_with(form, 0.5 * form.largest, alpha);
    EXPECT_NEAR(impact.contact_impulse / impact.momentum_change, 1.0, 2e-4) << form.name;
  }
}

TEST(TrialSolver, BaselineAgreesWithThePulseWithoutDimensions) {
  const SimulatedImpact impact = impact_of(baseline_world(alpha), alpha);
  const BaselinePulse pulse(alpha);
  const PulseScales units = scales_of(example_ball(alpha), speed);
  EXPECT_NEAR(impact.restitution, pulse.restitution(), 1e-6);
  EXPECT_NEAR(impact.contact_time, pulse.contact_time() * units.time, 2.0 * impact.step);
  for (const double part : {0.1, 0.4, 0.8}) {
    const double time = part * impact.contact_time;
    EXPECT_NEAR(impact.at(time) / (units.force * pulse.force(time / units.time)), 1.0, 1e-5);
  }
}

/// Exact: p (1 + e) = ln[(1 + p)/(1 − p e)], the energy integral of Hunt–Crossley.
TEST(TrialSolver, RestitutionIsTheOneAskedFor) {
  for (const double e : {0.5, 0.7, 0.95})
    EXPECT_NEAR(BaselinePulse(alpha_of_restitution(e)).restitution(), e, 1e-5);
}

/// Exact for Hertz: T = 2.94 x_max/v, x_max = (5 m v²/(4 k))^(2/5).
TEST(TrialSolver, HertzContactTime) {
  const BaselinePulse hertz(0.0);
  EXPECT_NEAR(hertz.peak_deflection(), std::pow(1.25, 0.4), 1e-5);
  EXPECT_NEAR(hertz.contact_time() / std::pow(1.25, 0.4), 2.9432751, 1e-4);
}

}  // namespace
}  // namespace trials::testing
