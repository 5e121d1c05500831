// Balls of FE with nothing hidden, drawn by a seed, against a believed lumped law: how many of them
// are said to lack something?
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <random>

#include "tests/cli/diagnosed_experiment.hpp"

namespace rebound::testing {
namespace {

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : bits_(seed) {}
  double between(double a, double b) {
    return a + (b - a) * static_cast<double>(bits_() >> 11) * 0x1p-53;
  }

 private:
  std::mt19937_64 bits_;
};

struct Material {
  const char* elastic;
  const char* further;
  double poisson_ratio;
  int branches;
  double ratio;  ///< largest, of all branches together
};
constexpr Material materials[] = {
    {"neo-hookean", "", 0.3, 1, 2.0},
    {"neo-hookean", "", 0.45, 1, 2.0},
    {"neo-hookean", "", 0.4, 2, 1.2},
    {"mooney-rivlin", "", 0.45, 1, 2.0},
    {"hyperfoam", "[[model.material.term]]\nweight = 1\nexponent = 4\n", 0.3, 1, 2.0},
    {"neo-hookean", "", 0.35, 1, 0.1}};  // hardly any loss

struct Experiment {
  std::string synthesis, believed;
};

/// Three speeds, highest over that of waves √(E/ρ) 0.06 to 0.16; branches fade in a hundredth to an
/// eighth of the contact; noise is 1 or 3 % of the smallest peak.
Experiment drawn(std::uint64_t seed) {
  Draw draw(seed);
  const Material& material = materials[seed % std::size(materials)];
  const double mass = draw.between(0.04, 0.12), radius = draw.between(0.022, 0.036);
  const double density = mass / (4.0 / 3.0 * std::numbers::pi * std::pow(radius, 3));
  const double fast = draw.between(12.0, 28.0), slow = fast / draw.between(3.0, 5.0);
  const double modulus = density * std::pow(fast / draw.between(0.06, 0.16), 2);
  const double nu = material.poisson_ratio;
  const double stiffness = 4.0 / 3.0 * modulus / (1.0 - nu * nu) * std::sqrt(radius);
  const double middle = std::sqrt(fast * slow);
  const double contact =
      3.21 * std::pow(mass * mass / (stiffness * stiffness * middle), 0.2);              // Hertz
  const double peak = stiffness * std::pow(1.25 * mass * slow * slow / stiffness, 0.6);  // Hertz
  std::string text = fmt::format(
      "schema = 1\nname = \"nothing {0}\"\nseed = {0}\n[sphere]\nmass = \"{1:.5g} g\"\n"
      "diameter = \"{2:.5g} mm\"\n[model]\ntier = \"fem\"\ncells = 2500\n[model.material]\n"
      "elastic = \"{3}\"\nyoungs_modulus = \"{4:.5g} MPa\"\npoisson_ratio = {5}\n"
      "modulus = \"long-term\"\n{6}",
      seed, 1e3 * mass, 2e3 * radius, material.elastic, 1e-6 * modulus, nu, material.further);
  for (int k = 0; k < material.branches; ++k)
    text +=
        fmt::format("[[model.material.branch]]\nratio = {:.4g}\nrelaxation_time = \"{:.4g} ms\"\n",
                    draw.between(0.25, 1.0) * material.ratio / material.branches,
                    1e3 * contact * (k == 0 ? draw.between(0.01, 0.03) : 0.08));
  text += fmt::format(
      "[instrument]\nforce_noise = \"{:.4g} N\"\nforce_gain_uncertainty = 0.01\n[sampling]\n"
      "rate = \"200 kHz\"\nbefore = \"0.3 ms\"\nafter = \"{:.3g} ms\"\n",
      (draw.between(0.0, 1.0) < 0.5 ? 0.01 : 0.03) * peak, 1e3 * (0.3 * contact + 3e-4));
  for (const double speed : {slow, middle, fast})
    text += fmt::format("[[shot]]\nspeed = \"{:.4f} m/s\"\nspeed_uncertainty = \"{:.3g} m/s\"\n",
                        speed, 0.004 * speed);
  return {text, fmt::format("schema = 1\n[model]\ntier = \"lumped\"\nlaw = \"hunt-crossley\"\n"
                            "stiffness = \"{:.4g} N/m^1.5\"\ndamping = \"{:.4g} N.s/m^2.5\"\n",
                            stiffness, 0.01 * stiffness)};
}

class BesideFemLong : public DiagnosedExperiment {};

TEST_F(BesideFemLong, OfFortyEightBallsThreeAtMostLackSomething) {
  constexpr int balls = 48, most = 3;
  int lacking = 0;
  for (int seed = 1; seed <= balls; ++seed) {
    const Experiment experiment = drawn(static_cast<std::uint64_t>(seed));
    const auto found = diagnosis_of(experiment.synthesis, experiment.believed);
    if (found["verdict"] == "agrees") continue;
    ++lacking;
    std::cout << fmt::format("seed {}: {}, family {}, gap {}\n", seed, found["verdict"].dump(),
                             found["family"].dump(), found["gap"]["before"].dump());
  }
  std::cout << fmt::format("{} of {} balls are said to lack something\n", lacking, balls);
  RecordProperty("lacking", lacking);
  EXPECT_LE(lacking, most);
}

}  // namespace
}  // namespace rebound::testing
