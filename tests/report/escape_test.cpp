#include "report/page/escape.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

namespace jointid::report {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(Escape, HtmlHasNoMarkupLeft) {
  EXPECT_EQ(html("a < b & \"c\" > 'd'"), "a &lt; b &amp; &quot;c&quot; &gt; &#39;d&#39;");
  EXPECT_EQ(html("<script>"), "&lt;script&gt;");
}

TEST(Escape, HtmlKeepsOtherLettersAndBlanksControlCharacters) {
  EXPECT_EQ(html("Größe 4:+Y"), "Größe 4:+Y");
  EXPECT_EQ(html(std::string_view("a\0b\x7f\x1b\n", 6)), "a b  \n");
}

TEST(Escape, NothingEndsTheScriptElementAndTheTextIsTheSame) {
  const std::string text = "</script><!-- <SCRIPT ";
  const std::string written = script_json(nlohmann::json(text).dump());
  EXPECT_THAT(written, Not(HasSubstr("<")));
  EXPECT_EQ(nlohmann::json::parse(written).get<std::string>(), text);
}

}  // namespace
}  // namespace jointid::report
