#include "lumped/laws/make_law.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "lumped/integration/simulate.hpp"
#include "lumped/problem/error.hpp"
#include "tests/support/lumped_cases.hpp"

namespace rebound {
namespace {

LumpedProblem paper_core_a() {
  LumpedProblem problem = test::typical_problem("hunt-crossley");
  problem.model.parameters = {{"stiffness", 3.5e6}};
  problem.model.at_speed = {{5.0, {{"damping", 37.69e4}}}, {15.0, {{"damping", 17.63e4}}}};
  return problem;
}

double damping_at(const LumpedProblem& problem, double speed) {
  Impact impact = problem.impact;
  impact.speed = speed;
  return resolve_parameters(problem.model, impact, problem.sphere).at("damping");
}

std::string refused_key(const std::function<void(LumpedProblem&)>& spoil) {
  LumpedProblem problem = paper_core_a();
  spoil(problem);
  try {
    make_law(problem.model, problem.impact, problem.sphere);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::bad_input);
    return error.location().key;
  }
  return "accepted";
}

TEST(MakeLawTest, EntryAppliesAtItsSpeed) {
  EXPECT_EQ(damping_at(paper_core_a(), 5.0), 37.69e4);
  EXPECT_EQ(damping_at(paper_core_a(), 15.0 * (1 + 0.9e-6)), 17.63e4);
  EXPECT_THROW(damping_at(paper_core_a(), 15.0 * (1 + 2e-6)), Error);
}

TEST(MakeLawTest, BaseValueHoldsBetweenEntries) {
  LumpedProblem problem = paper_core_a();
  problem.model.parameters["damping"] = 1e5;
  EXPECT_EQ(damping_at(problem, 9.0), 1e5);
  EXPECT_EQ(damping_at(problem, 15.0), 17.63e4);
}

TEST(MakeLawTest, RestitutionFillsWhereNoEntryApplies) {
  LumpedProblem problem = paper_core_a();
  problem.model.restitution = 0.527;
  problem.model.damping_formula = "exact";
  EXPECT_EQ(damping_at(problem, 5.0), 37.69e4);
  problem.impact.speed = 9.0;
  EXPECT_NEAR(simulate_fast(problem).scalars.restitution, 0.527, 1e-8);
}

// "exact" must return what it was asked for, for every law that offers it.
TEST(MakeLawTest, ExactFormulaReturnsTheRestitution) {
  int laws = 0;
  for (const auto& card : all_laws()) {
    if (card.damping_parameter.empty()) continue;
    ++laws;
    for (const auto rule : {SeparationRule::zero_force, SeparationRule::zero_deflection}) {
      LumpedProblem problem = test::typical_problem(card.name);
      problem.impact.separation = rule;
      problem.model.parameters.erase(card.damping_parameter);
      problem.model.restitution = 0.5;
      problem.model.damping_formula = "exact";
      EXPECT_NEAR(simulate_fast(problem).scalars.restitution, 0.5, 1e-8) << card.name;
    }
  }
  EXPECT_EQ(laws, 4);
}

TEST(MakeLawTest, RefusalsNameTheKey) {
  using P = LumpedProblem&;
  EXPECT_EQ(refused_key([](P p) { p.model.law = "nonsense"; }), "model.law");
  EXPECT_EQ(refused_key([](P p) { p.model.parameters["mass"] = 1.0; }), "model.mass");
  EXPECT_EQ(refused_key([](P p) { p.model.at_speed[0].parameters["k"] = 1.0; }),
            "model.at_speed[0].k");
  EXPECT_EQ(refused_key([](P p) { p.model.restitution = 0.5; }), "model.damping_formula");
  EXPECT_EQ(refused_key([](P p) { p.model.damping_formula = "exact"; }), "model.restitution");
  EXPECT_EQ(refused_key([](P p) {
              p.model.parameters["damping"] = 1e5;
              p.model.restitution = 0.5;
              p.model.damping_formula = "exact";
            }),
            "model.damping");
  EXPECT_EQ(refused_key([](P p) {
              p.model.at_speed[1].speed = 5.0;
              p.impact.speed = 5.0;
            }),
            "model.at_speed[1].speed");
  EXPECT_EQ(refused_key([](P p) { p.sphere.mass = 0.0; }), "sphere.mass");
  EXPECT_EQ(refused_key([](P p) { p.impact.speed = -1.0; }), "impact.speed");
  EXPECT_EQ(refused_key([](P p) {
              p.model = {.law = "hertz-damped",
                         .parameters = {{"stiffness", 3e6}},
                         .restitution = 0.5,
                         .damping_formula = "exact",
                         .at_speed = {}};
            }),
            "model.restitution");
}

}  // namespace
}  // namespace rebound
