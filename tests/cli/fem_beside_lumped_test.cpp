// `diagnose` with a lumped model in doubt and data of the FE tier: what a body of finite size does
// by itself is no effect, and a name that FE has a form of is asked of FE too.
#include "tests/cli/diagnosed_experiment.hpp"

namespace rebound::testing {
namespace {

std::string experiment_of(const std::string& model, const std::string& noise) {
  return R"(schema = 1
name = "hidden"
seed = 5
[sphere]
mass = "89.6 g"
diameter = "66.2 mm"
)" + model +
         R"([instrument]
force_noise = ")" +
         noise +
         R"("
force_gain_uncertainty = 0.01
[sampling]
rate = "100 kHz"
before = "0.5 ms"
after = "3 ms"
[[shot]]
speed = "5 m/s"
speed_uncertainty = "0.02 m/s"
[[shot]]
speed = "10 m/s"
speed_uncertainty = "0.04 m/s"
[[shot]]
speed = "20 m/s"
speed_uncertainty = "0.08 m/s"
)";
}

std::string ball(const std::string& material) {
  return "[model]\ntier = \"fem\"\ncells = 3000\n[model.material]\nmodulus = \"long-term\"\n" +
         material;
}

std::string branch(const std::string& ratio, const std::string& time) {
  return "[[model.material.branch]]\nratio = " + ratio + "\nrelaxation_time = \"" + time + "\"\n";
}

class BesideFem : public DiagnosedExperiment {
 protected:
  nlohmann::json beside_lumped(const std::string& model, const std::string& noise = "15 N") {
    return diagnosis_of(experiment_of(model, noise), believed_lumped);
  }
  std::string page() const { return read_whole(folder.path() / "diagnosis/report.html"); }
};

/// Materials that no part of the diagnosis knows: another Poisson ratio, another elastic law, two
/// branches. The lumped model alone misses each by many times the noise.
TEST_F(BesideFem, ImpactsOfFemLackNothing) {
  const std::vector<std::string> balls = {
      ball("elastic = \"neo-hookean\"\nyoungs_modulus = \"9 MPa\"\npoisson_ratio = 0.25\n" +
           branch("1.2", "0.04 ms")),
      ball("elastic = \"mooney-rivlin\"\nyoungs_modulus = \"11 MPa\"\npoisson_ratio = 0.45\n" +
           branch("0.8", "0.05 ms")),
      ball("elastic = \"neo-hookean\"\nyoungs_modulus = \"10 MPa\"\npoisson_ratio = 0.4\n" +
           branch("0.5", "0.03 ms") + branch("0.2", "0.12 ms"))};
  for (const std::string& one : balls) {
    const auto found = beside_lumped(one);
    EXPECT_EQ(found["verdict"], "agrees") << found["warnings"];
    EXPECT_FALSE(found["fem_cells"].is_null());
    EXPECT_LT(found["gap"]["before"].get<double>(), 1.2);
    EXPECT_LT(found["gap"]["held_out_before"].get<double>(), 1.3);
    ASSERT_FALSE(found["law_alone"].is_null());
    EXPECT_GT(found["law_alone"]["gap"], found["gap"]["before"]);
    EXPECT_GT(found["law_alone"]["held_out"], found["gap"]["held_out_before"]);
    EXPECT_EQ(found["fem_balls"].size(), 1u);
    EXPECT_NE(page().find("The lumped law alone leaves"), std::string::npos);
  }
}

/// The lumped search finds the plate, with one of two effects beside it that make up for FE's part,
/// which is that of another ball. FE needs neither.
TEST_F(BesideFem, APlateUnderABallOfFemNeedsNothingBesideIt) {
  const auto found = beside_lumped(ball(
      "elastic = \"neo-hookean\"\nyoungs_modulus = \"10 MPa\"\npoisson_ratio = 0.3\n" +
      branch("1.0", "0.04 ms") +
      "[[model.effect]]\nname = \"plate-compliance\"\nsize = \"3e-8 m/N\"\nmass = \"6 kg\"\n"));
  EXPECT_EQ(found["verdict"], "family") << found["warnings"];
  EXPECT_EQ(found["family"], "dynamics");
  EXPECT_EQ(found["candidates"], nlohmann::json::parse(R"([["plate-compliance"]])"));
  EXPECT_GT(found["gap"]["before"].get<double>(), 2.0);
  EXPECT_LT(found["gap"]["after"].get<double>(), 1.2);
  EXPECT_LT(found["gap"]["held_out_after"], found["gap"]["held_out_before"]);
  EXPECT_GT(found["law_alone"]["gap"].get<double>(), 100.0);
  ASSERT_EQ(found["in_fem"].size(), 1u);
  const auto& plate = found["in_fem"][0];
  EXPECT_EQ(plate["tiers"]["fem"], "supported");
  EXPECT_NEAR(plate["size"].get<double>(), 3e-8, 1e-8);
  EXPECT_NE(page().find("The lumped law needs more beside it."), std::string::npos);
}

