// SPDX-License-Identifier: MIT
// A step log on a full disk.
#include <sspql/io/step_log.hpp>

#include <gtest/gtest.h>

#include <sys/resource.h>

#include <cstddef>
#include <stdexcept>
#include <string>

#include <sspql/io/step_log_reader.hpp>

#include "io/file_testing.hpp"
#include "io/logged_steps.hpp"

namespace sspql {
namespace {

using testing::content;
using testing::error_of;
using testing::in_child;
using testing::limit_files_to;

using StepLogFullDisk = testing::FileTest;

using sspql::testing::header;
using sspql::testing::step;

// The disk is full in the middle of a line; then there is room again. Nothing is missing and nothing twice.
TEST_F(StepLogFullDisk, IsReportedAndCaughtUpWith) {
    const std::string name = path("run.csv");
    EXPECT_TRUE(in_child([&] {
        StepLogOptions options;
        options.flush = LogFlush::every_step;
        StepLog log(name, options);
        if (!limit_files_to(header.size() + 20)) return false;
        log.write(step(0, 0, 0.0, 1));
        const std::string expected = "cannot write " + name + ": File too large";
        if (error_of<std::runtime_error>([&] { log.write(step(1, 0, 0.0, 2)); }) != expected) return false;
        if (error_of<std::runtime_error>([&] { log.write(step(2, 0, 0.0, 3, true)); }) != expected) return false;
        if (!limit_files_to(1 << 20)) return false;
        log.write(step(7, 0, 0.0, 8));
        return true;
    }));
    EXPECT_EQ(content(name), header + "0,0,0,0,0,1,0,0\n0,1,1,0,0,2,0,0\n0,2,2,0,0,3,1,0\n1,0,7,0,0,8,0,0\n");
}

// A caller that ignores the errors is refused in the end; up to there every step is kept.
TEST_F(StepLogFullDisk, WhatIsKeptBackIsBounded) {
    std::size_t kept = 0;
    {
        StepLogOptions options;
        options.synchronise = false;
        StepLog log(path("run.csv"), options);
        rlimit before{};
        ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
        ASSERT_TRUE(limit_files_to(1000));
        for (;; ++kept) {  // a step that was not kept leaves the next one without its beginning
            ASSERT_LT(kept, 60000u);
            const auto write = [&] { log.write(step(kept, 0, 0.0, kept + 1)); };
            if (error_of<std::invalid_argument>(write).rfind("state must be where", 0) == 0) break;
        }
        ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
        --kept;
        EXPECT_GT(kept, 30000u);
        log.write(step(kept, 0, 0.0, kept + 1));
    }
    const StepLogContent log = for_each_step(path("run.csv"), [](const LoggedStep&) {});
    EXPECT_EQ(log.steps, kept + 1);
    EXPECT_EQ(log.cut_line, 0u);
}

}  // namespace
}  // namespace sspql
