#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "comparisons/inference/references/contact_alone.hpp"
#include "comparisons/inference/references/measured_impacts.hpp"
#include "comparisons/inference/references/read_references.hpp"
#include "comparisons/io/dataset/dataset.hpp"
#include "comparisons/io/results/result_folder.hpp"
#include "comparisons/io/results/trace_csv.hpp"
#include "comparisons/io/toml/describe_lumped.hpp"
#include "comparisons/io/toml/toml_writer.hpp"
#include "lumped/integration/simulate.hpp"
#include "lumped/problem/error.hpp"
#include "tests/support/lumped_cases.hpp"
#include "tests/support/temporary_folder.hpp"

namespace rebound {
namespace {

/// A half-sine of force whose impulse returns the ball at e = 0.6, with a
/// quiet millisecond on either side.
Dataset half_sine(double e = 0.6) {
  Dataset dataset;
  dataset.name = "synthetic";
  dataset.sphere = test::core_a();
  MeasuredImpact shot;
  shot.impact.speed = 10.0;
  const double duration = 2e-3, impulse = dataset.sphere.mass * shot.impact.speed * (1.0 + e);
  const double peak = 0.5 * std::numbers::pi * impulse / duration;
  Trace trace;
  for (int i = -500; i <= 1500; ++i) {
    const double t = 2e-6 * i;
    const bool touching = t > 0.0 && t < duration;
    trace.time.push_back(t + 5e-3);
    trace.force.push_back(touching ? peak * std::sin(std::numbers::pi * t / duration) : 0.0);
  }
  shot.trace = trace;
  dataset.shots = {shot};
  return dataset;
}

TEST(ContactAloneTest, FindsContactAndIntegratesDeflection) {
  const Dataset dataset = half_sine();
  const MeasuredImpact shot = contact_alone(completed(dataset, dataset.shots[0]));
  EXPECT_EQ(shot.trace.time.front(), 0.0);
  EXPECT_NEAR(shot.scalars.contact_time, 2e-3, 4e-6);
  EXPECT_NEAR(shot.scalars.restitution, 0.6, 1e-5);
  // x(t) = v₀ t − (J/2m) (t − (T/π) sin(π t/T)), J the impulse; at t = T it is
  // v₀ T (1 − (1 + e)/2).
  EXPECT_NEAR(shot.trace.deflection.back(), 10.0 * 2e-3 * 0.2, 1e-7);
}

TEST(ContactAloneTest, ThresholdCutsTheContact) {
  Dataset dataset = half_sine();
  const double peak = 0.5 * std::numbers::pi * 0.0896 * 10.0 * 1.6 / 2e-3;
  dataset.instrument.contact_threshold = 0.5 * peak;  // sin > ½ over two thirds
  EXPECT_NEAR(contact_alone(completed(dataset, dataset.shots[0])).scalars.contact_time, 4e-3 / 3.0,
              6e-6);
  dataset.instrument.contact_threshold = 2.0 * peak;
  EXPECT_THROW(contact_alone(completed(dataset, dataset.shots[0])), Error);
}

TEST(ContactAloneTest, KeepsWhatWasMeasured) {
  Dataset dataset = half_sine();
  dataset.shots[0].restitution.value = 0.55;
  dataset.instrument.force_noise = 7.0;
  const MeasuredImpact shot = contact_alone(completed(dataset, dataset.shots[0]));
  EXPECT_EQ(shot.scalars.restitution, 0.55);
  EXPECT_EQ(shot.noise.deviation, 7.0);
}

TEST(ContactAloneTest, RefusesAnImpulseThatCannotBe) {
  for (double e : {-0.2, 1.3}) {
    const Dataset dataset = half_sine(e);
    EXPECT_THROW(contact_alone(completed(dataset, dataset.shots[0])), Error) << e;
  }
}

LumpedResult write_example(const std::filesystem::path& folder) {
  const LumpedProblem problem = test::typical_problem("hunt-crossley");
  const LumpedResult result = simulate(problem);
  write_result({.folder = folder, .effective_toml = write_toml(problem), .provenance = {}}, result);
  return result;
}

TEST(ReadReferencesTest, GivesBackAResultFolder) {
  const testing::TemporaryFolder temporary;
  const LumpedResult written = write_example(temporary.path());
  const auto references = read_references(temporary.path());
  ASSERT_EQ(references.size(), 1u);
  const MeasuredImpact& shot = references[0];
  EXPECT_EQ(shot.trace.force, written.trace.force);
  EXPECT_EQ(shot.trace.deflection, written.trace.deflection);
  EXPECT_EQ(shot.scalars.restitution, written.scalars.restitution);
  EXPECT_EQ(shot.scalars.mean_deflection, written.scalars.mean_deflection);
  EXPECT_EQ(shot.sphere.mass, 0.0896);
  EXPECT_EQ(shot.impact.speed, 15.0);
}

TEST(ReadReferencesTest, BelievesAResultFolderOnlyWhenItAgrees) {
  const testing::TemporaryFolder temporary;
  write_example(temporary.path());
  const std::string toml = testing::read_whole(temporary.path() / "effective.toml");
  std::string other = toml;
  other.replace(other.find("15 m/s"), 6, "14 m/s");
  temporary.write("effective.toml", other);
  const auto code = [&] {
    try {
      read_references(temporary.path());
    } catch (const Error& error) {
      return error.code();
    }
    return ExitCode::done;
  };
  EXPECT_EQ(code(), ExitCode::corrupt_store);
  temporary.write("effective.toml", toml);
  EXPECT_EQ(code(), ExitCode::done);
  temporary.write("result.json", "{\"schema\": 1");
  EXPECT_EQ(code(), ExitCode::corrupt_store);
}

TEST(ReadReferencesTest, ReadsTheTracesOfADataSet) {
  const testing::TemporaryFolder temporary;
  const LumpedResult run = simulate(test::typical_problem("hunt-crossley"));
  temporary.write("shot.csv", trace_csv(run.trace));
  temporary.write(
      "dataset.toml",
      "schema = 1\nname = \"bench\"\n[sphere]\nmass = \"89.6 g\"\ndiameter = \"66.2 mm\"\n"
      "[[shot]]\nspeed = \"15 m/s\"\ntrace = \"shot.csv\"\n"
      "[[shot]]\nspeed = \"5 m/s\"\nrestitution = 0.6\n");
  const auto references = read_references(temporary.path());
  ASSERT_EQ(references.size(), 1u);  // the second shot has no trace
  EXPECT_NEAR(references[0].scalars.restitution, run.scalars.restitution, 1e-4);
  EXPECT_NEAR(references[0].scalars.peak_force, run.scalars.peak_force, 1e-3);
  EXPECT_FALSE(references[0].restitution.value.has_value());
}

TEST(MeasuredScalarsTest, WhatIsAssumedIsAShareOfAContactTimeAndIsSaid) {
  const testing::TemporaryFolder temporary;
  temporary.write(
      "dataset.toml",
      "schema = 1\nname = \"bench\"\n[sphere]\nmass = \"89.6 g\"\ndiameter = \"66.2 mm\"\n"
      "[[shot]]\nspeed = \"15 m/s\"\nrestitution = 0.6\ncontact_time = \"1.4 ms\"\n"
      "[[shot]]\nspeed = \"5 m/s\"\nrestitution = 0.7\nrestitution_uncertainty = 0.02\n"
      "contact_time = \"1.7 ms\"\ncontact_time_uncertainty = \"0.1 ms\"\n");
  const auto impacts =
      measured_scalars(temporary.path(), {.restitution = 0.03, .contact_time = 0.05});
  ASSERT_EQ(impacts.size(), 2u);
  EXPECT_NEAR(*impacts[0].contact_time.uncertainty, 0.05 * 1.4e-3, 1e-12);
  EXPECT_EQ(*impacts[0].restitution.uncertainty, 0.03);
  EXPECT_EQ(impacts[0].assumed.size(), 2u);
  EXPECT_NEAR(*impacts[1].contact_time.uncertainty, 1e-4, 1e-12);
  EXPECT_EQ(*impacts[1].restitution.uncertainty, 0.02);
  EXPECT_TRUE(impacts[1].assumed.empty());
}

TEST(ReadReferencesTest, NamesWhatIsWrong) {
  const testing::TemporaryFolder temporary;
  try {
    read_references(temporary.path());
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::bad_input);
  }
  try {
    read_references(temporary.path() / "nothing");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::input_output_failed);
  }
}

}  // namespace
}  // namespace rebound
