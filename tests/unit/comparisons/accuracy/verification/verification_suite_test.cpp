#include "comparisons/accuracy/verification/verification_suite.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

#include "comparisons/accuracy/verification/refinement.hpp"
#include "lumped/problem/error.hpp"
#include "tests/support/refusals.hpp"

namespace rebound {
namespace {

VerificationPart one_row(const std::string& name) {
  return {{{.case_id = "x",
            .quantity = name,
            .unit = "",
            .target = 1.0,
            .result = 1.0,
            .tolerance = 0.1,
            .source = "s"}}};
}

TEST(VerificationSuiteTest, PartsKeepTheirOrder) {
  std::vector<SuitePart> parts;
  for (const char* name : {"a", "b", "c"})
    parts.push_back({name, 1.0, [name](const RunControl&) { return one_row(name); }});
  double last = 0.0;
  const SuiteOutcome outcome =
      run_suite(parts, {.interrupted = {}, .progress = [&](double done) { last = done; }});
  ASSERT_EQ(outcome.rows().size(), 3u);
  EXPECT_EQ(outcome.rows()[1].quantity, "b");
  EXPECT_TRUE(outcome.not_run.empty());
  EXPECT_NEAR(last, 1.0, 1e-12);
}

TEST(VerificationSuiteTest, AnInterruptionKeepsWhatIsComplete) {
  std::atomic<bool> stop = false;
  const std::vector<SuitePart> parts = {
      {"done", 1.0, [](const RunControl&) { return one_row("done"); }},
      {"cut", 1.0,
       [&](const RunControl&) -> VerificationPart {
         stop = true;
         throw Error(ExitCode::interrupted, "stopped");
       }},
      {"never begun", 1.0, [&](const RunControl& control) {
         while (!control.interrupted()) {
         }
         throw Error(ExitCode::interrupted, "stopped");
         return VerificationPart{};
       }}};
  const SuiteOutcome outcome =
      run_suite(parts, {.interrupted = [&] { return stop.load(); }, .progress = {}});
  EXPECT_EQ(outcome.rows().size(), 1u);
  EXPECT_EQ(outcome.not_run, (std::vector<std::string>{"cut", "never begun"}));
}

TEST(VerificationSuiteTest, AnotherErrorEndsIt) {
  const std::vector<SuitePart> parts = {{"fails", 1.0, [](const RunControl&) -> VerificationPart {
                                           throw Error(ExitCode::solver_failed, "no step");
                                         }}};
  EXPECT_EQ(testing::refusal_of([&] { run_suite(parts, {}); }).code(), ExitCode::solver_failed);
}

TEST(RefinementTest, APowerIsFound) {
  Refinement refinement{.name = "r", .size = {9.0, 1.0, 0.5, 0.25}, .error = {1.0}, .left_out = 1};
  for (const double size : {1.0, 0.5, 0.25}) refinement.error.push_back(3.0 * std::pow(size, 1.7));
  EXPECT_NEAR(fitted_order(refinement), 1.7, 1e-12);
  refinement.left_out = 0;
  EXPECT_GT(std::abs(fitted_order(refinement) - 1.7), 0.1);
}

TEST(RefinementTest, WhatHasNoOrderIsRefused) {
  for (const Refinement& bad :
       {Refinement{.name = "one", .size = {1.0}, .error = {1.0}},
        Refinement{.name = "none", .size = {1.0, 0.5}, .error = {1.0, 0.0}},
        Refinement{.name = "no number", .size = {1.0, 0.5}, .error = {1.0, std::nan("")}}})
    EXPECT_EQ(testing::refusal_of([&] { fitted_order(bad); }).code(), ExitCode::bad_input)
        << bad.name;
}

}  // namespace
}  // namespace rebound
