// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "fabricated_results.hpp"
#include "report/arena_picture.hpp"
#include "report/learner_statistics.hpp"
#include "report/paper_reference.hpp"
#include "report/pusher_report.hpp"
#include "report/table_text.hpp"

namespace sspql::report {
namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(PaperReference, Table1) {
    ASSERT_NE(paper_row("sspql-bonus"), nullptr);
    EXPECT_EQ(paper_row("q")->steps, 2849.0);
    EXPECT_EQ(paper_row("ssp")->steps, 920.0);
    EXPECT_EQ(paper_row("sspql")->steps, 822.0);
    EXPECT_EQ(paper_row("sspql-bonus")->steps, 638.0);
    EXPECT_EQ(paper_row("sspql-bonus")->figure, "Fig. 11");
    EXPECT_EQ(paper_row("dyna-q"), nullptr);
    EXPECT_EQ(method_name("q"), "Q-learning");
    EXPECT_EQ(method_name("dyna-q:20"), "dyna-q:20");
}

TEST(PaperReference, ClaimsFollowTheData) {
    // Totals 6015, 4815, 3615, 2415: the order holds, the counts and ratios do not, all curves are flat.
    const std::vector<Claim> claims = compare_with_paper(statistics_of(four_learners().phases[0]));
    ASSERT_EQ(claims.size(), 7u);
    EXPECT_TRUE(claims[0].agrees);
    EXPECT_EQ(claims[0].measured, "6015, 4815, 3615, 2415; the smallest step down is 56.6 standard errors");
    EXPECT_FALSE(claims[1].agrees);
    EXPECT_EQ(claims[1].statement, "Table 1, totals relative to Q-learning: 0.32, 0.29, 0.22");
    EXPECT_EQ(claims[1].measured, "0.80, 0.60, 0.40");
    EXPECT_FALSE(claims[2].agrees);
    EXPECT_EQ(claims[2].measured, "2.11, 5.23, 4.40, 3.79 times as many");
    EXPECT_TRUE(claims[3].agrees);
    EXPECT_TRUE(claims[4].agrees);
    EXPECT_FALSE(claims[5].agrees);  // 80.5 of 120.5 steps is not nearly half
    EXPECT_FALSE(claims[6].agrees);  // both spread alike

    ExperimentResults swapped = four_learners();
    std::swap(swapped.phases[0].learners[0].runs, swapped.phases[0].learners[3].runs);
    EXPECT_FALSE(compare_with_paper(statistics_of(swapped.phases[0]))[0].agrees);
    EXPECT_TRUE(compare_with_paper(statistics_of(results_of({{"q", {run_of(1, {3})}}}).phases[0])).empty());
}

TEST(TableText, AlignsAndFitsATerminal) {
    const std::string text = table_text(four_learners());
    std::istringstream lines(text);
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line, "approach: steps of episodes 1 to 30, 2 seeds");
    std::size_t width = 0;
    while (std::getline(lines, line)) {
        if (width == 0) width = line.size();
        EXPECT_EQ(line.size(), width) << line;
    }
    EXPECT_LE(width, 100u);
    EXPECT_TRUE(contains(text, "q            6015.0  21.2  15.0   1.00      200.5     -       0   2849   1.00\n"))
        << text;
    EXPECT_TRUE(contains(text, "sspql-bonus  2415.0  21.2  15.0   0.40       80.5  56.6       0    638   0.22\n"))
        << text;
}

TEST(TableText, ThePaperStandsOnlyBesideItsOwnTask) {
    ExperimentResults turn = four_learners();
    turn.settings[0].value = "turn";
    EXPECT_FALSE(has_paper_table(turn));
    EXPECT_FALSE(contains(table_text(turn), "paper"));
    ExperimentResults grid = four_learners();
    grid.experiment = "grid_experiment";
    EXPECT_FALSE(has_paper_table(grid));
    EXPECT_FALSE(has_paper_table(results_of({{"q", {run_of(1, {3, 4})}}})));
    EXPECT_TRUE(contains(table_text(results_of({{"q", {run_of(1, {3})}}})), "approach: steps of episode 1, 1 seed\n"));
}

