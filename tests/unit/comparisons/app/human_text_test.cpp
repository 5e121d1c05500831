#include "comparisons/app/human_text.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <sstream>

namespace rebound {
namespace {

TEST(HumanText, TimesAreSaidInTwoUnitsAtMost) {
  EXPECT_EQ(duration_text(0.0658), "0.066 s");
  EXPECT_EQ(duration_text(9.94), "9.9 s");
  EXPECT_EQ(duration_text(45.2), "45 s");
  EXPECT_EQ(duration_text(59.4), "59 s");
  EXPECT_EQ(duration_text(59.6), "1 min");
  EXPECT_EQ(duration_text(200.0), "3 min 20 s");
  EXPECT_EQ(duration_text(3599.7), "1 h");
  EXPECT_EQ(duration_text(7500.0), "2 h 5 min");
  EXPECT_EQ(duration_text(86399.0), "1 d");
  EXPECT_EQ(duration_text(4.3 * 86400.0), "4 d 7 h");
  EXPECT_EQ(duration_text(std::numeric_limits<double>::infinity()), "an unknown time");
}

TEST(HumanText, CountsOfFiveDigitsAreGrouped) {
  EXPECT_EQ(count_text(0), "0");
  EXPECT_EQ(count_text(4096), "4096");
  EXPECT_EQ(count_text(12400), "12 400");
  EXPECT_EQ(count_text(123456), "123 456");
  EXPECT_EQ(count_text(1234567), "1 234 567");
}

TEST(HumanText, ARateIsGivenInTheTimeInWhichItCanBeSeen) {
  EXPECT_EQ(rate_text(0.042), "4.2 %/s");
  EXPECT_EQ(rate_text(0.013 / 60.0), "1.3 %/min");
  EXPECT_EQ(rate_text(0.005 / 3600.0), "0.5 %/h");
}

const std::string table =
    "law                           parameters          BIC\n"
    "Hunt-Crossley                          2       -132.9\n"
    "Kuwabara\u2013Kono                          2         62.8\n";

TEST(FittedToWidth, TextThatFitsStaysAsItIs) {
  EXPECT_EQ(fitted_to_width(table, 55), table);
  EXPECT_EQ(fitted_to_width("no line ends here", 40), "no line ends here");
  EXPECT_EQ(fitted_to_width("", 40), "");
  EXPECT_EQ(fitted_to_width("one\n\n\ntwo\n", 40), "one\n\n\ntwo\n");
}

TEST(FittedToWidth, GapsBetweenColumnsAreNarrowedAndColumnsStayColumns) {
  EXPECT_EQ(fitted_to_width(table, 40),
            "law                parameters        BIC\n"
            "Hunt-Crossley               2     -132.9\n"
            "Kuwabara\u2013Kono               2       62.8\n");
}

TEST(FittedToWidth, ASentenceBelowATableDoesNotHoldItsColumnsApart) {
  EXPECT_EQ(fitted_to_width(table + "verdict: Hunt-Crossley, by information criterion alone\n", 40),
            fitted_to_width(table, 40) +
                "verdict: Hunt-Crossley, by information\n"
                "criterion alone\n");
}

TEST(FittedToWidth, AWideTableGoesOnBelowAndItsColumnsStayColumns) {
  EXPECT_EQ(fitted_to_width("mesh    cells  vertices  angle\n"
                            "coarse     64        80   20.5\n"
                            "fine     1024      1100    9.5\n",
                            26),
            "mesh    cells  vertices\n"
            "        angle\n"
            "coarse     64        80\n"
            "         20.5\n"
            "fine     1024      1100\n"
            "          9.5\n");
}

TEST(FittedToWidth, ALongLineGoesOnUnderItsLastColumn) {
  EXPECT_EQ(fitted_to_width("seed        1\n"
                            "equation    the force grows with the power three halves\n",
                            30),
            "seed      1\n"
            "equation  the force grows with\n"
            "          the power three\n"
            "          halves\n");
}

TEST(FittedToWidth, NoWordIsLostOrCut) {
  const std::string text = "  a  quite_a_long_name_without_a_blank_in_it and then some words\n\n" +
                           table + "warning   a sentence of a good many words, longer than lines\n";
  const auto words = [](const std::string& of) {
    std::istringstream stream(of);
    std::vector<std::string> all;
    for (std::string word; stream >> word;) all.push_back(word);
    return all;
  };
  for (std::size_t width = 0; width < 80; ++width)
    EXPECT_EQ(words(fitted_to_width(text, width)), words(text)) << width;
}

}  // namespace
}  // namespace rebound
