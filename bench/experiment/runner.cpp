// SPDX-License-Identifier: MIT
#include "experiment/runner.hpp"

#include <ctime>

namespace sspql::experiment {

double thread_time_ns() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e9 + static_cast<double>(now.tv_nsec);
}

double clock_cost_ns() {
    static const double cost = [] {
        double least = 1e9;
        for (int i = 0; i < 1000; ++i) {
            const double begun = thread_time_ns();
            const double spent = thread_time_ns() - begun;
            if (spent < least) least = spent;
        }
        return least;
    }();
    return cost;
}

}  // namespace sspql::experiment