TEST(PusherReport, SaysWhatWasFound) {
    const std::string html = pusher_report(four_learners(), Arena{});
    EXPECT_TRUE(contains(html,
                         "SSPQL with exploration bonus needed 0.40 of Q-learning&#39;s steps over the first 30 "
                         "episodes: 2415 against 6015 (mean of 2 seeds). No other learner needed fewer."));
    for (const char* part : {"Fig. 8", "Fig. 9", "Fig. 10", "Fig. 11", "paper, Table 1", "2849", "No episode was cut",
                             "3 agree with it", "pusher_experiment --seeds 2"}) {
        EXPECT_TRUE(contains(html, part)) << part;
    }
    EXPECT_FALSE(contains(html, "nan"));
    EXPECT_FALSE(contains(html, "n/a"));
    EXPECT_FALSE(contains(html, "Fig. 12"));
}

TEST(PusherReport, OtherTasksOtherLearnersOneEpisode) {
    ExperimentResults turn = four_learners();
    turn.settings[0].value = "turn";
    const std::string html = pusher_report(turn, Arena{});
    EXPECT_TRUE(contains(html, "Fig. 12"));
    EXPECT_FALSE(contains(html, "2849"));
    EXPECT_FALSE(contains(html, "Fig. 8"));

    const std::string one = pusher_report(results_of({{"ps-bonus", {run_of(1, {3})}}}), Arena{});
    EXPECT_TRUE(contains(one, "ps-bonus needed 3 steps over the first episode (one seed)."));
    EXPECT_FALSE(contains(one, "n/a"));
    EXPECT_THROW(static_cast<void>(pusher_report(ExperimentResults{}, Arena{})), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(pusher_report(results_of({}), Arena{})), std::invalid_argument);
}

TEST(PusherReport, NamesABetterLearnerAndCountsCappedEpisodes) {
    ExperimentResults results = four_learners();
    results.phases[0].learners.push_back({"ps-bonus", {run_of(1, std::vector<std::uint32_t>(30, 20))}});
    results.phases[0].learners[0].runs[0].episodes[0].capped = true;
    const std::string html = pusher_report(results, Arena{});
    EXPECT_TRUE(contains(html, "The fewest, 0.10 of Q-learning&#39;s steps, were needed by ps-bonus."));
    EXPECT_TRUE(contains(html, "1 of 270 episodes were cut at the step limit."));
}

TEST(ArenaPicture, DrawsPathsWithYUp) {
    Arena arena;
    arena.paths = {{"sspql <1>", {{0.0, 1.0, 0.0}, {0.0, 2.0, 1.0}}}, {"empty", {}}};
    const Svg svg = arena_picture(arena);
    const std::string text = svg.element();
    EXPECT_TRUE(contains(text, "sspql &lt;1&gt;: 1 step<"));
    EXPECT_TRUE(contains(text, "empty: 0 steps"));
    EXPECT_TRUE(contains(text, "points=\"320,198.4 320,76.8\"")) << text;  // 121.6 units a metre, centre 320
    EXPECT_TRUE(contains(text, ">goal</text>"));
    EXPECT_TRUE(contains(text, ">A</text>"));
    EXPECT_GT(svg.height(), svg.width());
}

TEST(ArenaPicture, PathsHaveTheirLearnersColour) {
    Arena arena;
    arena.starts.clear();
    arena.show_region = false;
    arena.paths = {{"sspql, start 1", {{0.0, 1.0, 0.0}, {0.0, 2.0, 1.0}}}};
    const std::string html = pusher_report(four_learners(), arena);
    EXPECT_TRUE(contains(html, "<g class=\"path\">\n<title>sspql, start 1: 1 step</title>"));
    const std::size_t path = html.find("<g class=\"path\">");
    EXPECT_TRUE(contains(html.substr(path, 800), "s-series2"));
}

}  // namespace
}  // namespace sspql::report
