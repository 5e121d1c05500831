#include "lumped/laws/laws.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "lumped/laws/blank_law.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

TEST(LawsTest, NamesAreUniqueAndFound) {
  std::set<std::string> names;
  for (const auto& card : all_laws()) {
    EXPECT_TRUE(names.insert(card.name).second) << card.name;
    EXPECT_EQ(find_law(card.name).equation, card.equation);
    EXPECT_FALSE(card.source.empty());
    for (const auto& parameter : card.parameters) EXPECT_FALSE(parameter.sentence.empty());
  }
}

TEST(LawsTest, UnknownNameListsTheLaws) {
  try {
    find_law("hertz");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::bad_input);
    EXPECT_NE(error.location().allowed.find("hunt-crossley"), std::string::npos);
  }
}

TEST(LawsTest, DampingParameterIsOnTheCard) {
  for (const auto& card : all_laws()) {
    bool found = card.damping_parameter.empty();
    for (const auto& p : card.parameters) found |= p.name == card.damping_parameter;
    EXPECT_TRUE(found) << card.name;
  }
}

// A law without loss has nothing to name; every other must, or the battery cannot see it.
TEST(LawsTest, LossParameterIsOnTheCard) {
  for (const auto& card : all_laws()) {
    bool found = false;
    for (const auto& p : card.parameters) found |= p.name == card.loss_parameter;
    EXPECT_TRUE(found) << card.name;
  }
}

TEST(EquivalentKelvinVoigtTest, ReducesToLinear) {
  const auto law = EquivalentKelvinVoigt::from({{"exponent", 1.0},
                                                {"stiffness", 2e5},
                                                {"damping", 50.0},
                                                {"representative_deflection", 1.0}});
  const LinearKelvinVoigt linear{.stiffness = 2e5, .damping = 50.0};
  EXPECT_EQ(law.force(3e-3, -4.0), linear.force(3e-3, -4.0));
}

// Table 4 of the sliotar paper, core A at 15 m/s: κ 3.5e6, λ 17.63e4,
// x_R 3.97 mm give 44.05 N s/m and 2.20e5 N/m as printed.
TEST(EquivalentKelvinVoigtTest, ReproducesTheTable) {
  const auto law = EquivalentKelvinVoigt::from({{"exponent", 1.5},
                                                {"stiffness", 3.5e6},
                                                {"damping", 17.63e4},
                                                {"representative_deflection", 3.97e-3}});
  EXPECT_NEAR(law.linear_damping, 44.05, 0.2);  // x_R rounded to 10 µm moves it by 0.17
  EXPECT_NEAR(law.linear_stiffness, 2.20e5, 0.01e5);
}

TEST(PowerLawTest, ContainsTheOthers) {
  const auto general = [](double n1, double n2, double damping) {
    return PowerLaw::from({{"stiffness", 3e6},
                           {"damping", damping},
                           {"damping_exponent", n1},
                           {"stiffness_exponent", n2}});
  };
  const LinearKelvinVoigt linear{.stiffness = 3e6, .damping = 50.0};
  const HertzDamped damped{.stiffness = 3e6, .damping = 700.0};
  const HuntCrossley hunt_crossley{.stiffness = 3e6, .damping = 2e5, .power = Power(1.5)};
  for (double v : {-9.0, 4.0}) {
    const double x = 2.5e-3;
    EXPECT_DOUBLE_EQ(general(0.0, 0.0, 50.0).force(x, v), linear.force(x, v));
    EXPECT_DOUBLE_EQ(general(0.5, 0.5, 700.0).force(x, v), damped.force(x, v));
    EXPECT_DOUBLE_EQ(general(1.5, 0.5, 2e5).force(x, v), hunt_crossley.force(x, v));
  }
}

TEST(PowerTest, HalvesAgreeWithGeneralPower) {
  for (double n : {0.0, 0.5, 1.0, 1.5, 2.0, 2.5, 1.3, 3.0})
    for (double x : {1e-9, 1e-4, 0.3, 2.0})
      EXPECT_NEAR(Power(n)(x) / std::pow(x, n), 1.0, 5e-16) << n << " " << x;
}

TEST(BlankLawTest, IsALawInNoList) {
  EXPECT_THROW(find_law(BlankLaw::card().name), Error);
  EXPECT_EQ(BlankLaw::from({{"stiffness", 2.0}, {"damping", 0.5}}).force(3.0, 1.0), 6.5);
}

}  // namespace
}  // namespace rebound
