// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>

#include <sspql/core/errors.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/spaces/state_policy.hpp>

namespace sspql {

/// StatePolicy: the same observation seen by several StatePolicies at once, S = S1 x S2 x ... (the paper's
/// S_pos x S_heading, section 4.2). The last one varies fastest. Each factor encodes the whole observation; wrap it in
/// a ProjectedState to show it a part only. Factors must have a known size: one that grows would renumber the others.
///
/// \throws std::invalid_argument if the product exceeds 2^32 - 2 states.
template <class... Policies>
class ProductState {
    static_assert(sizeof...(Policies) >= 1, "sspql: a ProductState needs at least one factor");
    static_assert(!(grows_v<Policies> || ...), "sspql: a growing StatePolicy (HashedState) cannot be a factor of a "
                                               "ProductState; hash the whole observation instead");

public:
    /// The factors, the slowest first. They are kept by value.
    explicit ProductState(Policies... policies) : policies_(std::move(policies)...) {
        std::apply([this](const Policies&... factor) { (multiply(factor.size()), ...); }, policies_);
    }

    /// The number of states, the product of the factors' sizes.
    [[nodiscard]] std::size_t size() const noexcept { return size_; }

    template <class Observation, class = std::enable_if_t<(is_state_policy_v<Policies, Observation> && ...)>>
    /// The state of an observation. Calls every factor's encode, and throws what they throw.
    [[nodiscard]] StateId encode(const Observation& observation) {
        std::size_t id = 0;
        std::apply(
            [&](Policies&... factor) { ((id = id * factor.size() + index(factor.encode(observation))), ...); },
            policies_);
        return state_id(id);
    }

    /// The factors' descriptions, separated by "; ".
    [[nodiscard]] std::string describe(StateId s) const {
        std::size_t rest = index(detail::require_state_of(s, size_));
        std::size_t stride = size_;
        std::string text;
        std::apply(
            [&](const Policies&... factor) {
                ((stride /= factor.size(), text += (text.empty() ? "" : "; ") + describe_state(factor, state_id(rest / stride)),
                  rest %= stride),
                 ...);
            },
            policies_);
        return text;
    }

    /// The I-th factor.
    template <std::size_t I>
    [[nodiscard]] const auto& factor() const noexcept {
        return std::get<I>(policies_);
    }

private:
    void multiply(std::size_t n) {
        detail::require_id_count("size of a factor", n);
        if (n > (max_ids - 1) / size_) throw_invalid("product of the sizes", "stay below 4294967295; next factor", n);
        size_ *= n;
    }

    std::tuple<Policies...> policies_;
    std::size_t size_ = 1;
};

/// StatePolicy: another one applied to `projection(observation)`. It turns a policy over plain numbers into one over a
/// robot's own observation type:
///
///     ProjectedState state(UniformGrid<2>(...), [](const Scan& scan) { return std::array{scan.x, scan.y}; });
template <class Policy, class Projection>
class ProjectedState {
public:
    /// Whether the number of states is discovered while encoding: as the other policy says.
    static constexpr bool grows = grows_v<Policy>;

    /// `policy` applied to what `projection`, a function of an observation, gives. Both are kept by value.
    ProjectedState(Policy policy, Projection projection)
        : policy_(std::move(policy)), projection_(std::move(projection)) {}

    /// The number of states, the other policy's.
    [[nodiscard]] std::size_t size() const noexcept { return policy_.size(); }

    /// The state of projection(observation). Throws what the two throw.
    template <class Observation>
    [[nodiscard]] auto encode(const Observation& observation)
        -> decltype(std::declval<Policy&>().encode(std::declval<Projection&>()(observation))) {
        return policy_.encode(projection_(observation));
    }

    /// The other policy's description of a state.
    [[nodiscard]] std::string describe(StateId s) const { return describe_state(policy_, s); }

    /// The other policy.
    [[nodiscard]] const Policy& policy() const noexcept { return policy_; }

private:
    Policy policy_;
    Projection projection_;
};

}  // namespace sspql
