// SPDX-License-Identifier: MIT
#include <sspql/io/dot.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <string>

#include <sspql/io/label_text.hpp>
#include <sspql/learn/sspql.hpp>

#include "io/file_testing.hpp"

namespace sspql {
namespace {

using testing::content;
using DotTest = testing::FileTest;

constexpr ActionId a0{0}, a1{1};

/// 0 -> 1 -> 3, in half of the cases 1 -> 2; from 2 nobody returned; 4 was never met.
TransitionCounts<> small_graph() {
    TransitionCounts<> counts(5, 2);
    counts.record(state_id(0), a0, state_id(1));
    counts.record(state_id(0), a1, state_id(0));
    counts.record(state_id(1), a0, state_id(3), true);
    counts.record(state_id(1), a0, state_id(2));
    return counts;
}

/// The attributes of the line that begins with this; "missing" if there is none.
std::string line_of(const std::string& dot, const std::string& beginning) {
    const std::size_t begin = dot.find("\n  " + beginning);
    if (begin == std::string::npos) return "missing";
    return dot.substr(begin + 3, dot.find('\n', begin + 1) - begin - 3);
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_F(DotTest, MarksThePathsAndTheGoals) {
    save_dot(path("g.dot"), small_graph(), {{state_id(3), 0.0}});
    const std::string dot = content(path("g.dot"));
    EXPECT_TRUE(has(line_of(dot, "s0 ["), "label=\"0\\n3.0\"")) << "one try to 1, two from there: " << dot;
    EXPECT_TRUE(has(line_of(dot, "s2 ["), "label=\"2\", fillcolor=\"#eceff3\"")) << "no path is known";
    EXPECT_TRUE(has(line_of(dot, "s3 ["), "label=\"3\", shape=doublecircle"));
    EXPECT_EQ(line_of(dot, "s4"), "missing");
    EXPECT_TRUE(has(line_of(dot, "s0 -> s1"), "color=\"#c8452b\", penwidth=3.00"));
    EXPECT_TRUE(has(line_of(dot, "s1 -> s3"), "penwidth=2.00"));
    EXPECT_TRUE(has(line_of(dot, "s1 -> s3"), "label=\"0.50\""));
    EXPECT_EQ(line_of(dot, "s1 -> s2"), "s1 -> s2;") << "no edge of the tree";
    EXPECT_EQ(line_of(dot, "s0 -> s0"), "missing");
    EXPECT_EQ(dot.substr(dot.size() - 4), ";\n}\n");
}

TEST_F(DotTest, OptionsAreFollowed) {
    DotOptions options;
    options.title = "a \"test\"";
    options.loops = true;
    options.distances = false;
    options.probabilities = false;
    options.label = [](StateId s) { return s == state_id(0) ? std::string("Küche & Bad\\\"\x01\xFF") : "x"; };
    options.position = [](StateId s) { return std::array<double, 2>{0.5 * static_cast<double>(index(s)), -1.0}; };
    save_dot(path("g.dot"), small_graph(), {{state_id(3), 0.0}}, options);
    const std::string dot = content(path("g.dot"));
    EXPECT_TRUE(has(dot, "label=\"a \\\"test\\\"\"]"));
    EXPECT_TRUE(has(line_of(dot, "s0 ["), "label=\"Küche &amp; Bad\\\\\\\"??\",")) << line_of(dot, "s0 [");
    EXPECT_TRUE(has(line_of(dot, "s1 ["), "pos=\"0.500,-1.000!\""));
    EXPECT_FALSE(has(line_of(dot, "s1 -> s3"), "label"));
    EXPECT_EQ(line_of(dot, "s0 -> s0"), "s0 -> s0;");
}

// The goal and the state before it; edges to others are left out.
TEST_F(DotTest, TheNearestStatesAreDrawn) {
    DotOptions options;
    options.most_states = 2;
    save_dot(path("g.dot"), small_graph(), {{state_id(3), 0.0}}, options);
    const std::string dot = content(path("g.dot"));
    EXPECT_EQ(line_of(dot, "s0"), "missing");
    EXPECT_EQ(line_of(dot, "s1 -> s2"), "missing");
    EXPECT_NE(line_of(dot, "s1 -> s3"), "missing");
    EXPECT_TRUE(has(line_of(dot, "note ["), "label=\"and 2 more states\""));
}

TEST_F(DotTest, ALearnerIsDrawnWithItsOwnTree) {
    Sspql<> learner(3, 2);
    learner.observe(state_id(0), a1, 0.0, state_id(1), false);
    learner.observe(state_id(1), a0, 1.0, state_id(2), true);
    save_dot(path("g.dot"), learner);
    const std::string dot = content(path("g.dot"));
    EXPECT_TRUE(has(line_of(dot, "s0 ["), "label=\"0\\n0.3\"")) << "twice e^-2";
    EXPECT_TRUE(has(line_of(dot, "s2 ["), "doublecircle"));
    EXPECT_TRUE(has(line_of(dot, "s0 -> s1"), "color"));
}

TEST_F(DotTest, NothingLearntIsAGraphToo) {
    save_dot(path("g.dot"), TransitionCounts<>(0, 1), {});
    EXPECT_TRUE(has(content(path("g.dot")), "digraph learnt {"));
    EXPECT_THROW(save_dot(path("g.dot"), TransitionCounts<>(2, 1), ShortestPathTree{}, {{state_id(2), 0.0}}),
                 std::invalid_argument);
    DotOptions nowhere;
    nowhere.position = [](StateId) { return std::array<double, 2>{0.0, std::numeric_limits<double>::infinity()}; };
    const std::string before = content(path("g.dot"));
    EXPECT_THROW(save_dot(path("g.dot"), small_graph(), {{state_id(3), 0.0}}, nowhere), std::invalid_argument);
    EXPECT_EQ(content(path("g.dot")), before);
    EXPECT_EQ(files(), 1u);
}

// The real reader takes every label as it was meant.
TEST_F(DotTest, GraphVizReadsAnyLabel) {
    if (std::system("dot -V >/dev/null 2>&1") != 0) GTEST_SKIP() << "no dot";
    std::string all;
    for (int c = 1; c < 256; ++c) all += static_cast<char>(c);
    DotOptions options;
    options.title = all + "</svg> \"\\\n\\N &lt; <b>";
    options.label = [&](StateId) { return all + "\\"; };
    save_dot(path("g.dot"), small_graph(), {{state_id(3), 0.0}}, options);
    const std::string command = "dot -Tsvg '" + path("g.dot") + "' -o '" + path("g.svg") + "' 2>'" + path("err") + "'";
    EXPECT_EQ(std::system(command.c_str()), 0);
    EXPECT_EQ(content(path("err")), "");
    const std::string svg = content(path("g.svg"));
    EXPECT_TRUE(has(svg, "&lt;/svg&gt; &quot;\\")) << svg;
    EXPECT_TRUE(has(svg, "\\N &amp;lt; &lt;b&gt;")) << "no entity, no name of a node";
}

TEST(LearntPaths, AreTheExpectedSteps) {
    const ShortestPathTree tree = learnt_paths(small_graph(), {{state_id(3), 1.0}});
    EXPECT_EQ(tree.distance[3], 1.0);
    EXPECT_EQ(tree.distance[1], 3.0);
    EXPECT_EQ(tree.distance[0], 4.0);
    EXPECT_EQ(tree.next[0], state_id(1));
    EXPECT_FALSE(tree.reaches_goal(state_id(2)));
    EXPECT_EQ(learnt_paths(TransitionCounts<>(0, 1), {}).size(), 0u);
}

TEST(LabelText, KeepsUtf8AndReplacesTheRest) {
    using detail::printable;
    EXPECT_EQ(printable("Küche → 駅 😀\n"), "Küche → 駅 😀\n");
    EXPECT_EQ(printable("\t\x7F\r"), "???");
    EXPECT_EQ(printable("\xC0\xAF"), "??") << "overlong";
    EXPECT_EQ(printable("\xED\xA0\x80"), "???") << "a surrogate";
    EXPECT_EQ(printable("\xF4\x90\x80\x80"), "????") << "above U+10FFFF";
    EXPECT_EQ(printable("\xE2\x82"), "??") << "cut off";
    EXPECT_EQ(printable("\xF8z"), "?z");
    EXPECT_EQ(detail::csv_quoted("a,\"b\""), "\"a,\"\"b\"\"\"");
    EXPECT_EQ(detail::csv_quoted("plain"), "plain");
}

}  // namespace sspql
