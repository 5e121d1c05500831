// Many fits side by side, and impacts that are kept between them.
#include "comparisons/discrepancy/diagnosis/fits/each_fit.hpp"

#include <gtest/gtest.h>

namespace rebound {
namespace {

TEST(EachFitTest, AFitWithoutAnAnswerIsLeftEmpty) {
  const auto fits = fit_each<int>(3, {}, [](std::size_t i) {
    if (i == 1) throw Error(ExitCode::solver_failed, "no answer");
    return static_cast<int>(10 * i);
  });
  ASSERT_EQ(fits.size(), 3u);
  EXPECT_EQ(fits[0], 0);
  EXPECT_FALSE(fits[1].has_value());
  EXPECT_EQ(fits[2], 20);
}

/// A search that came back to numbers without an impact once found an empty one there, and read it.
TEST(EachFitTest, AnErrorIsNotKept) {
  std::map<std::vector<double>, std::vector<int>> kept;
  int asked = 0;
  const auto ask = [&]() -> std::vector<int> {
    if (++asked < 3) throw Error(ExitCode::solver_failed, "the ball does not come back");
    return {7};
  };
  for (int i = 0; i < 2; ++i) EXPECT_THROW(kept_answer(kept, {1.0, 2.0}, ask), Error);
  EXPECT_TRUE(kept.empty());
  EXPECT_EQ(kept_answer(kept, {1.0, 2.0}, ask), std::vector<int>{7});
  EXPECT_EQ(kept_answer(kept, {1.0, 2.0}, ask), std::vector<int>{7});
  EXPECT_EQ(asked, 3) << "an answer is kept";
}

}  // namespace
}  // namespace rebound
