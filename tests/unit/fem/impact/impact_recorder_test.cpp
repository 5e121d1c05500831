#include "fem/impact/impact_recorder.hpp"

#include <gtest/gtest.h>

#include "lumped/problem/scalars.hpp"
#include "tests/support/fem_cases.hpp"

namespace rebound::fem {
namespace {

void add_samples_until(ImpactRecorder& recorder, double end) {
  while (recorder.next_sample() < end) recorder.add_sample({}, {});
}

TEST(ImpactRecorderTest, TrapezoidGivesTheImpulseWhateverStepsAndBins) {
  for (const double interval : {0.003, 0.1, 0.37}) {
    test::Random random(11);
    ImpactRecorder recorder(interval, 5.0);
    double total = 0.0;
    double time = 0.0;
    for (int i = 0; i < 400; ++i) {
      const double step = random.between(1e-5, 0.03);
      const double impulse = i % 5 == 0 ? 0.0 : random.between(0.0, 2.0);
      recorder.add_impulse(impulse, time - 0.5 * step, time + 0.5 * step);
      total += impulse;
      time += step;
    }
    add_samples_until(recorder, time + 2.0 * interval);
    EXPECT_NEAR(recorder.total_impulse() / total, 1.0, 1e-13);
    const Trace trace = recorder.trace();
    EXPECT_NEAR(integral(trace.time, trace.force) / total, 1.0, 1e-12) << interval;
  }
}

TEST(ImpactRecorderTest, LoadCellIsTheForceAndContactStandsBesideIt) {
  ImpactRecorder recorder(1.0, 4.0, Reading::load_cell);
  recorder.add_impulse(2.0, 0.5, 1.5);
  recorder.add_reading(-3.0, 1.5, 2.5);
  for (int i = 0; i < 4; ++i) recorder.add_sample({.plate_displacement = 0.5 * i}, {});
  const Trace trace = recorder.trace();
  EXPECT_EQ(trace.force, (std::vector<double>{0, 0, -3, 0}));
  ASSERT_EQ(trace.further.size(), 4u);
  EXPECT_EQ(trace.further[2].name, "contact_force_N");
  EXPECT_EQ(trace.further[2].values, (std::vector<double>{0, 2, 0, 0}));
  EXPECT_EQ(trace.further[3].name, "plate_displacement_m");
  EXPECT_EQ(trace.further[3].values, (std::vector<double>{0, 0.5, 1, 1.5}));
  EXPECT_EQ(recorder.contact_force(), trace.further[2].values);
  EXPECT_EQ(recorder.total_impulse(), 2.0);
}

TEST(ImpactRecorderTest, EachSampleIsTheMeanOfItsBin) {
  ImpactRecorder recorder(1.0, 4.0);
  recorder.add_impulse(2.0, 0.0, 0.5);    // the first, half a bin long
  recorder.add_impulse(3.0, 1.25, 1.75);  // half before, half after 1.5
  add_samples_until(recorder, 3.5);
  const Trace trace = recorder.trace();
  ASSERT_EQ(trace.force.size(), 4u);
  EXPECT_DOUBLE_EQ(trace.force[0], 4.0);
  EXPECT_DOUBLE_EQ(trace.force[1], 1.5);
  EXPECT_DOUBLE_EQ(trace.force[2], 1.5);
  EXPECT_DOUBLE_EQ(trace.force[3], 0.0);
}

TEST(ImpactRecorderTest, ConstantForceIsRecordedAsConstant) {
  // 1/3 is no binary number: bin edges and step ends miss each other by rounding.
  ImpactRecorder recorder(1.0 / 3.0, 4.0);
  for (int i = 0; i < 1200; ++i) recorder.add_impulse(5.0 * 0.01, 0.01 * i, 0.01 * (i + 1));
  add_samples_until(recorder, 11.9);
  const Trace trace = recorder.trace();
  for (const double force : trace.force) EXPECT_NEAR(force, 5.0, 1e-11);
}

TEST(ImpactRecorderTest, ColumnsHaveOneLength) {
  ImpactRecorder recorder(0.5, 4.0);
  recorder.add_sample({.deflection = 1, .pole_deflection = 2, .contact_radius = 3}, {.stored = 4});
  const Trace trace = recorder.trace();
  EXPECT_EQ(trace.time, std::vector<double>{0.0});
  EXPECT_EQ(trace.deflection, std::vector<double>{1.0});
  ASSERT_EQ(trace.further.size(), 2u);
  EXPECT_EQ(trace.further[0].values, std::vector<double>{2.0});
  EXPECT_EQ(trace.further[1].values, std::vector<double>{3.0});
  ASSERT_EQ(recorder.energies().size(), 1u);
  EXPECT_EQ(recorder.energies()[0].stored, 4.0);
}

}  // namespace
}  // namespace rebound::fem