/// Four rings a contact: FE on a rigid plate follows nothing, and its own part is another one.
TEST_F(BesideFem, AStiffPlateUnderABallOfFemIsNamed) {
  const auto found = beside_lumped(
      ball("elastic = \"mooney-rivlin\"\nyoungs_modulus = \"10 MPa\"\npoisson_ratio = 0.45\n" +
           branch("1.0", "0.04 ms") +
           "[[model.effect]]\nname = \"plate-compliance\"\nsize = \"2e-9 m/N\"\nmass = \"1.5 "
           "kg\"\n"),
      "25 N");
  EXPECT_EQ(found["verdict"], "missing") << found["warnings"];
  ASSERT_EQ(found["effects"].size(), 1u);
  EXPECT_EQ(found["effects"][0]["name"], "plate-compliance");
  EXPECT_EQ(found["effects"][0]["tiers"]["fem"], "supported");
  EXPECT_GT(found["gap"]["before"].get<double>(), 5.0);
  EXPECT_LT(found["gap"]["after"].get<double>(), 1.2);
  EXPECT_LT(found["gap"]["held_out_after"].get<double>(), 1.3);
}

/// Mullins' softening is a curve of the largest strain of each point, which no lumped form has.
TEST_F(BesideFem, SofteningInFemIsOfItsFamily) {
  const auto found = beside_lumped(
      ball("elastic = \"neo-hookean\"\nyoungs_modulus = \"10 MPa\"\npoisson_ratio = 0.3\n" +
           branch("1.0", "0.04 ms") + "[[model.effect]]\nname = \"hysteresis\"\nsize = 0.5\n"),
      "8 N");  // quieter, and the rounding of an FE step decides how far its search comes
  EXPECT_EQ(found["verdict"], "family") << found["warnings"];
  EXPECT_EQ(found["family"], "history");
  EXPECT_EQ(found["candidates"].size(), 1u);
  EXPECT_GT(found["gap"]["before"].get<double>(), 2.0);
  EXPECT_LT(found["gap"]["after"].get<double>(), 1.2) << "a curve beside FE's own part has it";
  const double unseen_before = found["gap"]["held_out_before"].get<double>();
  EXPECT_LT(found["gap"]["held_out_after"].get<double>() - 1.0, 0.5 * (unseen_before - 1.0));
}

/// FE with nothing hidden follows the data within its errors; χ² of a thousand readings says no
/// more. One number that gains sixty does.
TEST_F(BesideFem, AWeakSofteningIsSeenBesideFesOwnBall) {
  const auto found = beside_lumped(
      ball("elastic = \"neo-hookean\"\nyoungs_modulus = \"10 MPa\"\npoisson_ratio = 0.3\n" +
           branch("1.0", "0.04 ms") + "[[model.effect]]\nname = \"hysteresis\"\nsize = 0.2\n"),
      "25 N");
  EXPECT_EQ(found["verdict"], "family") << found["warnings"];
  EXPECT_EQ(found["family"], "history");
  ASSERT_FALSE(found["in_fem"].empty());
  EXPECT_EQ(found["in_fem"][0]["name"], "hysteresis");
  EXPECT_NEAR(found["in_fem"][0]["size"].get<double>(), 0.2, 0.08);
  EXPECT_LT(found["gap"]["held_out_after"], found["gap"]["held_out_before"]);
  // Shot by shot it is the same gap, on the same cells.
  double samples = 0.0, before = 0.0, after = 0.0;
  for (const auto& shot : found["gap_of_shots_in_fem"]) {
    if (!shot["fitted"].get<bool>()) continue;
    const double own = shot["samples"].get<double>();
    samples += own;
    before += own * shot["before"].get<double>();
    after += own * shot["after"].get<double>();
  }
  ASSERT_GT(samples, 0.0);
  EXPECT_NEAR(before / samples / found["gap"]["before"].get<double>(), 1.0, 0.02);
  EXPECT_NEAR(after / samples / found["gap"]["after"].get<double>(), 1.0, 0.02);
}

