// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <sspql/core/ids.hpp>
#include <sspql/io/explain.hpp>
#include <sspql/learn/transition.hpp>
#include <sspql/model/transition_counts.hpp>
#include <sspql/paths/shortest_paths.hpp>

#include "parameters.hpp"

namespace sspql::python {

/// A number as it comes from Python: checked, before it becomes an id.
using Number = std::int64_t;

/// A learner's counts, if it keeps any.
using CountsPointer =
    std::variant<std::monostate, const TransitionCounts<CountCell>*, const TransitionCounts<FadingCell>*>;

/// A learner of any kind, with a fixed number of states: what Python sees. Members do what those of the same name in
/// learn/learner.hpp do and throw what they throw; ids are checked here, since they come as 64-bit numbers. What a kind
/// of learner does not have throws std::logic_error.
class AnyLearner {
public:
    AnyLearner() = default;
    AnyLearner(const AnyLearner&) = delete;
    AnyLearner& operator=(const AnyLearner&) = delete;
    virtual ~AnyLearner() = default;

    [[nodiscard]] virtual std::size_t states() const = 0;
    [[nodiscard]] virtual std::size_t actions() const = 0;
    [[nodiscard]] virtual bool running() const = 0;
    [[nodiscard]] virtual Number state() const = 0;   ///< -1: no episode
    [[nodiscard]] virtual Number action() const = 0;  ///< -1: no episode

    [[nodiscard]] virtual Number begin(Number s) = 0;
    [[nodiscard]] virtual Number step(double reward, Number next, double weight) = 0;
    virtual void end(double reward, Number next, bool terminated, double weight) = 0;
    virtual void abort() = 0;
    virtual void replace_action(Number a) = 0;
    virtual void observe(Number s, Number a, double reward, Number next, bool terminated, double weight) = 0;
    virtual void teach(Number s, Number a, double strength) = 0;
    virtual void demonstrate(Number s, Number a, double reward, Number next, bool terminated, double weight,
                             double strength) = 0;
    [[nodiscard]] virtual Number best(Number s) const = 0;
    [[nodiscard]] virtual ActionTerms terms(Number s, Number a) const = 0;
    virtual void set_goals(const std::vector<std::pair<Number, double>>& goals) = 0;
    virtual void set_legal_actions(Number s, const std::vector<bool>& mask) = 0;
    [[nodiscard]] virtual std::vector<bool> legal_actions(Number s) const = 0;

    /// states() x actions() values, row = state, at an address that never changes.
    [[nodiscard]] virtual const double* q() const = 0;
    [[nodiscard]] virtual std::vector<std::uint32_t> visits() const = 0;
    [[nodiscard]] virtual std::vector<std::pair<std::string, double>> status() const = 0;
    virtual void update_paths() = 0;

    /// What it keeps of a model; see model.hpp.
    [[nodiscard]] virtual CountsPointer counts() const = 0;
    [[nodiscard]] virtual std::optional<std::vector<Goal>> goals() const = 0;
    [[nodiscard]] virtual const ShortestPathTree* tree() const = 0;
    [[nodiscard]] virtual Explanation explain(Number s, const ShortestPathTree& tree,
                                              const ExplainOptions& options) const = 0;

    /// The parameters it works with.
    [[nodiscard]] virtual std::vector<std::pair<std::string, Value>> parameters() const = 0;

    /// What sspql::save would write to a file.
    [[nodiscard]] virtual std::string to_bytes() const = 0;

    /// Another learner of the same kind and size, as it was saved. `name` is what errors call the bytes.
    [[nodiscard]] virtual std::shared_ptr<AnyLearner> from_bytes(std::string_view bytes,
                                                                 const std::string& name) const = 0;
    [[nodiscard]] virtual std::shared_ptr<AnyLearner> copy() const = 0;
};

using Settings = std::vector<std::pair<std::string, Value>>;

/// A kind of learner: what there is to know before one is made. `preset` is empty or one of presets; \throws
/// std::invalid_argument for another, and what the learner's constructor throws.
struct Kind {
    std::string name;       ///< in Python
    std::string type_name;  ///< in checkpoints
    std::vector<std::string> presets;
    std::function<std::vector<Parameter>(const std::string& preset)> parameters;
    std::function<std::shared_ptr<AnyLearner>(Number states, Number actions, const std::string& preset,
                                              const Settings& settings, std::uint64_t seed)>
        make;
};

// A file each, so that they are compiled side by side.
Kind adaptive_sspql();
Kind sspql_of_the_paper();
Kind q_learning();
Kind sarsa();
Kind dyna_q();
Kind dyna_q_plus();
Kind prioritized_sweeping();
Kind rtdp();
Kind r_max();

}  // namespace sspql::python
