// SPDX-License-Identifier: MIT
#include <sspql/run/parallel.hpp>

#include <atomic>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

using sspql::parallel_for;

TEST(ParallelForThreads, RunsEveryIndexOnce) {
    for (const std::size_t threads : {0u, 1u, 2u, 3u, 8u, 100u}) {
        for (const std::size_t count : {0u, 1u, 2u, 7u, 1000u}) {
            std::vector<int> runs(count, 0);  // each i writes to its own place only
            parallel_for(count, threads, [&](std::size_t i) { ++runs[i]; });
            EXPECT_EQ(runs, std::vector<int>(count, 1)) << threads << " threads, " << count << " tasks";
        }
    }
}

TEST(ParallelForThreads, OneThreadIsTheCallersAndKeepsTheOrder) {
    std::vector<std::size_t> order;
    const auto caller = std::this_thread::get_id();
    parallel_for(10, 1, [&](std::size_t i) {
        EXPECT_EQ(std::this_thread::get_id(), caller);
        order.push_back(i);
    });
    for (std::size_t i = 0; i < 10; ++i) EXPECT_EQ(order[i], i);
}

TEST(ParallelForThreads, PassesOnTheExceptionOfTheSmallestIndexThatThrew) {
    for (const std::size_t threads : {1u, 2u, 4u}) {
        for (int repetition = 0; repetition < 50; ++repetition) {
            std::vector<char> threw(200, 0);
            std::atomic<int> starts{0};
            std::string text;
            try {
                parallel_for(200, threads, [&](std::size_t i) {
                    ++starts;
                    if (i % 3 == 2) {
                        threw[i] = 1;
                        throw std::runtime_error(std::to_string(i));
                    }
                });
            } catch (const std::runtime_error& error) {
                text = error.what();
            }
            std::size_t smallest = 0;
            while (smallest < threw.size() && threw[smallest] == 0) ++smallest;
            EXPECT_EQ(text, std::to_string(smallest)) << threads << " threads";
            EXPECT_LE(starts, 200);
        }
    }
}

TEST(ParallelForThreads, StartsNoNewTaskAfterAnException) {
    std::atomic<int> starts{0};
    EXPECT_THROW(parallel_for(1000, 1,
                              [&](std::size_t i) {
                                  ++starts;
                                  if (i == 3) throw 42;
                              }),
                 int);
    EXPECT_EQ(starts, 4);
}

TEST(ParallelForThreads, RunsTasksOfVeryDifferentLength) {
    std::vector<double> sums(64, 0.0);
    parallel_for(sums.size(), 4, [&](std::size_t i) {
        for (std::size_t k = 0; k < (i % 8 == 0 ? 20000u : 10u); ++k) sums[i] += static_cast<double>(k);
    });
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const double n = i % 8 == 0 ? 20000.0 : 10.0;
        EXPECT_EQ(sums[i], n * (n - 1.0) / 2.0);
    }
}
