// SPDX-License-Identifier: MIT
// Saved and loaded learners against those that were not, for generated sizes, stories and places to stop; rapidcheck
// shrinks a failing one.
#ifdef SSPQL_HAS_RAPIDCHECK
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstddef>
#include <cstdint>
#include <string>

#include <sspql/learn/adaptive_sspql.hpp>
#include <sspql/learn/prioritized_sweeping.hpp>
#include <sspql/learn/sspql.hpp>

#include "io/checkpoint_testing.hpp"

namespace {

using namespace sspql;
using sspql::testing::Story;

/// Saves and loads between two stretches; then both learners must be the same, and stay so.
template <class L>
void resumes(const typename L::Params& params) {
    const auto states = static_cast<std::size_t>(*rc::gen::inRange(1, 50));
    const auto actions = static_cast<std::size_t>(*rc::gen::inRange(1, 12));
    const auto seed = static_cast<std::uint64_t>(*rc::gen::inRange(0, 1000));
    const auto before = static_cast<std::size_t>(*rc::gen::inRange(0, 400));
    const auto after = static_cast<std::size_t>(*rc::gen::inRange(0, 200));
    L learner(states, actions, params, seed);
    Story story(seed, states);
    story.go_on(learner, before);
    L loaded(states, actions);
    load_from_bytes(save_to_bytes(learner), loaded);
    Story same = story;
    story.go_on(learner, after);
    same.go_on(loaded, after);
    RC_ASSERT(save_to_bytes(loaded) == save_to_bytes(learner));
}

/// Any bytes are refused without a trace.
RC_GTEST_PROP(CheckpointProperty, RefusesAnyOtherBytes, ()) {
    Sspql<> learner(3, 2);
    const std::string before = save_to_bytes(learner);
    auto bytes = *rc::gen::container<std::string>(rc::gen::arbitrary<char>());
    RC_ASSERT_THROWS_AS(load_from_bytes(bytes, learner), std::runtime_error);
    const auto cut = static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(before.size())));
    bytes = before.substr(0, cut) + bytes;
    if (bytes != before) RC_ASSERT_THROWS_AS(load_from_bytes(bytes, learner), std::runtime_error);
    RC_ASSERT(save_to_bytes(learner) == before);
}

RC_GTEST_PROP(CheckpointProperty, SspqlResumes, ()) {
    SspqlParams<> params;
    params.path_budget = static_cast<std::uint64_t>(*rc::gen::inRange(0, 30));
    params.path_tolerance = *rc::gen::element(0.0, 0.01, 0.3);
    resumes<Sspql<>>(params);
}

RC_GTEST_PROP(CheckpointProperty, AdaptiveSspqlResumes, ()) {
    AdaptiveParams<> params;
    params.slice = static_cast<std::uint64_t>(*rc::gen::inRange(1, 200));
    params.trust.tau = *rc::gen::element(0.0, 5.0, 100.0);
    params.bound_by_paths = *rc::gen::arbitrary<bool>();
    resumes<AdaptiveSspql<>>(params);
}

RC_GTEST_PROP(CheckpointProperty, PrioritizedSweepingResumes, ()) {
    PrioritizedSweepingParams<> params;
    params.cap = *rc::gen::element(0.0, 3.0);
    params.planning_steps = static_cast<std::size_t>(*rc::gen::inRange(0, 5));
    resumes<PrioritizedSweeping<>>(params);
}

}  // namespace
#endif
