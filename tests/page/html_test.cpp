#include "pages/html.hpp"

#include <gtest/gtest.h>

#include "core/contract.hpp"
#include "pages/tables.hpp"

namespace kinestat {
namespace {

TEST(Html, EscapesTextAndAttributes) {
  Html html;
  html.element("p", "<script>alert('1')</script> & \"2\"", {{"title", "\"><img src=x>"}});

  EXPECT_EQ(html.html(),
            "<p title=\"&quot;&gt;&lt;img src=x&gt;\">&lt;script&gt;alert(&#39;1&#39;)"
            "&lt;/script&gt; &amp; &quot;2&quot;</p>\n");
}

TEST(Html, NestsElements) {
  Html html;
  html.open("ul");
  html.element("li", "a");
  html.close();

  EXPECT_EQ(html.html(), "<ul><li>a</li>\n</ul>\n");
}

TEST(Html, KeepsTheLinesOfSource) {
  Html html;
  html.open("pre");
  html.lines("a < b\n\n  ^\n");
  html.close();

  EXPECT_EQ(html.html(), "<pre>a &lt; b\n\n  ^\n</pre>\n");
}

TEST(Html, IsNotGivenOutWithAnElementOpen) {
  Html html;
  html.open("p");

  EXPECT_THROW(html.html(), ContractViolation);
}

// What ends a script for the parser of HTML begins with "<".
TEST(ScriptData, HoldsNoEndOfAScript) {
  EXPECT_EQ(script_json(R"({"a": "</script><!--"})"), R"({"a": "\u003c/script>\u003c!--"})");
  EXPECT_EQ(script_string("</script>\n\"\\"), R"("\u003c/script>\n\"\\")");
}

TEST(PageTable, HeadsColumnsAndRowsAndSetsUnitsApart) {
  Table table({"Body", "wz [rad/s]", "is"});
  table.add({"sun<1>", "-1.5e-07", "free"});
  Html html;

  add_table(table, "Velocities", html);

  const std::string& text = html.html();
  EXPECT_NE(text.find("<table class=\"n1\"><thead><tr><th scope=\"col\">Body<th scope=\"col\">wz "
                      "<span class=\"unit\">[rad/s]</span><th "),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("<tr><th scope=\"row\">sun&lt;1&gt;<td>"), std::string::npos);
  EXPECT_NE(text.find("<td>-1.5e-07<td>free</table>"), std::string::npos);
  EXPECT_NE(text.find("aria-label=\"Velocities: Body\""), std::string::npos);
}

TEST(PageTable, CanBeFoldedWhereItIsLong) {
  Table table({"Row"});
  for (int i = 0; i < 25; ++i) {
    table.add({std::to_string(i)});
  }
  Html html;

  add_table(table, "Rows", html);

  EXPECT_NE(html.html().find("<summary>Row: 25 rows</summary>"), std::string::npos);
}

}  // namespace
}  // namespace kinestat
