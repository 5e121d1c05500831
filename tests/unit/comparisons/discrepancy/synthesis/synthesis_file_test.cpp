#include "comparisons/discrepancy/synthesis/synthesis_file.hpp"

#include <gtest/gtest.h>

#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

const std::string head = R"(schema = 1
[sphere]
mass = "89.6 g"
diameter = "66.2 mm"
[model]
tier = "lumped"
law = "hunt-crossley"
stiffness = "3.5e6 N/m^1.5"
damping = "8e4 N.s/m^2.5"
)";

TEST(SynthesisFileTest, APlainImpactFileIsOne) {
  const auto file = read_synthesis(Document::parse(head + "[impact]\nspeed = \"15 m/s\"\n", "f"));
  ASSERT_EQ(file.shots.size(), 1u);
  EXPECT_EQ(file.shots[0].speed, 15.0);
  EXPECT_EQ(file.lumped.parameters.at("stiffness"), 3.5e6);
}

TEST(SynthesisFileTest, TheWholeInstrumentIsRead) {
  const auto file = read_synthesis(Document::parse(
      head + "[[shot]]\nspeed = \"15 m/s\"\n[sampling]\ntrigger_jitter = \"0.02 ms\"\n"
             "[random]\ncount = 1\n[instrument]\nforce_noise = \"5 N\"\ncamera_rate = \"4000 Hz\"\n"
             "noise_correlation_time = \"0.01 ms\"\nforce_filter_class = \"1000 Hz\"\n",
      "f"));
  EXPECT_EQ(file.sampling.trigger_jitter, 20e-6);
  EXPECT_EQ(*file.instrument.noise_correlation_time, 10e-6);
  EXPECT_EQ(*file.instrument.force_filter_class, 1000.0);
  EXPECT_EQ(*file.instrument.camera_rate, 4000.0);
  EXPECT_EQ(file.effects.size(), 1u);
}

TEST(SynthesisFileTest, AnFeModelIsRead) {
  const auto file = read_synthesis(Document::parse(
      "schema = 1\n[sphere]\nmass = \"89.6 g\"\ndiameter = \"66.2 mm\"\n[model]\ntier = \"fem\"\n"
      "[model.material]\nelastic = \"neo-hookean\"\nyoungs_modulus = \"10 MPa\"\npoisson_ratio = "
      "0.4\n"
      "[[model.effect]]\nname = \"relaxation\"\nsize = 0.3\n[[shot]]\nspeed = \"5 m/s\"\n",
      "f"));
  EXPECT_EQ(file.tier, Tier::fem);
  EXPECT_EQ(file.fem.material.youngs_modulus, 10e6);
  ASSERT_EQ(file.effects.size(), 1u);
  EXPECT_EQ(file.effects[0].size, 0.3);
}

TEST(SynthesisFileTest, NothingSeenIsRefusedWithThePlace) {
  try {
    read_synthesis(Document::parse(
        head + "[[shot]]\nspeed = \"5 m/s\"\n[[shot]]\nspeed = \"15 m/s\"\nhistory = false\n",
        "f.toml"));
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.location().key, "shot[1]");
    EXPECT_EQ(error.location().file, "f.toml");
  }
}

TEST(SynthesisFileTest, NoShotsAreRefused) {
  EXPECT_THROW(read_synthesis(Document::parse(head, "f")), Error);
}

TEST(SynthesisFileTest, AnUnknownEffectIsRefused) {
  EXPECT_THROW(
      read_synthesis(Document::parse(
          head +
              "[[model.effect]]\nname = \"relaxtion\"\nsize = 0.1\n[[shot]]\nspeed = \"5 m/s\"\n",
          "f")),
      Error);
}

}  // namespace
}  // namespace rebound
