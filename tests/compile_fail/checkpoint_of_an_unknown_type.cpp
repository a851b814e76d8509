// expect: sspql: this type cannot be saved; it lacks `template <class Archive> void serialize(Archive&)`
// SPDX-License-Identifier: MIT
#include <sspql/sspql.hpp>

struct Diary {
    int* page = nullptr;
};

void write(const sspql::QLearning<>& learner, const Diary& diary) { sspql::save(learner, "robot", diary); }
