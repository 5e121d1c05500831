#include "comparisons/discrepancy/diagnosis/asked_fem/verdict_of_fem.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "comparisons/discrepancy/diagnosis/asked_fem/model_discrepancy.hpp"

namespace rebound {
namespace {

/// FE with nothing hidden leaves ten times the noise of a thousand samples.
constexpr double left_without = 10.0;
FemOfAllBalls nothing_hidden() {
  FemOfAllBalls whole;
  whole.samples = 1000;
  whole.chi_square = left_without * 1000.0;
  return whole;
}

struct UnseenGap {
  double before, after;
};

EffectInFem tried(const std::string& name, double left,
                  std::optional<UnseenGap> unseen = std::nullopt) {
  EffectInFem one{.effect = {.name = name, .size = 0.1, .parameters = {}},
                  .information_criterion = 1000.0 * left,
                  .gap = {.before = left_without, .after = left}};
  if (unseen) {
    one.gap.held_out_before = unseen->before;
    one.gap.held_out_after = unseen->after;
    one.unseen_chi_square = 1000.0 * unseen->after;
  }
  one.family = find_effect(name).card.family;
  return with_verdicts(one, nothing_hidden(), {});
}

Diagnosis concluded(std::vector<EffectInFem> in_fem) {
  Diagnosis d;
  d.verdict = DiagnosisVerdict::unexplained;
  d.in_fem = std::move(in_fem);
  sort_nearest_first(d.in_fem);
  conclude_from_fem(d, {}, [] { return 0.0; });
  return d;
}

/// FE's part of a verdict that a law with a rate effect has, by a family; FE tried one of the
/// surface, which leaves 1200, and the law leaves this.
Diagnosis concluded_beside_a_family(double criterion_of_lumped,
                                    const std::string& in_fem = "adhesion") {
  Diagnosis d;
  d.verdict = DiagnosisVerdict::family;
  d.family = EffectFamily::rate;
  d.candidates = {{"rate-stiffening"}};
  d.in_fem = {tried(in_fem, 1.2)};
  conclude_from_fem(d, {}, [&] { return criterion_of_lumped; });
  return d;
}

TEST(VerdictOfFem, WhatExplainsTheDataGivesItsFamily) {
  const Diagnosis d = concluded({tried("adhesion", 1.2), tried("permanent-set", 8.0)});
  EXPECT_EQ(d.verdict, DiagnosisVerdict::family);
  EXPECT_EQ(d.family, EffectFamily::surface);
  EXPECT_EQ(d.candidates, (std::vector<std::vector<std::string>>{{"adhesion"}}));
  EXPECT_EQ(d.shots_in_fem->effect, "adhesion");
}

TEST(VerdictOfFem, AFaultThatExplainsTheDataIsOfTheMeasurement) {
  const Diagnosis d = concluded({tried("burst", 1.2), tried("permanent-set", 8.0)});
  EXPECT_EQ(d.verdict, DiagnosisVerdict::measurement_fault);
  EXPECT_EQ(d.family, EffectFamily::measurement);
  EXPECT_EQ(d.candidates, (std::vector<std::vector<std::string>>{{"burst"}}));
  EXPECT_EQ(d.gap.before, left_without);
  EXPECT_EQ(d.gap.after, 1.2);
  EXPECT_NE(d.fault.find("burst takes the gap from 10 to 1.2"), std::string::npos) << d.fault;
}

/// A fault acts on the record of either tier.
TEST(VerdictOfFem, AFaultHasAFormBesideTheLumpedLaw) {
  EXPECT_EQ(tried("burst", 1.2).lumped, "rejected");
  EXPECT_EQ(tried("adhesion", 1.2).lumped, "rejected");
}

/// Tsuji's damper in a law: FE's own ball took most of it, and a slow sensor the rest.
TEST(VerdictOfFem, AFamilyOfTheLawStandsWhereItIsAhead) {
  const Diagnosis ahead = concluded_beside_a_family(1190.0);
  EXPECT_EQ(ahead.verdict, DiagnosisVerdict::family);
  EXPECT_EQ(ahead.family, EffectFamily::rate);
  EXPECT_EQ(ahead.warnings.size(), 1U);
  EXPECT_EQ(concluded_beside_a_family(1210.0).family, EffectFamily::surface) << "FE is ahead";
  EXPECT_EQ(concluded_beside_a_family(1190.0, "rate-stiffening").withheld.rfind("it depends on", 0),
            0U)
      << "FE says the same family";
}

TEST(VerdictOfFem, FamiliesOfBothTiersAreOneOfBoth) {
  for (const double level : {1195.0, 1205.0}) {
    const Diagnosis d = concluded_beside_a_family(level);
    EXPECT_EQ(d.verdict, DiagnosisVerdict::one_of);
    EXPECT_EQ(d.family, EffectFamily::none);
    EXPECT_EQ(d.candidates,
              (std::vector<std::vector<std::string>>{{"rate-stiffening"}, {"adhesion"}}));
  }
}

TEST(VerdictOfFem, TwoFamiliesWithinReachGiveNone) {
  EffectInFem rival = tried("permanent-set", 1.2);
  rival.information_criterion += 5.0;
  EXPECT_EQ(concluded({tried("adhesion", 1.2), rival}).verdict, DiagnosisVerdict::unexplained);
  rival.information_criterion += 2.0;  // beyond reach
  EXPECT_EQ(concluded({tried("adhesion", 1.2), rival}).family, EffectFamily::surface);
}

/// Both explain what was fitted, and half of the gap at the unseen speed is gone with either.
TEST(VerdictOfFem, ARivalMustFollowTheUnseenSpeedAsWell) {
  const auto beside = [](double unseen_after) {
    return concluded({tried("force-drift", 1.2, UnseenGap{4.0, unseen_after}),
                      tried("adhesion", 1.203, UnseenGap{4.0, 1.3})});
  };
  EXPECT_EQ(beside(1.3).verdict, DiagnosisVerdict::unexplained);
  EXPECT_EQ(beside(1.5).family, EffectFamily::surface);
  EXPECT_EQ(beside(1.1).verdict, DiagnosisVerdict::measurement_fault);
}

TEST(VerdictOfFem, NearlyAllIsEnoughWhereNoOtherFamilyTakesHalf) {
  const double nearly = 1.8, half = 5.5;
  EXPECT_EQ(tried("adhesion", nearly).fem, "no-fit");
  EXPECT_EQ(concluded({tried("adhesion", nearly), tried("permanent-set", half + 0.1)}).family,
            EffectFamily::surface);
  EXPECT_EQ(concluded({tried("adhesion", nearly), tried("permanent-set", half - 0.1)}).verdict,
            DiagnosisVerdict::unexplained);
  EXPECT_EQ(concluded({tried("adhesion", 2.0)}).verdict, DiagnosisVerdict::unexplained);
}

/// A gap that is seen at the unseen speed must shrink there; where none is seen, none may come.
TEST(VerdictOfFem, TheUnseenSpeedHasItsSay) {
  EXPECT_EQ(tried("adhesion", 1.2, UnseenGap{4.0, 1.5}).fem, "supported");
  EXPECT_EQ(tried("adhesion", 1.2, UnseenGap{4.0, 3.5}).fem, "rejected");
  EXPECT_EQ(tried("adhesion", 1.2, UnseenGap{0.9, 1.0}).fem, "supported");
  EXPECT_EQ(tried("adhesion", 1.2, UnseenGap{0.9, 1.6}).fem, "rejected");
  EXPECT_EQ(concluded({tried("adhesion", 1.8, UnseenGap{4.0, 2.0})}).verdict,
            DiagnosisVerdict::unexplained)
      << "nearly all has not gone there";
}

/// FE with nothing hidden leaves the noise; this gains in χ² of the thousand samples that it has.
EffectInFem weak(const std::string& name, double gained, UnseenGap unseen = {1.0, 0.9}) {
  EffectInFem one{.effect = {.name = name, .size = 0.1, .parameters = {}},
                  .information_criterion = 1000.0 - gained,
                  .gap = {.before = 1.0,
                          .after = 1.0 - gained / 1000.0,
                          .held_out_before = unseen.before,
                          .held_out_after = unseen.after}};
  one.family = find_effect(name).card.family;
  return one;
}

Diagnosis concluded_weakly(std::vector<EffectInFem> in_fem) {
  FemOfAllBalls without;
  without.samples = 1000;
  without.chi_square = 1000.0;
  Diagnosis d;
  d.verdict = DiagnosisVerdict::agrees;
  d.in_fem = std::move(in_fem);
  conclude_from_weak_effects(d, without);
  return d;
}

TEST(VerdictOfFem, AWeakEffectGivesTheFamilyOfAllThatGainAsMuch) {
  const Diagnosis d = concluded_weakly(
      {weak("hysteresis", 100.0), weak("permanent-set", 75.0), weak("strain-stiffening", 65.0)});
  EXPECT_EQ(d.verdict, DiagnosisVerdict::family);
  EXPECT_EQ(d.family, EffectFamily::history);
  EXPECT_EQ(d.candidates,
            (std::vector<std::vector<std::string>>{{"hysteresis"}, {"permanent-set"}}));
  EXPECT_EQ(d.in_fem[2].fem, "rejected");
  EXPECT_EQ(d.gap.after, 0.9);
  const Diagnosis of_two =
      concluded_weakly({weak("hysteresis", 100.0), weak("strain-stiffening", 75.0)});
  EXPECT_EQ(of_two.verdict, DiagnosisVerdict::one_of);
  EXPECT_EQ(of_two.family, EffectFamily::none);
}

TEST(VerdictOfFem, AWeakEffectMustHoldAtTheUnseenSpeed) {
  const double gained = 100.0;  // a tenth of the noise in each reading
  EXPECT_EQ(concluded_weakly({weak("hysteresis", gained, {1.0, 0.97})}).verdict,
            DiagnosisVerdict::family);
  const Diagnosis denied = concluded_weakly({weak("hysteresis", gained, {1.0, 0.99})});
  EXPECT_EQ(denied.verdict, DiagnosisVerdict::agrees);
  EXPECT_EQ(denied.in_fem[0].fem, "rejected");
  EXPECT_TRUE(denied.candidates.empty());
}

TEST(VerdictOfFem, WhatIsLeftOnSharperCellsIsAGap) {
  const auto denied = [](double reduced_chi_square, std::optional<double> unseen) {
    FemOfAllBalls without;
    without.samples = 1000;
    without.chi_square = 1000.0 * reduced_chi_square;
    Diagnosis d;
    d.verdict = DiagnosisVerdict::agrees;
    deny_where_sharper_cells_do(d, without, unseen);
    return d;
  };
  const Diagnosis d = denied(5.0, 2.6);
  EXPECT_EQ(d.verdict, DiagnosisVerdict::unexplained);
  EXPECT_EQ(d.gap.before, 5.0);
  EXPECT_EQ(d.gap.held_out_before, 2.6);
  EXPECT_FALSE(d.withheld.empty());
  EXPECT_EQ(denied(5.0, 1.2).verdict, DiagnosisVerdict::agrees);
  EXPECT_EQ(denied(1.2, 2.6).verdict, DiagnosisVerdict::agrees);
  EXPECT_EQ(denied(5.0, std::nullopt).verdict, DiagnosisVerdict::agrees);
}

/// A rival that gains as much and takes the unseen speed farther away is none.
TEST(VerdictOfFem, AWeakRivalMustNotLoseAtTheUnseenSpeed) {
  const auto beside = [](double unseen_after) {
    return concluded_weakly(
        {weak("relaxation-spectrum", 100.0), weak("odd-shot", 90.0, {1.0, unseen_after})});
  };
  EXPECT_EQ(beside(0.99).verdict, DiagnosisVerdict::one_of);
  EXPECT_EQ(beside(1.01).verdict, DiagnosisVerdict::family);
  EXPECT_EQ(beside(1.01).family, EffectFamily::memory);
}

TEST(VerdictOfFem, NothingFoundStandsWhereFemFollows) {
  Diagnosis d;
  d.verdict = DiagnosisVerdict::family;
  d.family = EffectFamily::dynamics;
  d.candidates = {{"internal-mode"}};
  d.withheld = "the unseen speed";
  d.gap = {.before = 2.0, .after = 0.9};
  d.fem_alone = std::make_shared<const ModelDiscrepancy>();
  FemOfAllBalls without;
  without.samples = 1000;
  without.chi_square = 800.0;
  let_fem_stand(d, without, 0.9);
  EXPECT_EQ(d.verdict, DiagnosisVerdict::agrees);
  EXPECT_EQ(d.family, EffectFamily::none);
  EXPECT_TRUE(d.candidates.empty());
  EXPECT_TRUE(d.withheld.empty());
  EXPECT_EQ(d.gap.before, 0.8);
  EXPECT_FALSE(d.gap.after);
  EXPECT_EQ(d.law_alone->before, 2.0);
  EXPECT_EQ(d.shots_in_fem->effect, "");
}

TEST(VerdictOfFem, NothingTriedLeavesTheVerdict) {
  EXPECT_EQ(concluded({}).verdict, DiagnosisVerdict::unexplained);
}

}  // namespace
}  // namespace rebound
