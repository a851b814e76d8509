// SPDX-License-Identifier: MIT
// Any bytes as a checkpoint, as they are and with all checksums set right: a forgery gets as far as it can. It is refused
// and leaves the learner as it was, or gives a learner that works.
#include <sspql/io/checkpoint.hpp>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>

#include <sspql/core/concepts.hpp>
#include <sspql/learn/dyna_q.hpp>
#include <sspql/learn/dyna_q_plus.hpp>
#include <sspql/learn/prioritized_sweeping.hpp>
#include <sspql/learn/q_learning.hpp>
#include <sspql/learn/r_max.hpp>
#include <sspql/learn/sspql.hpp>
#include <sspql/spaces/hashed_state.hpp>

#include "fuzz/fuzz_testing.hpp"
#include "io/checkpoint_testing.hpp"

namespace {

using namespace sspql;
using sspql::fuzz::require;
using sspql::testing::Story;
using sspql::testing::TwoCommands;

template <class Params>
using PlanningSteps = decltype(std::declval<const Params&>().planning_steps);

/// Whether a forger chose parameters that keep a learner busy for ever: that is his right.
template <class Params>
bool slow(const Params& params) {
    if constexpr (detail::is_detected_v<PlanningSteps, Params>) return params.planning_steps > 1000;
    return false;
}

/// \param fresh what the bytes are loaded into a copy of; as it is saved: before.
template <class T>
void load_into(const T& fresh, const std::string& before, const std::string& bytes) {
    T object = fresh;
    try {
        load_from_bytes(bytes, object, "input");
    } catch (const std::runtime_error& error) {
        require(std::string(error.what()).rfind("checkpoint input: ", 0) == 0, "the error names the file");
        require(save_to_bytes(object) == before, "a refused file changes nothing");
        return;
    }
    const std::string saved = save_to_bytes(object);
    load_from_bytes(saved, object, "again");
    require(save_to_bytes(object) == saved, "what was loaded can be saved and loaded");
    if constexpr (!detail::IsAgent<T>::value) {
        if (slow(object.params())) return;
        Story(1, object.states()).go_on(object, 60);
        for (std::size_t s = 0; s < object.states(); ++s) {
            static_cast<void>(object.best(state_id(s)));
            static_cast<void>(object.terms(state_id(s), action_id(0)));
        }
    }
}

/// Making learners takes longer than loading them: each is made once.
template <class T>
struct Target {
    T fresh;
    std::string saved = save_to_bytes(fresh);
    void load(const std::string& bytes) const { load_into(fresh, saved, bytes); }
};

void load_all(const std::string& bytes) {
    static const Target<Sspql<>> sspql{Sspql<>(3, 2)};
    static const Target<AdaptiveSspql<>> adaptive{AdaptiveSspql<>(3, 2)};
    static const Target<DynaQ<>> dyna_q{DynaQ<>(3, 2)};
    static const Target<DynaQPlus<>> dyna_q_plus{DynaQPlus<>(3, 2)};
    static const Target<PrioritizedSweeping<>> sweeping{PrioritizedSweeping<>(3, 2)};
    static const Target<RMax<>> r_max{RMax<>(3, 9)};
    using Robot = Agent<HashedState<std::string>, TwoCommands, QLearning<>>;
    static const Target<Robot> robot{Robot(HashedState<std::string>{}, TwoCommands{})};
    sspql.load(bytes);
    adaptive.load(bytes);
    dyna_q.load(bytes);
    dyna_q_plus.load(bytes);
    sweeping.load(bytes);
    r_max.load(bytes);
    robot.load(bytes);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string bytes(sspql::fuzz::text_of(data, size));
    load_all(bytes);
    const std::string forged = sspql::testing::with_checksums(bytes);
    if (!forged.empty() && forged != bytes) load_all(forged);
    return 0;
}
