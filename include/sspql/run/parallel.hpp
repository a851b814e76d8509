// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace sspql {

/// Calls task(i) once for every i in 0 .. count - 1, on up to `threads` threads (0: as many as the machine has; 1: on
/// the calling thread). Which thread runs which i is open, so a task may only write to what belongs to its i; then
/// results do not depend on the number of threads. If tasks throw, no new ones start and the exception of the smallest
/// i among those that threw passes on.
template <class Task>
void parallel_for(std::size_t count, std::size_t threads, Task&& task) {
    if (threads == 0) threads = std::max(1u, std::thread::hardware_concurrency());
    threads = std::min(threads, count);
    if (threads <= 1) {
        for (std::size_t i = 0; i < count; ++i) task(i);
        return;
    }
    std::atomic<std::size_t> next{0};
    std::mutex mutex;
    std::exception_ptr error;
    std::size_t failed = count;
    const auto work = [&] {
        for (std::size_t i = next++; i < count; i = next++) {
            try {
                task(i);
            } catch (...) {
                const std::lock_guard<std::mutex> lock(mutex);
                next = count;
                if (i < failed) {
                    failed = i;
                    error = std::current_exception();
                }
            }
        }
    };
    std::vector<std::thread> workers;
    workers.reserve(threads - 1);
    try {
        for (std::size_t t = 1; t < threads; ++t) workers.emplace_back(work);
    } catch (...) {  // fewer threads than asked for do the same work
    }
    work();
    for (std::thread& worker : workers) worker.join();
    if (error) std::rethrow_exception(error);
}

}  // namespace sspql
