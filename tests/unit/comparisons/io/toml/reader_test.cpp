#include "comparisons/io/toml/reader.hpp"

#include <cstdint>

#include "tests/support/refusals.hpp"

namespace rebound {

enum class Colour { red, green };
struct Part {
  double size = 0.0;
};
/// One member of every kind.
struct Everything {
  double length = 0.0;
  std::optional<double> optional_time;
  int count = 3;
  std::uint64_t seed = 1;
  bool enabled = false;
  std::string label;
  Colour colour = Colour::red;
  std::vector<double> speeds;
  std::vector<std::string> names;
  Part part;
  std::vector<Part> parts;
};

void describe(Visitor& visit, Part& part) {
  visit.number({.name = "size", .sentence = "Size.", .unit = "mm", .range = above(0.0)}, part.size);
}

void describe(Visitor& visit, Everything& all) {
  visit.number(
      {.name = "length", .sentence = "A length.", .unit = "mm", .range = above_up_to(0.0, 1.0)},
      all.length);
  visit.number({.name = "optional_time",
                .sentence = "A time.",
                .presence = Presence::optional,
                .unit = "ms"},
               all.optional_time);
  visit.whole({.name = "count",
               .sentence = "A count.",
               .presence = Presence::optional,
               .range = from_to(1, 10)},
              all.count);
  visit.whole(
      {.name = "seed", .sentence = "A seed.", .presence = Presence::optional, .range = at_least(0)},
      all.seed);
  visit.flag({.name = "enabled", .sentence = "A flag.", .presence = Presence::optional},
             all.enabled);
  visit.text({.name = "label", .sentence = "A text.", .presence = Presence::optional}, all.label);
  visit.choice<Colour>({.name = "colour",
                        .sentence = "A choice.",
                        .presence = Presence::optional,
                        .later = {"blue"}},
                       {{"red", Colour::red}, {"green", Colour::green}}, all.colour);
  visit.numbers({.name = "speeds",
                 .sentence = "Speeds.",
                 .presence = Presence::optional,
                 .unit = "m/s",
                 .range = above(0.0)},
                all.speeds);
  visit.texts({.name = "names", .sentence = "Names.", .presence = Presence::optional}, all.names);
  visit.table({.name = "part", .sentence = "A part.", .presence = Presence::optional}, all.part);
  visit.list({.name = "parts", .sentence = "Parts.", .presence = Presence::optional}, all.parts);
  visit.not_available("future", "not available in this version");
}

namespace {

using testing::refusal_of;

Everything read(const std::string& text) {
  Everything all;
  read_document(Document::parse(text, "f.toml"), all);
  return all;
}

TEST(ReaderTest, FillsEveryKindOfMember) {
  const Everything all = read(R"(
length = "5 mm"
optional_time = "2 ms"
count = 7
seed = 9007199254740993
enabled = true
label = "x"
colour = "green"
speeds = ["5 m/s", "15 m/s"]
names = ["a", "b"]
part.size = "1 mm"
[[parts]]
size = "2 mm"
[[parts]]
size = "3 mm"
)");
  EXPECT_EQ(all.length, 0.005);
  EXPECT_EQ(all.optional_time, 0.002);
  EXPECT_EQ(all.count, 7);
  EXPECT_EQ(all.seed, 9007199254740993u);  // not a double
  EXPECT_TRUE(all.enabled);
  EXPECT_EQ(all.label, "x");
  EXPECT_EQ(all.colour, Colour::green);
  EXPECT_EQ(all.speeds, (std::vector<double>{5.0, 15.0}));
  EXPECT_EQ(all.names, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(all.part.size, 0.001);
  ASSERT_EQ(all.parts.size(), 2u);
  EXPECT_EQ(all.parts[1].size, 0.003);
}

TEST(ReaderTest, AbsentOptionalMembersKeepTheirDefaults) {
  const Everything all = read("length = \"5 mm\"\n");
  EXPECT_FALSE(all.optional_time.has_value());
  EXPECT_EQ(all.count, 3);
  EXPECT_EQ(all.colour, Colour::red);
}

struct RefusedLine {
  const char* name;
  const char* text;  ///< what stands in line 2
  const char* key;
  const char* value;
  const char* message;
};

class ReaderRefuses : public ::testing::TestWithParam<RefusedLine> {};

TEST_P(ReaderRefuses, WithFileLineKeyAndValue) {
  const RefusedLine& c = GetParam();
  const std::string first = std::string(c.text).starts_with("length") ? "" : "length = \"5 mm\"";
  const Error error = refusal_of([&] { read(first + "\n" + c.text + "\n"); });
  EXPECT_EQ(error.code(), ExitCode::bad_input);
  EXPECT_EQ(error.location().file, "f.toml");
  EXPECT_EQ(error.location().line, 2);
  EXPECT_EQ(error.location().key, c.key);
  EXPECT_EQ(error.location().value, c.value);
  EXPECT_NE(std::string(error.what()).find(c.message), std::string::npos) << error.what();
}

INSTANTIATE_TEST_SUITE_P(
    Cases, ReaderRefuses,
    ::testing::Values(
        RefusedLine{"Negative", "length = \"-1 mm\"", "length", "\"-1 mm\"", "out of range"},
        RefusedLine{"Zero", "length = \"0 mm\"", "length", "\"0 mm\"", "out of range"},
        RefusedLine{"TooLarge", "length = \"2 m\"", "length", "\"2 m\"", "out of range"},
        RefusedLine{"Bare", "length = 5", "length", "5", "with its unit"},
        RefusedLine{"NotFinite", "length = nan", "length", "nan", "finite"},
        RefusedLine{"Dimension", "length = \"5 ms\"", "length", "\"5 ms\"", "not a multiple of m"},
        RefusedLine{"Comma", "length = \"1,5 mm\"", "length", "\"1,5 mm\"", "comma"},
        RefusedLine{"Typo", "conut = 3", "conut", "3", "did you mean \"count\""},
        RefusedLine{"Fraction", "count = 3.5", "count", "3.5", "whole number"},
        RefusedLine{"Count", "count = 11", "count", "11", "out of range"},
        RefusedLine{"Flag", "enabled = 1", "enabled", "1", "true or false"},
        RefusedLine{"Choice", "colour = \"gren\"", "colour", "\"gren\"", "did you mean \"green\""},
        RefusedLine{"Later", "colour = \"blue\"", "colour", "\"blue\"", "not available"},
        RefusedLine{"Future", "future = 1", "future", "1", "not available"},
        RefusedLine{"Scalar", "speeds = \"5 m/s\"", "speeds", "\"5 m/s\"", "a list"},
        RefusedLine{"Element", "speeds = [\"5 m/s\", 6]", "speeds", "6", "with its unit"},
        RefusedLine{"NoTable", "part = 3", "part", "3", "a table [part]"},
        RefusedLine{"NoList", "parts = [1]", "parts", "[1]", "tables [[parts]]"}),
    [](const auto& instance) { return std::string(instance.param.name); });

TEST(ReaderTest, KeyPathsReachIntoLists) {
  const Error error = refusal_of(
      [] { read("length = \"5 mm\"\n[[parts]]\nsize = \"2 mm\"\n[[parts]]\nsize = \"-3 mm\"\n"); });
  EXPECT_EQ(error.location().key, "parts[1].size");
  EXPECT_EQ(error.location().line, 5);
  EXPECT_EQ(error.location().allowed, "value > 0 mm");
}

TEST(ReaderTest, AMissingKeyIsNamed) {
  const Error error = refusal_of([] { read("count = 3\n"); });
  EXPECT_EQ(error.location().key, "length");
  EXPECT_NE(std::string(error.what()).find("missing"), std::string::npos);
}

TEST(ReaderTest, AMisspeltRequiredKeyIsCalledMisspelt) {
  const Error error = refusal_of([] { read("lenght = \"5 mm\"\n"); });
  EXPECT_EQ(error.location().key, "lenght");
  EXPECT_NE(std::string(error.what()).find("\"length\""), std::string::npos);
}

}  // namespace
}  // namespace rebound
