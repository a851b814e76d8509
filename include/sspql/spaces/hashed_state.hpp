// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <unordered_map>
#include <vector>

#include <sspql/core/errors.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/core/serialization.hpp>
#include <sspql/spaces/state_policy.hpp>

namespace sspql {

/// StatePolicy for an unknown number of states: any observation with == and a hash; ids are given in the order of
/// discovery. `encode` is O(1) expected and allocates when it meets a new key; size() grows with it.
///
/// `find` looks without adding. Keys are kept by value.
/// \throws std::runtime_error when all 2^32 - 2 ids are given away.
template <class Key, class Hash = std::hash<Key>, class Equal = std::equal_to<Key>>
class HashedState {
public:
    /// The number of states is discovered while encoding.
    static constexpr bool grows = true;

    /// No states yet.
    HashedState() = default;

    /// Room for this many states without rehashing.
    void reserve(std::size_t states) {
        ids_.reserve(states);
        keys_.reserve(states);
    }

    /// The number of states so far: of different keys met.
    [[nodiscard]] std::size_t size() const noexcept { return keys_.size(); }

    /// The state of a key; a new one if it was never met. All or nothing: what is thrown leaves the states as they
    /// were.
    StateId encode(const Key& key) {
        const auto known = ids_.find(key);
        if (known != ids_.end()) return known->second;
        if (keys_.size() + 1 >= max_ids) throw std::runtime_error("HashedState: all 4294967294 state ids are in use");
        const StateId id = state_id(keys_.size());
        keys_.push_back(key);
        try {
            ids_.emplace(key, id);
        } catch (...) {  // both or neither
            keys_.pop_back();
            throw;
        }
        return id;
    }

    /// The state of a key met before.
    [[nodiscard]] std::optional<StateId> find(const Key& key) const {
        const auto known = ids_.find(key);
        if (known == ids_.end()) return std::nullopt;
        return known->second;
    }

    /// The key of a state. \throws std::invalid_argument for an id not given yet.
    [[nodiscard]] const Key& key(StateId s) const { return keys_[index(detail::require_state_of(s, size()))]; }

private:
    friend SerializationAccess;

    template <class Archive>
    void serialize(Archive& archive) {
        archive(keys_);
        if constexpr (Archive::loading) {
            archive.require(keys_.size() < max_ids, "there are too many states");
            ids_.clear();
            for (std::size_t i = 0; i < keys_.size(); ++i) ids_.emplace(keys_[i], state_id(i));
            archive.require(ids_.size() == keys_.size(), "two states have the same key");
        }
    }

    std::unordered_map<Key, StateId, Hash, Equal> ids_;
    std::vector<Key> keys_;
};

}  // namespace sspql
