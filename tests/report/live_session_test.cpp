// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

#include "experiment/learner_catalog.hpp"
#include "experiment/live_session.hpp"
#include "experiment/live_world.hpp"

namespace sspql::experiment {
namespace {

constexpr double frame_s = 1.0 / 60.0;

LiveSession session(const std::string& pace, const std::string& task = "approach") {
    return LiveSession(
        LiveRun(make_live_world("kinematic", task, {}, 2000), learner_recipes("q,sspql,adaptive", {}), 1), Pace(pace));
}

void pass_frames(LiveSession& session, int frames) {
    for (int i = 0; i < frames; ++i) session.pass(frame_s, [] { return true; });
}

/// Actions and new beginnings: everything that takes its turn.
std::size_t ticks(const LiveRun& run) {
    return run.total_steps() + run.episodes().size() - (run.is_episode_over() ? 1 : 0);
}

void press(LiveSession& session, char32_t key) { session.handle(command_of(key).value()); }

TEST(LivePace, CountsOutItsActions) {
    for (const std::string& name : Pace::names()) {
        if (name == "max") continue;
        Pace pace(name);
        std::size_t due = 0;
        for (int i = 0; i < 600; ++i) due += pace.due(frame_s);
        EXPECT_EQ(due, 10U * static_cast<std::size_t>(pace.per_second())) << name;
    }
}

TEST(LivePace, StaysWithinItsLevels) {
    Pace pace("1");
    pace.slower();
    EXPECT_EQ(pace.text(), "1 action/s");
    const std::size_t levels = Pace::names().size();
    for (std::size_t i = 1; i < levels; ++i) {
        EXPECT_FALSE(pace.is_unlimited());
        const double before = pace.per_second();
        pace.faster();
        EXPECT_TRUE(pace.is_unlimited() || pace.per_second() > before);
    }
    EXPECT_TRUE(pace.is_unlimited());
    pace.faster();
    EXPECT_TRUE(pace.is_unlimited());
    pace.slower();
    EXPECT_FALSE(pace.is_unlimited());
    EXPECT_THROW(Pace("3"), std::invalid_argument);
    EXPECT_THROW(Pace(""), std::invalid_argument);
}

TEST(LiveSession, GoesAtItsPace) {
    LiveSession slow = session("2");
    pass_frames(slow, 120);
    EXPECT_EQ(ticks(slow.run()), 4U);
    press(slow, U'+');  // 5 a second
    pass_frames(slow, 120);
    EXPECT_EQ(ticks(slow.run()), 14U);
    press(slow, U'-');
    press(slow, U'-');  // 1 a second
    pass_frames(slow, 120);
    EXPECT_EQ(ticks(slow.run()), 16U);
}

TEST(LiveSession, StandsStillWhilePaused) {
    LiveSession held = session("100");
    pass_frames(held, 60);
    press(held, U' ');
    EXPECT_TRUE(held.is_paused());
    const std::string before = held.status();
    pass_frames(held, 600);
    EXPECT_EQ(held.status(), before);
    press(held, U'n');
    EXPECT_EQ(ticks(held.run()), 101U);
    press(held, U' ');
    pass_frames(held, 60);
    EXPECT_EQ(ticks(held.run()), 201U);
    press(held, U'n');
    EXPECT_TRUE(held.is_paused()) << "a single step while it runs holds it";
    EXPECT_EQ(ticks(held.run()), 202U);
}

TEST(LiveSession, UnlimitedGoesOnWhileThereIsTime) {
    LiveSession fast = session("max");
    int left = 1234;
    fast.pass(frame_s, [&] { return --left > 0; });
    EXPECT_EQ(ticks(fast.run()), 1234U);

    LiveRun short_run(make_live_world("kinematic", "turn", {}, 2000), learner_recipes("q", {}), 1);
    short_run.stop_after(3);
    LiveSession ends(std::move(short_run), Pace("max"));
    ends.pass(frame_s, [] { return true; });  // returns although there is always time
    EXPECT_TRUE(ends.run().is_over());
    EXPECT_EQ(ends.run().episodes().size(), 3U);
}

TEST(LiveSession, DropsWhatThereWasNoTimeFor) {
    LiveSession busy = session("1000");
    int left = 3;
    busy.pass(0.1, [&] { return --left > 0; });
    EXPECT_EQ(ticks(busy.run()), 3U);
    busy.pass(0.0, [] { return true; });
    EXPECT_EQ(ticks(busy.run()), 3U);
    busy.pass(3600.0, [] { return true; });  // the window was held: a quarter of a second counts
    EXPECT_EQ(ticks(busy.run()), 253U);
}

TEST(LiveSession, KeysChooseLearnerAndSeed) {
    LiveSession chosen = session("50");
    pass_frames(chosen, 60);
    press(chosen, U'l');
    EXPECT_EQ(chosen.status(), "sspql, seed 1, episode 1, step 0, 0 in all");
    press(chosen, U'3');
    EXPECT_EQ(chosen.run().learner_name(), "adaptive");
    pass_frames(chosen, 60);
    EXPECT_EQ(ticks(chosen.run()), 50U);
    press(chosen, U'9');  // there is none: the run goes on
    EXPECT_EQ(ticks(chosen.run()), 50U);
    press(chosen, U'L');
    EXPECT_EQ(chosen.run().learner_name(), "q") << "after the last comes the first";
    press(chosen, U'r');
    EXPECT_EQ(chosen.status(), "q, seed 2, episode 1, step 0, 0 in all");
    EXPECT_FALSE(chosen.is_help_shown());
    press(chosen, U'h');
    EXPECT_TRUE(chosen.is_help_shown());
    EXPECT_FALSE(chosen.is_quitting());
    press(chosen, U'q');
    EXPECT_TRUE(chosen.is_quitting());
    EXPECT_FALSE(command_of(U'x').has_value());
    EXPECT_FALSE(command_of(U'0').has_value());
}

TEST(LiveSession, RemembersTheRunsItLeft) {
    LiveSession compared = session("1000");
    press(compared, U'2');
    EXPECT_TRUE(compared.past().empty()) << "the first learner had no episode behind it";
    pass_frames(compared, 600);
    const std::size_t episodes = compared.run().episodes().size();
    ASSERT_GT(episodes, 0U);
    press(compared, U'3');
    ASSERT_EQ(compared.past().size(), 1U);
    EXPECT_EQ(compared.past()[0].learner, 1U);
    EXPECT_EQ(compared.past()[0].episodes.size(), episodes);
    pass_frames(compared, 600);
    press(compared, U'1');
    ASSERT_EQ(compared.past().size(), 2U);
    EXPECT_EQ(compared.past()[1].learner, 2U);
    press(compared, U'2');  // again: what it did before is no comparison now
    ASSERT_EQ(compared.past().size(), 1U);
    EXPECT_EQ(compared.past()[0].learner, 2U);
    press(compared, U'r');
    EXPECT_TRUE(compared.past().empty()) << "another seed is another world";
}

TEST(LiveSession, ShowsTheRobotOnItsWay) {
    LiveSession slow = session("1");
    EXPECT_EQ(slow.shown_robot(), slow.run().trail()[0]);
    EXPECT_FALSE(slow.is_under_way());
    pass_frames(slow, 75);  // one action, and a quarter of the time until the next
    ASSERT_EQ(slow.run().trail().size(), 2U);
    const sim::Pose& from = slow.run().trail()[0];
    const sim::Pose& there = slow.run().trail()[1];
    EXPECT_NEAR(slow.shown_robot().x_m, from.x_m + 0.25 * (there.x_m - from.x_m), 1e-9);
    EXPECT_NEAR(slow.shown_robot().y_m, from.y_m + 0.25 * (there.y_m - from.y_m), 1e-9);
    EXPECT_NEAR(sim::wrap_angle(slow.shown_robot().heading_rad - from.heading_rad),
                0.25 * sim::wrap_angle(there.heading_rad - from.heading_rad), 1e-9);
    EXPECT_TRUE(slow.is_under_way());
    EXPECT_EQ(&slow.shown_decision(), &*slow.run().last());
    press(slow, U' ');
    EXPECT_EQ(slow.shown_robot(), there);
    EXPECT_EQ(&slow.shown_decision(), &*slow.run().next());
}

}  // namespace
}  // namespace sspql::experiment
