#include "comparisons/discrepancy/diagnosis/record_numbers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "comparisons/discrepancy/diagnosis/noise_source.hpp"

namespace rebound {
namespace {

constexpr double mass = 0.1, speed = 10.0, pulse = 2e-3, noise = 10.0;

/// A ball on a spring without loss: F = F₀ sin(π t/T), F₀ = π m v/T, x = (v T/π) sin(π t/T).
MeasuredImpact half_sine() {
  MeasuredImpact shot;
  shot.sphere = {.mass = mass, .diameter = 0.06};
  shot.impact.speed = speed;
  for (int i = -40; i <= 240; ++i) {
    const double t = 1e-5 * i, phase = std::numbers::pi * t / pulse;
    const bool touches = t > 0.0 && t < pulse;
    shot.trace.time.push_back(t);
    shot.trace.force.push_back(touches ? std::numbers::pi * mass * speed / pulse * std::sin(phase)
                                       : 0.0);
    shot.trace.deflection.push_back(touches   ? speed * pulse / std::numbers::pi * std::sin(phase)
                                    : t > 0.0 ? -speed * (t - pulse)
                                              : speed * t);
  }
  shot.noise = {.deviation = noise, .zero_error = 1.0};
  shot.deflection_noise.deviation = 1e-5;
  return shot;
}

TEST(RecordNumbersTest, AHalfSineGivesItsClosedForms) {
  const MeasuredImpact shot = half_sine();
  const RecordReadings read = read_record(shot, 1);
  const double peak = std::numbers::pi * mass * speed / pulse;
  const auto value = [&](RecordNumber number) { return reading_of(read, number).value; };
  EXPECT_NEAR(value(RecordNumber::impulse), 2.0 * mass * speed, 1e-3);
  EXPECT_NEAR(value(RecordNumber::peak_force), peak, 1e-3 * peak);
  const double width = pulse * (1.0 - 2.0 * std::asin(0.3) / std::numbers::pi);
  EXPECT_NEAR(value(RecordNumber::width), width, 5e-3 * width);
  EXPECT_NEAR(value(RecordNumber::contact_time), pulse,
              reading_of(read, RecordNumber::contact_time).error());
  EXPECT_NEAR(value(RecordNumber::work), 0.0, 1e-6);
  EXPECT_NEAR(value(RecordNumber::peak_deflection), speed * pulse / std::numbers::pi, 1e-5);
  EXPECT_NEAR(value(RecordNumber::force_over_inertia), 1.0, 2e-3);
  EXPECT_NEAR(value(RecordNumber::approach_speed), speed, 2e-3 * speed);
}

// 100 draws know the scatter to a tenth, 200 repeats to a fourteenth.
TEST(RecordNumbersTest, ScatterIsThatOfRepeats) {
  for (const std::vector<double>& colour : {std::vector<double>{}, std::vector<double>{0.7}}) {
    MeasuredImpact shot = half_sine();
    shot.noise.autocorrelation = colour;
    shot.deflection_noise.autocorrelation = colour;
    NoiseSource force(shot.noise, 5), deflection(shot.deflection_noise, 6);
    const RecordReadings clean = read_record(shot, 1);
    std::array<double, record_numbers> squares{};
    constexpr int repeats = 200;
    for (int k = 0; k < repeats; ++k) {
      MeasuredImpact repeat = shot;
      repeat.trace.force = force.added_to(shot.trace.force);
      repeat.trace.deflection = deflection.added_to(shot.trace.deflection);
      const RecordReadings read = read_record(repeat, 1);
      for (std::size_t i = 0; i < record_numbers; ++i)
        squares[i] += std::pow(read[i].value - clean[i].value, 2) / repeats;
    }
    for (std::size_t i = 0; i < record_numbers; ++i)
      EXPECT_NEAR(std::sqrt(squares[i]) / clean[i].scatter, 1.0, 0.35) << "number " << i;
  }
}

TEST(RecordNumbersTest, DrawnNoiseHasItsSizeAndColour) {
  constexpr std::size_t count = 20000;
  NoiseSource source({.deviation = 3.0, .autocorrelation = {0.6}}, 9);
  const std::vector<double> drawn = source.added_to(std::vector<double>(count, 0.0));
  double square = 0.0, product = 0.0;
  for (std::size_t i = 1; i < count; ++i) {
    square += drawn[i] * drawn[i];
    product += drawn[i] * drawn[i - 1];
  }
  EXPECT_NEAR(std::sqrt(square / count), 3.0, 0.15);
  EXPECT_NEAR(product / square, 0.6, 0.03);
}

}  // namespace
}  // namespace rebound
