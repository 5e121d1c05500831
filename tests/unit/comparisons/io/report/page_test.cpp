#include "comparisons/io/report/page.hpp"

#include <gtest/gtest.h>

#include "comparisons/io/report/json.hpp"
#include "lumped/problem/error.hpp"
#include "tests/unit/comparisons/io/report/demo_report.hpp"

namespace rebound::report {
namespace {

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(EscapeHtml, ReplacesWhatMarkupIsMadeOf) {
  EXPECT_EQ(escape_html(R"(<b a="1" c='2'>&amp;)"),
            "&lt;b a=&quot;1&quot; c=&#39;2&#39;&gt;&amp;amp;");
}

TEST(ScriptSafeJson, EndsNoScriptAndReadsBackTheSame) {
  const nlohmann::json object = {{"name", "</script><!--<script>alert(1)</script>"}};
  const std::string text = script_safe_json(object);
  EXPECT_EQ(text.find('<'), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(text), object);
}

TEST(ScriptSafeJson, RefusesTextThatIsNotUtf8) {
  EXPECT_THROW(script_safe_json({{"name", "caf\xe9"}}), Error);
}

TEST(PageHtml, HostileNamesAddNoElement) {
  const std::string name = "</script></title><img src=x onerror=alert(1)>{{renderer}}";
  const auto tame = report_tests::demo_report();
  auto hostile = report_tests::demo_report(name);
  hostile.title = name;
  const std::string plain = page_html(tame.title, report_json(tame));
  const std::string attacked = page_html(hostile.title, report_json(hostile));
  for (const char* mark : {"</script", "<script", "</title", "<img", "<!--"}) {
    EXPECT_EQ(occurrences(attacked, mark), occurrences(plain, mark)) << mark;
  }
}

TEST(PageHtml, IsOneFileThatMayLoadNothing) {
  const auto report = report_tests::demo_report();
  const std::string page = page_html(report.title, report_json(report));
  EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
  EXPECT_EQ(occurrences(page, "<script"), 3u);  // drawing library, data, renderer
  EXPECT_EQ(page.find("<script src"), std::string::npos);
  EXPECT_EQ(page.find("rel=\"stylesheet\""), std::string::npos);
  EXPECT_EQ(occurrences(page, "{{"), occurrences(page_html("", nullptr), "{{"));
}

}  // namespace
}  // namespace rebound::report
