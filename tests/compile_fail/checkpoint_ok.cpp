// SPDX-License-Identifier: MIT
#include <sspql/sspql.hpp>

struct Diary {
    int page = 0;
    template <class Archive>
    void serialize(Archive& archive) {
        archive(page);
    }
};

void write(const sspql::QLearning<>& learner, const Diary& diary) { sspql::save(learner, "robot", diary); }
