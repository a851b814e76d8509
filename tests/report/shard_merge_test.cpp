// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>

#include <sspql/core/version.hpp>

#include "report/shard_testing.hpp"
#include "shards/merge.hpp"

namespace sspql::shards {
namespace {

/// What one process would keep in `shard.count` processes, by way of text, the last shard first.
template <class Findings>
Findings merged(const std::string& program, const Findings& findings, std::size_t count) {
    Merge<Findings> merge;
    for (std::size_t i = count; i-- > 0;) {
        const std::string name = "s" + std::to_string(i);
        merge.add(parse_shard_text(shard_text(content_of(program, findings, {i, count}, "the command")), name), name);
    }
    return merge.take();
}

void expect_same(const std::optional<double>& a, const std::optional<double>& b) {
    ASSERT_EQ(a.has_value(), b.has_value());
    if (a) {
        EXPECT_TRUE(same_bits(*a, *b)) << *a << " and " << *b;
    }
}

void expect_same(const report::SeedRun& a, const report::SeedRun& b) {
    EXPECT_EQ(a.seed, b.seed);
    ASSERT_EQ(a.episodes.size(), b.episodes.size());
    for (std::size_t i = 0; i < a.episodes.size(); ++i) {
        EXPECT_EQ(a.episodes[i].steps, b.episodes[i].steps);
        EXPECT_TRUE(same_bits(a.episodes[i].total_reward, b.episodes[i].total_reward)) << i;
        EXPECT_EQ(a.episodes[i].success, b.episodes[i].success);
        EXPECT_EQ(a.episodes[i].capped, b.episodes[i].capped);
    }
    EXPECT_EQ(a.reward_at, b.reward_at);
    EXPECT_EQ(a.steps, b.steps);
    EXPECT_EQ(a.model_operations, b.model_operations);
    EXPECT_TRUE(same_bits(a.learning_ns, b.learning_ns));
}

void expect_same(const report::ExperimentResults& a, const report::ExperimentResults& b) {
    EXPECT_EQ(a.experiment, b.experiment);
    ASSERT_EQ(a.settings.size(), b.settings.size());
    for (std::size_t i = 0; i < a.settings.size(); ++i) {
        EXPECT_EQ(a.settings[i].key, b.settings[i].key);
        EXPECT_EQ(a.settings[i].value, b.settings[i].value);
        EXPECT_EQ(a.settings[i].quoted, b.settings[i].quoted);
    }
    EXPECT_EQ(a.manifest.command, "the command");
    EXPECT_EQ(a.manifest.version, SSPQL_VERSION);
    EXPECT_EQ(a.manifest.compiler, b.manifest.compiler);
    ASSERT_EQ(a.phases.size(), b.phases.size());
    for (std::size_t p = 0; p < a.phases.size(); ++p) {
        EXPECT_EQ(a.phases[p].name, b.phases[p].name);
        expect_same(a.phases[p].optimal_steps, b.phases[p].optimal_steps);
        expect_same(a.phases[p].optimal_return, b.phases[p].optimal_return);
        EXPECT_EQ(a.phases[p].report_at, b.phases[p].report_at);
        ASSERT_EQ(a.phases[p].learners.size(), b.phases[p].learners.size());
        for (std::size_t i = 0; i < a.phases[p].learners.size(); ++i) {
            EXPECT_EQ(a.phases[p].learners[i].name, b.phases[p].learners[i].name);
            ASSERT_EQ(a.phases[p].learners[i].runs.size(), b.phases[p].learners[i].runs.size());
            for (std::size_t k = 0; k < b.phases[p].learners[i].runs.size(); ++k) {
                expect_same(a.phases[p].learners[i].runs[k], b.phases[p].learners[i].runs[k]);
            }
        }
    }
}

TEST(ShardMerge, OfThePusherKeepsEveryField) {
    const report::PusherFindings original = pusher_findings();
    for (std::size_t count = 1; count <= 7; ++count) {
        const report::PusherFindings again = merged("pusher_experiment", original, count);
        expect_same(again.results, original.results);
        ASSERT_EQ(again.typical_paths.size(), 2u);
        for (std::size_t i = 0; i < 2; ++i) {
            ASSERT_EQ(again.typical_paths[i].size(), original.typical_paths[i].size());
            for (std::size_t j = 0; j < again.typical_paths[i].size(); ++j) {
                const report::ArenaPath& a = again.typical_paths[i][j];
                const report::ArenaPath& b = original.typical_paths[i][j];
                EXPECT_EQ(a.name, b.name);
                ASSERT_EQ(a.poses.size(), b.poses.size());
                for (std::size_t k = 0; k < a.poses.size(); ++k) {
                    EXPECT_TRUE(same_bits(a.poses[k].x_m, b.poses[k].x_m));
                    EXPECT_TRUE(same_bits(a.poses[k].y_m, b.poses[k].y_m));
                    EXPECT_TRUE(same_bits(a.poses[k].heading_rad, b.poses[k].heading_rad));
                }
            }
        }
    }
}

TEST(ShardMerge, OfGridsKeepsEveryField) {
    const report::GridFindings original = grid_findings();
    for (std::size_t count = 1; count <= 7; ++count) {
        const report::GridFindings again = merged("grid_experiment", original, count);
        expect_same(again.results, original.results);
        EXPECT_EQ(again.checksums, original.checksums);
        ASSERT_EQ(again.pictures.size(), 2u);
        for (std::size_t p = 0; p < 2; ++p) {
            EXPECT_EQ(again.pictures[p].caption, original.pictures[p].caption);
            ASSERT_EQ(again.pictures[p].learners.size(), original.pictures[p].learners.size());
            for (std::size_t i = 0; i < again.pictures[p].learners.size(); ++i) {
                const report::GridPicture& a = again.pictures[p].learners[i];
                const report::GridPicture& b = original.pictures[p].learners[i];
                EXPECT_EQ(a.rows, b.rows);
                EXPECT_EQ(a.columns, b.columns);
                EXPECT_EQ(a.value_name, b.value_name);
                ASSERT_EQ(a.cells.size(), b.cells.size());
                for (std::size_t c = 0; c < a.cells.size(); ++c) {
                    EXPECT_EQ(a.cells[c].kind, b.cells[c].kind);
                    expect_same(a.cells[c].value, b.cells[c].value);
                    EXPECT_EQ(a.cells[c].action, b.cells[c].action);
                    EXPECT_EQ(a.cells[c].why, b.cells[c].why);
                    EXPECT_EQ(a.cells[c].why, b.cells[c].why);
                }
            }
        }
    }
}

/// What merging the first shard with this one says.
std::string error_of(ShardContent second) {
    Merge<report::PusherFindings> merge;
    merge.add(content_of("pusher_experiment", pusher_findings(), {0, 3}, "the command"), "one");
    try {
        merge.add(second, "two");
        static_cast<void>(merge.take());
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "no error";
}

ShardContent second_shard(std::size_t index = 1, std::size_t count = 3) {
    return content_of("pusher_experiment", pusher_findings(), {index, count}, "the command");
}

TEST(ShardMerge, RefusesShardsThatDoNotBelongTogether) {
    EXPECT_EQ(error_of(second_shard()), "missing of the run that one is of: shard 3/3");
    EXPECT_EQ(error_of(second_shard(0)), "two: shard 1/3 was given before, as one");
    EXPECT_EQ(error_of(second_shard(1, 4)), "two: of another run than one: shards is 4, not 3");

    const auto changed = [](const char* pointer, const Json& value) {
        ShardContent content = second_shard();
        content.run[Json::json_pointer(pointer)] = value;
        return error_of(content);
    };
    const std::string other = "two: of another run than one: ";
    EXPECT_EQ(changed("/program", "grid_experiment"),
              other + "program is \"grid_experiment\", not \"pusher_experiment\"");
    EXPECT_EQ(changed("/version", "9.9.9"), other + "version is \"9.9.9\", not \"" SSPQL_VERSION "\"");
    EXPECT_EQ(changed("/settings/noise", "0.25"), other + "settings.noise is \"0.25\", not \"0.5\"");
    EXPECT_EQ(changed("/settings/extra", "1"), other + "settings.extra is \"1\", not absent");
    EXPECT_EQ(changed("/phases/0/learners/1", "q"), other + "phases[0].learners[1] is \"q\", not \"learner100\"");
    EXPECT_EQ(changed("/phases/0/report_at", Json::array()), other + "phases[0].report_at is [], not [10,20]");
    EXPECT_EQ(changed("/phases/0/seeds", 6), other + "phases[0].seeds is 6, not 5");

    ShardContent content = second_shard();
    content.run["settings"].erase("set");
    EXPECT_EQ(error_of(content), other + "settings.set is not there");
}

TEST(ShardMerge, NamesAFewOfManyMissingShards) {
    ShardSet set;
    set.add(second_shard(5, 40), "s");
    try {
        set.require_complete();
        FAIL() << "39 of 40 are missing";
    } catch (const std::runtime_error& error) {
        EXPECT_STREQ(error.what(),
                     "missing of the run that s is of: shards 1/40, 2/40, 3/40, 4/40, 5/40, 7/40, 8/40, 9/40, 10/40, "
                     "11/40 and 29 more");
    }
}

TEST(ShardMerge, NamesAllCompilers) {
    ShardSet set;
    for (std::size_t i = 0; i < 3; ++i) {
        ShardContent content = second_shard(i);
        if (i == 1) content.compiler = "clang++ 14";
        set.add(content, "s" + std::to_string(i));
    }
    EXPECT_EQ(set.compilers(), "g++ 12.2.0, clang++ 14");
}

}  // namespace
}  // namespace sspql::shards
