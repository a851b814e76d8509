// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include "report/shard_testing.hpp"
#include "shards/merge.hpp"

namespace sspql::shards {
namespace {

template <class Call>
std::string error_of(Call call) {
    try {
        call();
    } catch (const std::exception& error) {
        return error.what();
    }
    return "no error";
}

TEST(Shard, EveryUnitIsInOneShardAndTheyAreAlikeLong) {
    for (std::size_t count = 1; count <= 9; ++count) {
        for (std::size_t units = 0; units <= 20; ++units) {
            std::vector<int> seen(units, 0);
            for (std::size_t index = 0; index < count; ++index) {
                const Shard shard{index, count};
                const std::size_t share = shard.share(units);
                EXPECT_TRUE(share == units / count || share == units / count + 1) << text_of(shard) << " of " << units;
                for (std::size_t j = 0; j < share; ++j) {
                    ASSERT_LT(shard.unit(j), units);
                    EXPECT_TRUE(shard.has(shard.unit(j)));
                    ++seen[shard.unit(j)];
                }
            }
            EXPECT_EQ(seen, std::vector<int>(units, 1)) << count << " shards";
        }
    }
}

TEST(Shard, IsWrittenFromOne) {
    EXPECT_EQ(text_of(parse_shard("1/1")), "1/1");
    const Shard last = parse_shard("100000/100000");
    EXPECT_EQ(last.index, 99999u);
    EXPECT_EQ(last.count, 100000u);
    for (const char* text : {"0/4", "5/4", "x", "1/0", "", "1", "1/", "/4", "1/4/4", "-1/4", "1/-4", " 1/4", "1/4 ",
                             "1.0/4", "1/100001", "99999999999999999999/99999999999999999999"}) {
        EXPECT_NE(error_of([&] { static_cast<void>(parse_shard(text)); }).find("got '" + std::string(text) + "'"),
                  std::string::npos)
            << text;
    }
}

ShardContent shard_of_three(std::size_t index) {
    return content_of("pusher_experiment", pusher_findings(), {index, 3}, "pusher_experiment --seeds 5");
}

std::string error_of_text(const std::string& text) {
    return error_of([&] { static_cast<void>(parse_shard_text(text, "s")); });
}

TEST(ShardFile, ReadsWhatItWrote) {
    const ShardContent content = shard_of_three(1);
    const ShardContent again = parse_shard_text(shard_text(content), "s");
    EXPECT_EQ(again.run, content.run);
    EXPECT_EQ(again.part, content.part);
    EXPECT_EQ(again.shard.index, 1u);
    EXPECT_EQ(again.shard.count, 3u);
    EXPECT_EQ(again.command, "pusher_experiment --seeds 5");
    EXPECT_EQ(again.compiler, "g++ 12.2.0");
    EXPECT_EQ(again.program(), "pusher_experiment");
}

TEST(ShardFile, NoticesEveryCut) {
    const std::string text = shard_text(shard_of_three(0));
    const std::size_t line = text.find('\n');
    for (std::size_t size = 0; size < text.size(); size += size < line + 20 || size + 20 > text.size() ? 1 : 97) {
        const std::string error = error_of_text(text.substr(0, size));
        EXPECT_NE(error.find(size == 0      ? "s: the file is empty"
                             : size <= line ? "s: not a shard file"
                                            : "s: damaged shard file: " + std::to_string(size) + " bytes"),
                  std::string::npos)
            << size << ": " << error;
    }
    EXPECT_NE(error_of_text(text + "\n").find("damaged"), std::string::npos);
}

TEST(ShardFile, NoticesEveryChangedByteOfItsContent) {
    std::string text = shard_text(shard_of_three(0));
    const std::size_t end = text.size() - 4;
    for (std::size_t i = text.find('\n') + 1; i < end; i += 13) {
        text[i] = static_cast<char>(text[i] ^ 1);
        EXPECT_NE(error_of_text(text).find("s: damaged shard file: its checksum"), std::string::npos) << i;
        text[i] = static_cast<char>(text[i] ^ 1);
    }
    EXPECT_EQ(error_of_text(text), "no error");
}

TEST(ShardFile, NamesTheFieldThatIsWrong) {
    const auto error_with = [](const char* pointer, const Json& value) {
        ShardContent content = shard_of_three(0);
        Json all = {{"run", content.run}, {"part", content.part}};
        all[Json::json_pointer(pointer)] = value;
        content.run = all["run"];
        content.part = all["part"];
        return error_of([&] {
            Merge<report::PusherFindings> merge;
            merge.add(parse_shard_text(shard_text(content), "s"), "s");
        });
    };
    const std::string damaged = "s: damaged shard file: field ";
    EXPECT_EQ(error_with("/part/runs/0/1/0/seed", "x"),
              damaged + "runs[0][1][0].seed must be a whole number in range, is \"x\"");
    EXPECT_EQ(error_with("/part/runs/0/1/0/seed", -1),
              damaged + "runs[0][1][0].seed must be a whole number in range, is -1");
    EXPECT_EQ(error_with("/part/runs/0/1/1/steps/3", 4294967296),
              damaged + "runs[0][1][1].steps[3] must be a whole number in range, is 4294967296");
    EXPECT_EQ(error_with("/part/runs/0/1/0/returns/2", "infinite"),
              damaged + "runs[0][1][0].returns[2] must be a number, is \"infinite\"");
    EXPECT_EQ(error_with("/part/runs/0/0/0/success", "111"), damaged + "runs[0][0][0] has lists of different lengths");
    EXPECT_EQ(error_with("/part/runs/0/0/0/capped", "00000000x"),
              damaged + "runs[0][0][0] has episode flags that are neither 0 nor 1");
    EXPECT_EQ(error_with("/part/runs/0/0", Json::array()), damaged + "runs[0][0] must be a list of 2, has 0");
    EXPECT_EQ(error_with("/part/runs", 3), damaged + "runs must be a list, is 3");
    EXPECT_EQ(error_with("/part", Json::object()), damaged + "runs is missing");
    EXPECT_EQ(error_with("/run/phases/0/optimal_steps", "few"),
              damaged + "phases[0].optimal_steps must be a number, is \"few\"");
    EXPECT_EQ(error_with("/run/shards", 0), damaged + "shard must be from 1 to 0");
}

TEST(ShardFile, OfAnotherFormatIsRefused) {
    std::string text = shard_text(shard_of_three(0));
    text.replace(text.find("\"format_version\":1"), 18, "\"format_version\":2");
    EXPECT_EQ(error_of_text(text), "s: shard format 2, this merge_results reads format 1");
    for (const char* other :
         {"{}", "{\"experiment\": \"pusher_experiment\",\n", "\n\n", "null", "[\n", "{\"format\":\n"}) {
        EXPECT_NE(error_of_text(other).find("s: not a shard file"), std::string::npos) << other;
    }
}

}  // namespace
}  // namespace sspql::shards
