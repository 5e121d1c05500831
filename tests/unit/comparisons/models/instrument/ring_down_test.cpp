#include "comparisons/models/instrument/ring_down.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace rebound {
namespace {

/// A plate that has been ringing freely all along: the carried-on part can be
/// held against the same formula.
Trace ringing(const Plate& plate, double end, int samples) {
  const double omega = std::sqrt(plate.stiffness / plate.mass);
  Trace trace;
  std::vector<double> y;
  for (int i = 0; i <= samples; ++i) {
    const double t = end * i / samples;
    trace.time.push_back(t);
    y.push_back(1e-4 * std::sin(omega * t));
    trace.force.push_back(plate.stiffness * y.back());
  }
  trace.further = {{"plate_displacement_m", y}};
  return trace;
}

TEST(RingDownTest, KeepsItsEnergy) {
  const Plate plate{.stiffness = 5e7, .mass = 2.0, .damping_ratio = 0.0};
  const Trace before = ringing(plate, 1e-3, 400);
  const Trace after = with_ring_down(before, plate, 5e-3);
  EXPECT_GT(after.time.back(), 5.9e-3);
  const double omega = std::sqrt(plate.stiffness / plate.mass);
  for (std::size_t i = before.time.size(); i < after.time.size(); ++i)
    EXPECT_NEAR(after.force[i], 5e3 * std::sin(omega * after.time[i]), 5e3 * 1e-3);
}

TEST(RingDownTest, DampingTakesEnergy) {
  const Plate plate{.stiffness = 5e7, .mass = 2.0, .damping_ratio = 0.1};
  const Trace after = with_ring_down(ringing(plate, 1e-3, 400), plate, 20e-3);
  EXPECT_LT(std::abs(after.force.back()), 100.0);
}

// y = A e^{−ζωt} sin ω_d t; the cell reads its spring and its damper, k y + c ẏ.
TEST(RingDownTest, ADampedPlateIsReadByBothSpringAndDamper) {
  const Plate plate{.stiffness = 5e7, .mass = 2.0, .damping_ratio = 0.2};
  const double omega = std::sqrt(plate.stiffness / plate.mass), decay = 0.2 * omega;
  const double swing = std::sqrt(omega * omega - decay * decay);
  const double damping = 2.0 * decay * plate.mass;
  const auto y = [&](double t) { return 1e-4 * std::exp(-decay * t) * std::sin(swing * t); };
  const auto reading = [&](double t) {
    const double rate =
        1e-4 * std::exp(-decay * t) * (swing * std::cos(swing * t) - decay * std::sin(swing * t));
    return plate.stiffness * y(t) + damping * rate;
  };
  Trace trace;
  std::vector<double> displacement;
  for (int i = 0; i <= 400; ++i) {
    trace.time.push_back(5e-4 * i / 400);
    displacement.push_back(y(trace.time.back()));
    trace.force.push_back(reading(trace.time.back()));
  }
  trace.further = {{"plate_displacement_m", displacement}};
  const Trace after = with_ring_down(trace, plate, 3e-3);
  for (std::size_t i = trace.time.size(); i < after.time.size(); ++i)
    EXPECT_NEAR(after.force[i], reading(after.time[i]), 5e3 * 1e-3);
}

// Equal masses on equal springs: the slower mode has z/y = 0.618 and ω² = 0.382 k/m.
TEST(RingDownTest, APlateOnAFrameRingsInItsModes) {
  const Plate plate{.stiffness = 5e7,
                    .mass = 2.0,
                    .damping_ratio = 0.0,
                    .frame = {.stiffness = 5e7, .mass = 2.0, .damping_ratio = 0.0}};
  const double share = 0.5 * (std::sqrt(5.0) - 1.0), omega = share * std::sqrt(5e7 / 2.0);
  Trace trace;
  std::vector<double> y, z;
  for (int i = 0; i <= 400; ++i) {
    trace.time.push_back(1e-3 * i / 400);
    y.push_back(1e-4 * std::sin(omega * trace.time.back()));
    z.push_back(share * y.back());
    trace.force.push_back(5e7 * (y.back() - z.back()));
  }
  trace.further = {{"plate_displacement_m", y}, {"frame_displacement_m", z}};
  const Trace after = with_ring_down(trace, plate, 5e-3);
  const double amplitude = 5e3 * (1.0 - share);
  for (std::size_t i = trace.time.size(); i < after.time.size(); ++i)
    EXPECT_NEAR(after.force[i], amplitude * std::sin(omega * after.time[i]), amplitude * 2e-3);
}

TEST(RingDownTest, ARigidPlateIsLeftAlone) {
  const Trace before = ringing({.stiffness = 5e7, .mass = 2.0}, 1e-3, 100);
  EXPECT_EQ(with_ring_down(before, {}, 1e-3).time, before.time);
}

}  // namespace
}  // namespace rebound
