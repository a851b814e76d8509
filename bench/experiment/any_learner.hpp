// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <utility>

#include <sspql/core/ids.hpp>
#include <sspql/io/explain.hpp>
#include <sspql/learn/transition.hpp>
#include <sspql/spaces/action_set.hpp>

namespace sspql::experiment {

/// A learner whose type is chosen when the program runs: the part of the Learner interface an experiment needs.
class AnyLearner {
public:
    AnyLearner() = default;
    AnyLearner(const AnyLearner&) = delete;
    AnyLearner& operator=(const AnyLearner&) = delete;
    virtual ~AnyLearner() = default;

    [[nodiscard]] virtual ActionId begin(StateId s) = 0;
    [[nodiscard]] virtual ActionId step(double reward, StateId next) = 0;
    virtual void end(double reward, StateId next, bool terminated) = 0;
    virtual void abort() noexcept = 0;
    [[nodiscard]] virtual ActionId best(StateId s) const = 0;
    [[nodiscard]] virtual ActionTerms terms(StateId s, ActionId a) const = 0;
    [[nodiscard]] virtual Explanation explain(StateId s) const = 0;
    virtual void set_legal_actions(StateId s, const ActionSet& mask) = 0;
    [[nodiscard]] virtual std::uint64_t model_operations() const = 0;
};

template <class Learner>
class LearnerBox final : public AnyLearner {
public:
    explicit LearnerBox(Learner learner) : learner_(std::move(learner)) {}

    [[nodiscard]] ActionId begin(StateId s) override { return learner_.begin(s); }
    [[nodiscard]] ActionId step(double reward, StateId next) override { return learner_.step(reward, next); }
    void end(double reward, StateId next, bool terminated) override { learner_.end(reward, next, terminated); }
    void abort() noexcept override { learner_.abort(); }
    [[nodiscard]] ActionId best(StateId s) const override { return learner_.best(s); }
    [[nodiscard]] ActionTerms terms(StateId s, ActionId a) const override { return learner_.terms(s, a); }
    [[nodiscard]] Explanation explain(StateId s) const override { return sspql::explain(learner_, s); }
    void set_legal_actions(StateId s, const ActionSet& mask) override { learner_.set_legal_actions(s, mask); }
    [[nodiscard]] std::uint64_t model_operations() const override { return learner_.model_operations(); }

private:
    Learner learner_;
};

}  // namespace sspql::experiment
