#include <gtest/gtest.h>

#include <cmath>

#include "fem/interface/check_problem.hpp"
#include "fem/interface/engineering_moduli.hpp"
#include "tests/unit/comparisons/evaluation/export/deck_cases.hpp"

namespace rebound {
namespace {

using namespace deck_tests;

TEST(DeckTest, EveryTargetSaysWhatIsNotTheSame) {
  for (const ExportTarget& target : export_targets()) {
    const ExportedDeck deck =
        deck_for(target.name, problem_of(ElasticModel::neo_hookean_isochoric));
    EXPECT_FALSE(deck.differences.empty());
    for (const std::string& difference : deck.differences)
      EXPECT_LT(deck.text.find(difference), 1500u) << target.name << ": " << difference;
    EXPECT_NE(deck.text.find(target.code), std::string::npos);
  }
  EXPECT_THROW(export_target("nastran"), Error);
}

TEST(DeckTest, CalculixNumbers) {
  const ExportedDeck deck = deck_for("calculix", problem_of(ElasticModel::neo_hookean_isochoric));
  EXPECT_EQ(deck.elements, static_cast<int>(mesh().cells.size()));
  // C₁₀ = μ/2, D₁ = 2/K.
  const auto law = numbers_below(deck.text, "*HYPERELASTIC, NEO HOOKE");
  ASSERT_EQ(law.size(), 2u);
  EXPECT_NEAR(law[0], 10e6 / 5.6, 1e-3);
  EXPECT_NEAR(law[1], 1.2e-7, 1e-17);
  const double density = 0.0896 / (4.0 / 3.0 * M_PI * std::pow(0.0331, 3));
  EXPECT_NEAR(numbers_below(deck.text, "*DENSITY")[0] / density, 1.0, 2e-4);
  EXPECT_NE(deck.text.find("BALL, 3, -15\n"), std::string::npos);
  // Fields are cut off after twenty characters.
  std::istringstream fields(deck.text.substr(deck.text.find("*NODE")));
  for (std::string line; std::getline(fields, line) && !line.starts_with("*ELEMENT");) {
    std::istringstream parts(line);
    for (std::string part; std::getline(parts, part, ',');) EXPECT_LE(part.size(), 20u) << line;
  }
}

TEST(DeckTest, EndTimeIsGivenOrOfTheRelaxedBall) {
  FemProblem problem = problem_of(ElasticModel::neo_hookean_isochoric);
  const double elastic = fem::expected_contact_time(problem, fem::given_moduli(problem.material));
  const ExportedDeck deck = deck_for("calculix", problem);
  EXPECT_DOUBLE_EQ(deck.end_time, 1.25 * elastic);
  const auto step = numbers_below(deck.text, "*DYNAMIC");
  EXPECT_NEAR(step[0] / (elastic / 400.0), 1.0, 1e-9);
  EXPECT_NEAR(step[1] / deck.end_time, 1.0, 1e-9);
  problem.controls.end_time = 3e-3;
  problem.controls.output_interval = 1e-5;
  const auto asked = numbers_below(deck_for("calculix", problem).text, "*DYNAMIC");
  EXPECT_DOUBLE_EQ(asked[0], 5e-6);
  EXPECT_DOUBLE_EQ(asked[1], 3e-3);
  // E∞ = E/2: 2^(2/5) times as long.
  problem.controls = {};
  problem.material.branches = {{.ratio = 0.5, .relaxation_time = 1e-3}};
  EXPECT_NEAR(deck_for("abaqus", problem).end_time / deck.end_time, std::pow(2.0, 0.4), 1e-12);
}

TEST(DeckTest, LawsOfStretches) {
  const double mu = 10e6 / 2.8, half = 0.5 * mu;
  const auto ogden = numbers_below(deck_for("calculix", problem_of(ElasticModel::ogden)).text,
                                   "*HYPERELASTIC, OGDEN, N=2");
  const std::vector<double> expected_ogden = {half, 2.0, half, -3.0, 1.2e-7, 1.0};
  ASSERT_EQ(ogden.size(), expected_ogden.size());
  for (std::size_t i = 0; i < ogden.size(); ++i)
    EXPECT_NEAR(ogden[i], expected_ogden[i], 1e-10 * std::abs(expected_ogden[i]));
  const auto foam = numbers_below(deck_for("abaqus", problem_of(ElasticModel::hyperfoam)).text,
                                  "*HYPERFOAM, N=2");
  const std::vector<double> expected_foam = {half, 2.0, half, -3.0, 0.4, 0.4};
  ASSERT_EQ(foam.size(), expected_foam.size());
  for (std::size_t i = 0; i < foam.size(); ++i)
    EXPECT_NEAR(foam[i], expected_foam[i], 1e-10 * std::abs(expected_foam[i]));
  const std::string febio = deck_for("febio", problem_of(ElasticModel::ogden)).text;
  EXPECT_NEAR(value_of(febio, "c2"), mu, 1e-6);  // 2 μ₂
  EXPECT_EQ(value_of(febio, "m2"), -3.0);
  EXPECT_EQ(value_of(febio, "pressure_model"), 1.0);
}

TEST(DeckTest, AnotherEnergyIsSaid) {
  const auto said = [](const char* target, ElasticModel elastic) {
    return deck_for(target, problem_of(elastic)).differences.size() -
           export_target(target).always_different.size();
  };
  EXPECT_EQ(said("calculix", ElasticModel::neo_hookean_isochoric), 0u);
  EXPECT_EQ(said("calculix", ElasticModel::hyperfoam), 0u);
  EXPECT_EQ(said("calculix", ElasticModel::neo_hookean), 1u);
  EXPECT_EQ(said("abaqus", ElasticModel::mooney_rivlin), 1u);
  for (const ElasticModel elastic : {ElasticModel::neo_hookean, ElasticModel::neo_hookean_isochoric,
                                     ElasticModel::mooney_rivlin, ElasticModel::ogden})
    EXPECT_EQ(said("febio", elastic), 0u);
  EXPECT_EQ(refused_key("febio", problem_of(ElasticModel::hyperfoam)), "model.material.elastic");
}

// Long-term ratio 1: μ₀ = 2 μ∞, half of it relaxes; both codes take the instantaneous state.
TEST(DeckTest, PronySeries) {
  FemProblem problem = problem_of(ElasticModel::neo_hookean);
  problem.material.modulus = ModulusBasis::long_term;
  problem.material.branches = {{.ratio = 1.0, .relaxation_time = 3e-4}};
  const std::string abaqus = deck_for("abaqus", problem).text;
  const auto prony = numbers_below(abaqus, "*VISCOELASTIC, TIME=PRONY");
  EXPECT_EQ(prony, (std::vector<double>{0.5, 0.5, 3e-4}));
  EXPECT_NEAR(numbers_below(abaqus, "*HYPERELASTIC, NEO HOOKE, MODULI=INSTANTANEOUS")[0],
              20e6 / 5.6, 1e-3);
  const std::string febio = deck_for("febio", problem).text;
  EXPECT_NEAR(value_of(febio, "g0"), 0.5, 1e-14);
  EXPECT_NEAR(value_of(febio, "g1"), 0.5, 1e-14);
  EXPECT_EQ(value_of(febio, "t1"), 3e-4);
  EXPECT_NEAR(value_of(febio, "E"), 20e6, 1e-3);
}

// FEBio relaxes all of a coupled law, and the deviator of an uncoupled one.
TEST(DeckTest, RelaxationOfTheOtherKindIsRefused) {
  FemProblem problem = problem_of(ElasticModel::neo_hookean);
  problem.material.poisson_ratio = 0.3;
  problem.material.branches = {{.ratio = 0.3, .relaxation_time = 3e-4}};
  EXPECT_EQ(refused_key("calculix", problem), "model.material.branch");
  EXPECT_EQ(refused_key("febio", problem), "nothing refused");
  problem.material.elastic = ElasticModel::neo_hookean_isochoric;
  EXPECT_EQ(refused_key("febio", problem), "model.material.branch.relaxes");
  problem.material.branches[0].relaxes = Relaxes::deviator;
  EXPECT_EQ(refused_key("febio", problem), "nothing refused");
  problem.material.elastic = ElasticModel::neo_hookean;
  EXPECT_EQ(refused_key("febio", problem), "model.material.branch.relaxes");
}

TEST(DeckTest, FenicsxNumbers) {
  FemProblem problem = problem_of(ElasticModel::neo_hookean);
  EXPECT_EQ(refused_key("fenicsx", problem), "nothing refused");
  const auto holds = [&](const char* words) {
    return deck_for("fenicsx", problem).text.find(words) != std::string::npos;
  };
  EXPECT_TRUE(holds("MEAN_DILATATION = False"));
  EXPECT_TRUE(holds("mu, K = 3571428.57142857, 16666666.6666667"));
  problem.material.branches = {{.ratio = 0.3, .relaxation_time = 5e-4}};
  EXPECT_TRUE(holds("BRANCHES = [(0.3, 0.3, 0.0005), ]"));
  problem.material.branches[0].relaxes = Relaxes::deviator;
  EXPECT_TRUE(holds("BRANCHES = [(0.3, 0, 0.0005), ]"));
  problem.material.poisson_ratio = 0.449;  // 0.464 once relaxed
  EXPECT_TRUE(holds("MEAN_DILATATION = True"));
  problem.plate.friction = 0.3;
  EXPECT_EQ(refused_key("fenicsx", problem), "model.plate.friction");
}

TEST(DeckTest, LostPhysicsIsRefusedByName) {
  const auto with = [](const auto& change) {
    FemProblem problem = problem_of(ElasticModel::neo_hookean);
    change(problem);
    return problem;
  };
  const std::pair<const char*, FemProblem> lost[] = {
      {"model.material.mullins", with([](auto& p) { p.material.strain.mullins = 0.3; })},
      {"model.material.strain_softening", with([](auto& p) { p.material.strain.softening = 0.3; })},
      {"model.material.strain_stiffening", with([](auto& p) { p.material.strain.stiffening = 1; })},
      {"model.material.densification", with([](auto& p) { p.material.strain.densification = 1; })},
      {"model.material.retardation_time",
       with([](auto& p) { p.material.retardation_time = 1e-6; })},
      {"model.material.layer", with([](auto& p) { p.material.layers = {{.modulus_factor = 2}}; })},
      {"model.material.relaxation", with([](auto& p) {
         p.material.branches = {{.ratio = 0.3, .relaxation_time = 1e-3}};
         p.material.relaxation = Relaxation::multiplicative;
       })},
      {"model.material.branch.rate_exponent", with([](auto& p) {
         p.material.branches = {{.ratio = 0.3, .relaxation_time = 1e-3, .rate_exponent = 0.5}};
       })},
      {"model.adhesion.work", with([](auto& p) { p.adhesion.work = 20.0; })},
      {"model.plate.stiffness", with([](auto& p) { p.plate.stiffness = 1e8; })}};
  for (const ExportTarget& target : export_targets())
    for (const auto& [key, problem] : lost)
      EXPECT_EQ(refused_key(target.name, problem), key) << target.name;
}

TEST(DeckTest, FrictionAndGravityWhereTheyAreWritten) {
  FemProblem rough = problem_of(ElasticModel::neo_hookean), heavy = rough;
  rough.plate.friction = 0.3;
  heavy.gravity = 9.81;
  EXPECT_EQ(refused_key("calculix", rough), "model.plate.friction");
  EXPECT_EQ(refused_key("febio", rough), "model.plate.friction");
  EXPECT_EQ(refused_key("febio", heavy), "impact.gravity");
  EXPECT_EQ(numbers_below(deck_for("abaqus", rough).text, "*FRICTION")[0], 0.3);
  EXPECT_NE(deck_for("calculix", heavy).text.find("GRAV, 9.81, 0, 0, -1\n"), std::string::npos);
  EXPECT_NE(deck_for("abaqus", heavy).text.find("GRAV, 9.81, 0, -1\n"), std::string::npos);
}

TEST(DeckTest, AbaqusAndFebioMeshes) {
  const FemProblem problem = problem_of(ElasticModel::neo_hookean);
  const ExportedDeck abaqus = deck_for("abaqus", problem);
  EXPECT_EQ(abaqus.elements, static_cast<int>(mesh().cells.size()));
  EXPECT_EQ(abaqus.nodes, static_cast<int>(mesh().vertices.size()));
  const std::string sides = abaqus.text.substr(
      abaqus.text.find("BALL_SIDE"), abaqus.text.find("RAX2") - abaqus.text.find("BALL_SIDE"));
  EXPECT_EQ(count_of(sides, ", S"), static_cast<int>(mesh().contact_edges.size()));
  const ExportedDeck febio = deck_for("febio", problem);
  EXPECT_EQ(febio.elements, 4 * static_cast<int>(mesh().cells.size()));
  EXPECT_EQ(count_of(febio.text, "<elem id="), febio.elements + 1);
  EXPECT_EQ(count_of(febio.text, "<node id="), febio.nodes + 8);
  EXPECT_EQ(count_of(febio.text, "<quad8"), 4 * static_cast<int>(mesh().contact_edges.size()));
}

}  // namespace
}  // namespace rebound
