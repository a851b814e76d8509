// SPDX-License-Identifier: MIT
#include "experiment/live_run.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "experiment/runner.hpp"

namespace sspql::experiment {

LiveRun::LiveRun(std::unique_ptr<LiveWorld> world, std::vector<LearnerRecipe> recipes, std::uint64_t seed)
    : world_(std::move(world)), recipes_(std::move(recipes)), seed_(seed) {
    if (recipes_.empty()) throw std::invalid_argument("a run needs at least one learner");
    begin_run();
}

void LiveRun::begin_run() {
    learner_ = recipes_[learner_index_].make(world_->states(), world_->actions(), seed_);
    episodes_.clear();
    trail_.clear();
    total_steps_ = 0;
    begin_episode();
}

void LiveRun::begin_episode() {
    observation_ = world_->reset(episode_seed(seed_, episodes_.size()));
    last_trail_ = std::move(trail_);
    trail_.assign(1, observation_.robot);
    last_.reset();
    episode_over_ = false;
    decide(learner_->begin(world_->encode(observation_)));
}

void LiveRun::decide(ActionId action) {
    Decision decision;
    decision.state = world_->encode(observation_);
    decision.action = action;
    for (std::size_t a = 0; a < world_->actions(); ++a) {
        decision.terms.push_back(learner_->terms(decision.state, action_id(a)));
    }
    next_ = std::move(decision);
}

void LiveRun::tick() {
    if (is_over()) return;
    if (episode_over_) {
        begin_episode();
    } else {
        act();
    }
}

void LiveRun::act() {
    const auto step = world_->step(next_->action);
    observation_ = step.observation;
    trail_.push_back(observation_.robot);
    ++total_steps_;
    last_ = std::exchange(next_, std::nullopt);
    const StateId s = world_->encode(observation_);
    if (step.terminated || step.truncated) {
        learner_->end(step.reward, s, step.terminated);
        episodes_.push_back({episode_steps(), step.terminated && step.reward > 0.0});
        episode_over_ = true;
    } else {
        decide(learner_->step(step.reward, s));
    }
}

void LiveRun::choose_learner(std::size_t learner) {
    if (learner >= recipes_.size()) {
        throw std::invalid_argument("there are " + std::to_string(recipes_.size()) + " learners, no number " +
                                    std::to_string(learner));
    }
    learner_index_ = learner;
    begin_run();
}

void LiveRun::restart(std::uint64_t seed) {
    seed_ = seed;
    begin_run();
}

StateView LiveRun::view(StateId s) const {
    StateView view;
    for (std::size_t a = 0; a < world_->actions(); ++a) {
        const ActionTerms terms = learner_->terms(s, action_id(a));
        if (!(terms.n > 0.0)) continue;
        const double worth = terms.q + terms.ssp + terms.hint;
        view.value = view.tried ? std::max(view.value, worth) : worth;
        view.tried = true;
    }
    if (view.tried) view.best = learner_->best(s);
    return view;
}

}  // namespace sspql::experiment
