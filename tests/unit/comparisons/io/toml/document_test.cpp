#include "comparisons/io/toml/document.hpp"

#include "tests/support/refusals.hpp"

namespace rebound {
namespace {

using testing::refusal_of;

TEST(DocumentTest, DuplicateKeyIsNamedWithItsTableAndLine) {
  const Error error = refusal_of(
      [] { Document::parse("[sphere]\nmass = \"1 g\"\nmass = \"2 g\"\n", "ball.toml"); });
  EXPECT_EQ(error.code(), ExitCode::bad_input);
  EXPECT_EQ(error.location().file, "ball.toml");
  EXPECT_EQ(error.location().line, 3);
  EXPECT_EQ(error.location().key, "sphere.mass");
  EXPECT_NE(std::string(error.what()).find("stands twice"), std::string::npos);
}

TEST(DocumentTest, BrokenTextIsNamedWithItsLine) {
  for (const char* text : {"a = 1\nb = 1,5\n", "a = 1\nb = \"x", "a = 1\n[b\n",
                           "a = 1\n\x7f"
                           "ELF"}) {
    const Error error = refusal_of([&] { Document::parse(text, "f"); });
    EXPECT_EQ(error.code(), ExitCode::bad_input);
    EXPECT_EQ(error.location().line, 2) << text;
  }
}

TEST(DocumentTest, ValueIsQuotedAsWritten) {
  const Document document = Document::parse("# µ\nt = {\"µ\" = 1, x = \"1 µs\"} # note\n", "f");
  const Error error = document.error_at("t.x", "no");
  EXPECT_EQ(error.location().value, "\"1 µs\"");
  EXPECT_EQ(error.location().line, 2);
  EXPECT_EQ(error.location().column, 19);
}

TEST(DocumentTest, AMissingKeyPointsAtItsTable) {
  const Document document = Document::parse("\n[t]\nx = 1\n", "f");
  EXPECT_EQ(document.error_at("t.y", "missing").location().line, 2);
  EXPECT_EQ(document.error_at("t.y", "missing").location().value, "");
}

TEST(DocumentTest, AFolderAndAMissingFileCannotBeRead) {
  EXPECT_EQ(refusal_of([] { Document::load("/"); }).code(), ExitCode::input_output_failed);
  EXPECT_EQ(refusal_of([] { Document::load("/no/such/file"); }).code(),
            ExitCode::input_output_failed);
}

TEST(DocumentTest, AWindowsFileReadsLikeAnyOther) {
  const Document document = Document::parse(
      "\xef\xbb\xbf"
      "a = 1\r\n[t]\r\nx = \"y\"\r\n",
      "f");
  EXPECT_EQ(document.error_at("t.x", "no").location().value, "\"y\"");
}

}  // namespace
}  // namespace rebound
