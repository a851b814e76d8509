// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <string>

#include "report/html_page.hpp"

namespace sspql::report {
namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

HtmlPage page_with_everything(const std::string& text) {
    HtmlPage page(text);
    page.lead(text);
    page.section(text);
    page.paragraph(text);
    page.note(text);
    page.table({text, {{text, text, text, false}, {"n", "", text}}, {{{text}, {"1", true}}}});
    Svg svg(10.0, 10.0, text);
    svg.text({1.0, 1.0}, text, {});
    page.figure({svg, text});
    page.figure_row({{svg, text}, {svg, text}});
    return page;
}

TEST(HtmlPage, EscapesEveryText) {
    const std::string evil = "<script>alert('&\"')</script>";
    const std::string html = page_with_everything(evil).text({evil, evil, evil}, {{evil, evil, true}});
    EXPECT_FALSE(contains(html, "<script"));
    EXPECT_FALSE(contains(html, "</script"));
    EXPECT_TRUE(contains(html, "&lt;script&gt;alert(&#39;&amp;&quot;&#39;)&lt;/script&gt;"));
}

TEST(HtmlPage, FetchesNothing) {
    std::string html = page_with_everything("text").text({"command", "0.1.0", "g++"}, {{"seeds", "2", false}});
    const std::string name_space = "http://www.w3.org/2000/svg";  // a name, not an address
    for (std::size_t at = html.find(name_space); at != std::string::npos; at = html.find(name_space)) {
        html.erase(at, name_space.size());
    }
    for (const char* part : {"http:", "https:", "url(", "@import", " src=", " href=", "<link", "<script"}) {
        EXPECT_FALSE(contains(html, part)) << part;
    }
}

TEST(HtmlPage, HasManifestSchemesAndPrintRules) {
    const std::string html = HtmlPage("title").text({"run --seeds 2", "0.1.0", "g++ 12.2.0"}, {{"task", "turn", true}});
    EXPECT_EQ(html.rfind("<!DOCTYPE html>", 0), 0u);
    for (const char* part : {"<code>run --seeds 2</code>", "<code>0.1.0</code>", "<code>g++ 12.2.0</code>",
                             "<dt>task</dt><dd><code>turn</code></dd>", "prefers-color-scheme:dark", "@media print",
                             "name=\"viewport\""}) {
        EXPECT_TRUE(contains(html, part)) << part;
    }
}

TEST(HtmlPage, TablesAlignNumbersGroupColumnsAndMarkTheBest) {
    HtmlPage page("t");
    page.table({"", {{"learner", "", "", false}, {"a", "steps", "g"}, {"b", "", "g"}}, {{{"q"}, {"1", true}}}});
    const std::string html = page.text({}, {});
    EXPECT_TRUE(contains(html, "<th class=\"group edge\" colspan=\"2\">g</th>"));
    EXPECT_TRUE(contains(html, "<th scope=\"col\" class=\"number edge\">a<span class=\"unit\">steps</span></th>"));
    EXPECT_TRUE(contains(html, "<td>q</td><td class=\"number edge best\">1</td><td class=\"number\"></td>"));
}

}  // namespace
}  // namespace sspql::report