/// A pull that reaches ahead of the surface: it outlasts the push, which no lumped pull does.
TEST_F(BesideFem, APullInFemIsOfTheSurface) {
  const auto found = beside_lumped(
      ball("elastic = \"mooney-rivlin\"\nyoungs_modulus = \"50 MPa\"\npoisson_ratio = 0.45\n" +
           branch("0.7", "0.02 ms") +
           "[[model.effect]]\nname = \"adhesion\"\nsize = \"2500 J/m^2\"\n"
           "range_over_radius = 0.055\n"),
      "60 N");
  EXPECT_EQ(found["family"], "surface") << found["verdict"] << found["warnings"];
  ASSERT_FALSE(found["in_fem"].empty());
  std::vector<std::string> keys;
  for (const auto& [key, value] : found["in_fem"][0].items()) keys.push_back(key);
  EXPECT_EQ(keys, (std::vector<std::string>{"family", "gap_after", "gap_before", "held_out_after",
                                            "held_out_before", "lumped_gap_after",
                                            "lumped_gap_before", "name", "size", "tiers", "unit"}));
  EXPECT_EQ(found["fem_with_nothing_hidden"]["gap"], found["in_fem"][0]["gap_before"]);
  EXPECT_NE(page().find("FE was asked of effects: with nothing hidden"), std::string::npos);
  EXPECT_EQ(found["in_fem"][0]["name"], "adhesion");
  EXPECT_EQ(found["in_fem"][0]["tiers"]["fem"], "supported");
  EXPECT_NEAR(found["in_fem"][0]["size"].get<double>(), 2500.0, 400.0);
}

/// Beside much noise a body of finite size and the lumped model are one ball: FE with nothing
/// hidden comes no nearer, and is asked for effects all the same.
TEST_F(BesideFem, APullBesideMuchNoiseIsOfTheSurface) {
  const auto found = beside_lumped(
      ball("elastic = \"neo-hookean\"\nyoungs_modulus = \"40 MPa\"\npoisson_ratio = 0.3\n" +
           branch("0.9", "0.01 ms") +
           "[[model.effect]]\nname = \"adhesion\"\nsize = \"3000 J/m^2\"\n"
           "range_over_radius = 0.05\n"),
      "100 N");
  EXPECT_EQ(found["verdict"], "family") << found["warnings"];
  EXPECT_EQ(found["family"], "surface") << found["in_fem"];
}

/// The plate rings a dozen times in a contact, and the noise is small: nothing lumped explains the
/// data, whatever plate it holds. FE with a plate does.
TEST_F(BesideFem, AQuietPlateOfManyRingsIsOfTheDynamics) {
  const auto found = beside_lumped(
      ball("elastic = \"mooney-rivlin\"\nyoungs_modulus = \"18 MPa\"\npoisson_ratio = 0.45\n"
           "second_share = 0.3\n" +
           branch("1.8", "0.034 ms") +
           "[[model.effect]]\nname = \"plate-compliance\"\nsize = \"2e-9 m/N\"\nmass = \"2.7 "
           "kg\"\n"),
      "8 N");
  EXPECT_EQ(found["family"], "dynamics") << found["verdict"] << found["warnings"];
  ASSERT_FALSE(found["in_fem"].empty());
  EXPECT_EQ(found["in_fem"][0]["name"], "plate-compliance");
  EXPECT_EQ(found["in_fem"][0]["tiers"]["fem"], "supported");
  EXPECT_GT(found["in_fem"][0]["gap_before"].get<double>(), 20.0);
  EXPECT_LT(found["in_fem"][0]["gap_after"].get<double>(), 1.5);
}

/// A fault of the measurement acts on the record of a ball of FE, which a lumped law misses by more
/// than the fault is.
TEST_F(BesideFem, ABurstOnTheRecordOfABallOfFemIsAFault) {
  const auto found = beside_lumped(
      ball("elastic = \"mooney-rivlin\"\nyoungs_modulus = \"40 MPa\"\npoisson_ratio = 0.45\n"
           "second_share = 0.3\n" +
           branch("1.2", "0.02 ms") +
           "[[model.effect]]\nname = \"burst\"\nsize = \"300 N\"\nfrequency = \"3 kHz\"\n"
           "decay_time = \"0.6 ms\"\ninstant = \"0.2 ms\"\n"),
      "60 N");
  EXPECT_EQ(found["verdict"], "measurement-fault") << found["warnings"];
  EXPECT_EQ(found["family"], "measurement") << found["in_fem"];
}

}  // namespace
}  // namespace rebound::testing
