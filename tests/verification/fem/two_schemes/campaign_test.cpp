// Four cores at three speeds by both schemes: the stored table, and one of its
// cases run again.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tests/verification/fem/two_schemes/campaign.hpp"

namespace rebound::test {
namespace {

const std::filesystem::path folder = TWO_SCHEMES_FOLDER;

const std::set<std::string> compared = {"restitution",       "contact_time_1pct_s",
                                        "peak_force_N",      "peak_deflection_m",
                                        "mean_deflection_m", "rebound_speed_m_s"};

TEST(TwoSchemesCampaign, StoredSchemesAgreeWithinTheirBars) {
  std::set<std::pair<std::string, double>> cases;
  int held = 0, beyond = 0;
  for (const SchemePair& pair : read_campaign(folder / "table.csv")) {
    cases.insert({pair.core, pair.speed});
    if (!compared.contains(pair.quantity)) continue;
    ++held;
    beyond += pair.distance() > 1.0;
    EXPECT_LT(pair.distance(), 1.5)
        << pair.core << " " << pair.speed << " m/s " << pair.quantity << ": " << pair.explicit_value
        << " ± " << pair.explicit_bar << ", " << pair.implicit_value << " ± " << pair.implicit_bar;
    // Bars that cover everything would show nothing.
    const double widest = pair.quantity == "peak_force_N" ? 0.05 : 0.01;
    EXPECT_LT(pair.explicit_bar + pair.implicit_bar, widest * pair.explicit_value) << pair.quantity;
  }
  EXPECT_EQ(cases.size(), 12u);
  EXPECT_EQ(held, 72);
  EXPECT_LE(beyond, held / 20);
}

TEST(TwoSchemesCampaign, OneCaseOfTheTwelveAgain) {
  const auto stored = read_campaign(folder / "table.csv");
  const auto again = run_both(folder, "a", 25.0);
  std::size_t found = 0;
  for (const SchemePair& now : again)
    for (const SchemePair& then : stored) {
      if (then.core != now.core || then.speed != now.speed || then.quantity != now.quantity)
        continue;
      if (!compared.contains(now.quantity)) continue;
      ++found;
      EXPECT_LE(now.distance(), 1.0) << now.quantity;
      // Another processor rounds otherwise, and nodes then engage otherwise.
      EXPECT_NEAR(now.explicit_value / then.explicit_value, 1.0, 1e-3) << now.quantity;
      EXPECT_NEAR(now.implicit_value / then.implicit_value, 1.0, 1e-3) << now.quantity;
    }
  EXPECT_EQ(found, compared.size());
}

}  // namespace
}  // namespace rebound::test
