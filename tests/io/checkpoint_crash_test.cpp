// SPDX-License-Identifier: MIT
#include <sspql/io/checkpoint.hpp>

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <string>
#include <thread>

#include "io/checkpoint_testing.hpp"
#include "io/file_testing.hpp"

#include <sspql/core/random.hpp>

using namespace sspql;
using namespace sspql::testing;

namespace {

Sspql<> robot(std::size_t steps) {
    Sspql<> learner(300, 4, {}, steps);
    Story story(steps, 300);
    story.go_on(learner, steps);
    return learner;
}

}  // namespace

class CheckpointCrashSlow : public FileTest {};

/// 500 times a process that saves one robot, then another, over and over, is killed at some moment. When that is depends
/// on the machine's mood; whatever it is, the file must be one of the two.
TEST_F(CheckpointCrashSlow, AProcessKilledWhileSavingLosesNothing) {
    const Sspql<> first = robot(500);
    const Sspql<> second = robot(900);
    const std::string one = save_to_bytes(first);
    const std::string other = save_to_bytes(second);
    const std::string file = path("robot");
    save(first, file);
    Random random(1);
    std::size_t seen_one = 0;
    std::size_t seen_other = 0;
    for (int kill = 0; kill < 500; ++kill) {
        const pid_t child = ::fork();
        ASSERT_GE(child, 0);
        if (child == 0) {
            for (;;) {
                save(second, file);
                save(first, file);
            }
        }
        std::this_thread::sleep_for(std::chrono::microseconds(200 + random.below(4000)));
        ASSERT_EQ(::kill(child, SIGKILL), 0);
        int status = 0;
        ASSERT_EQ(::waitpid(child, &status, 0), child);
        ASSERT_TRUE(WIFSIGNALED(status)) << "the child ended by itself";
        const std::string found = content(file);
        ASSERT_TRUE(found == one || found == other) << "kill " << kill << " left a file of " << found.size() << " bytes";
        ++(found == one ? seen_one : seen_other);
        Sspql<> loaded(300, 4);
        load(file, loaded);
    }
    EXPECT_GT(seen_one, 0u);
    EXPECT_GT(seen_other, 0u);
}
