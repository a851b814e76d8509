// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <sspql/core/ids.hpp>
#include <sspql/core/random.hpp>
#include <sspql/io/checkpoint.hpp>
#include <sspql/io/checkpoint_format.hpp>
#include <sspql/io/crc32.hpp>
#include <sspql/spaces/action_set.hpp>

/// \file
/// What tests of checkpoints share: a world in which everything happens that a learner keeps account of, and checksums
/// for files that were changed on purpose.

namespace sspql::testing {

/// Two actions, whose commands are their numbers.
struct TwoCommands {
    [[nodiscard]] std::size_t size() const { return 2; }
    [[nodiscard]] int decode(ActionId a) const { return static_cast<int>(a); }
};

/// A walk on `states` states in a ring, one step in five to a random state: rewards, step costs from time to time,
/// weights, masks, hints, steps of others, episodes that end, are cut and are aborted. Copy it to fork the story.
class Story {
public:
    explicit Story(std::uint64_t seed, std::size_t states) : random_(seed), states_(states) {}

    template <class L>
    void go_on(L& learner, std::size_t steps) {
        for (std::size_t k = 0; k < steps; ++k) step(learner);
    }

private:
    template <class L>
    void step(L& learner) {
        if (!learner.running()) {
            at_ = learner.grows() ? random_.below(std::min(learner.states() + 1, states_)) : random_.below(states_);
            static_cast<void>(learner.begin(state_id(at_)));
            return;
        }
        const std::size_t most = learner.grows() ? std::min(learner.states() + 1, states_) : states_;
        const std::size_t chance = random_.below(100);
        at_ = chance < 80 ? (at_ + 1 + index(learner.action())) % most : random_.below(most);
        const std::size_t event = random_.below(200);
        const double weight = event < 20 ? 1.0 + random_.uniform() : 1.0;
        if (at_ == 0) return learner.end(1.0, state_id(at_), true, weight);
        if (event == 0) return learner.end(-0.25, state_id(at_), false);
        if (event == 1) return learner.abort();
        if (event == 2) learner.replace_action(action_id(random_.below(learner.actions())));
        if (event == 3) learner.teach(state_id(at_), action_id(random_.below(learner.actions())), 0.3);
        if (event == 4) {
            const std::size_t s = random_.below(learner.states());
            const std::size_t next = random_.below(learner.states());
            learner.observe(state_id(s), action_id(random_.below(learner.actions())), 0.0, state_id(next), false);
        }
        if (event == 5 && learner.actions() > 1) {
            ActionSet mask = ActionSet::all(learner.actions());
            mask.erase(action_id(random_.below(learner.actions())));
            learner.set_legal_actions(state_id(at_), mask);
            // What was chosen may be illegal now; begin anew.
            return learner.abort();
        }
        static_cast<void>(learner.step(event < 30 ? -0.01 : 0.0, state_id(at_), weight));
    }

    Random random_;
    std::size_t states_;
    std::size_t at_ = 0;
};

/// The bytes of a checkpoint with the checksums of all its sections set right; "" if its structure is broken.
inline std::string with_checksums(std::string bytes) {
    const auto four = [&](std::size_t at) {
        return detail::from_little_endian(reinterpret_cast<const unsigned char*>(bytes.data()) + at);
    };
    const auto set = [&](std::size_t begin, std::size_t end) {
        detail::Crc32 crc;
        crc.add(bytes.data() + begin, end - begin);
        const auto sum = detail::little_endian(crc.value());
        std::copy(sum.begin(), sum.end(), bytes.begin() + static_cast<std::ptrdiff_t>(end));
    };
    constexpr std::size_t header = 16;
    if (bytes.size() < header + 4) return {};
    set(0, header);
    for (std::size_t begin = header + 4; begin < bytes.size();) {
        std::size_t at = begin + detail::section_name_size;
        for (;;) {
            if (at + 4 > bytes.size()) return {};
            const std::size_t size = four(at);
            at += 4;
            if (size == 0) break;
            if (size > detail::largest_chunk || size > bytes.size() - at) return {};
            at += size;
        }
        if (at + 4 > bytes.size()) return {};
        set(begin, at);
        begin = at + 4;
    }
    return bytes;
}

}  // namespace sspql::testing
