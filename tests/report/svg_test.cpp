// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "report/svg.hpp"

namespace sspql::report {
namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(Svg, ShapesCarryLightColourAndClass) {
    Svg svg(100.0, 50.0, "A test");
    svg.line({0.0, 1.0}, {2.5, 3.0}, {Ink::none, Ink::series0, 2.0, 0.5, "4 3"});
    svg.circle({1.0 / 3.0, -0.0}, 4.0, {Ink::text}, "tip <1>");
    svg.polygon({{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}}, {Ink::goal});
    const std::string text = svg.element();
    EXPECT_TRUE(contains(text, "viewBox=\"0 0 100 50\"")) << text;
    EXPECT_TRUE(contains(text, "aria-label=\"A test\"")) << text;
    EXPECT_TRUE(contains(text,
                         "<line x1=\"0\" y1=\"1\" x2=\"2.5\" y2=\"3\" class=\"s-series0\" fill=\"none\" "
                         "stroke=\"#D55E00\" stroke-width=\"2\" opacity=\"0.5\" stroke-dasharray=\"4 3\"/>"))
        << text;
    EXPECT_TRUE(contains(text, "<circle cx=\"0.33\" cy=\"0\" r=\"4\"")) << text;
    EXPECT_TRUE(contains(text, "<title>tip &lt;1&gt;</title></circle>")) << text;
    EXPECT_TRUE(contains(text, "points=\"0,0 1,0 0,1\"")) << text;
}

TEST(Svg, EscapesTextsAndSurvivesBadNumbers) {
    Svg svg(10.0, 10.0, "a \"b\"");
    svg.text({std::nan(""), std::numeric_limits<double>::infinity()}, "<script>&", {});
    svg.begin_group("c\"lass", "t<i>p");
    svg.end_group();
    const std::string text = svg.element();
    EXPECT_FALSE(contains(text, "<script>"));
    EXPECT_FALSE(contains(text, "nan"));
    EXPECT_FALSE(contains(text, "inf"));
    EXPECT_TRUE(contains(text, "&lt;script&gt;&amp;"));
    EXPECT_TRUE(contains(text, "<g class=\"c&quot;lass\">\n<title>t&lt;i&gt;p</title>")) << text;
}

TEST(Svg, ArcsTurnCounterClockwise) {
    Svg svg(10.0, 10.0, "arc");
    svg.arc({5.0, 5.0}, 2.0, 0.0, std::acos(0.0), {Ink::none, Ink::text});
    EXPECT_TRUE(contains(svg.element(), "d=\"M7 5A2 2 0 0 0 5 3\"")) << svg.element();  // from the right to the top
    svg.sector({5.0, 5.0}, 2.0, 0.0, 1.5 * std::acos(-1.0), {Ink::region});
    EXPECT_TRUE(contains(svg.element(), "d=\"M5 5L7 5A2 2 0 1 0 5 7Z\"")) << svg.element();
}

TEST(Svg, GroupsMustMatch) {
    Svg svg(10.0, 10.0, "groups");
    EXPECT_THROW(svg.end_group(), std::logic_error);
    svg.begin_group("a");
    EXPECT_THROW(static_cast<void>(svg.element()), std::logic_error);
    svg.end_group();
    EXPECT_NO_THROW(static_cast<void>(svg.document()));
}

TEST(Svg, DocumentStandsAloneInLightAndDark) {
    const std::string text = Svg(10.0, 10.0, "alone").document();
    EXPECT_EQ(text.rfind("<?xml", 0), 0u);
    EXPECT_TRUE(contains(text, "prefers-color-scheme:dark"));
    EXPECT_TRUE(contains(text, "class=\"f-paper\""));
}

TEST(Svg, TextWidthCountsLetters) {
    EXPECT_EQ(text_width("", 10.0), 0.0);
    EXPECT_GT(text_width("Wide", 10.0), text_width("ill.", 10.0));
    EXPECT_EQ(text_width("\xCE\xB3", 10.0), text_width("n", 10.0));  // one letter in two bytes
}

}  // namespace
}  // namespace sspql::report
