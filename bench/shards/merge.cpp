// SPDX-License-Identifier: MIT
#include "shards/merge.hpp"

#include <algorithm>

namespace sspql::shards {

namespace {

/// Where two values differ first, and how: "settings.seeds is \"21\", not \"20\""; empty if nowhere.
std::string difference(const Json& ours, const Json& first, const std::string& path) {
    if (ours == first) return {};
    if (ours.is_object() && first.is_object()) {
        const std::string prefix = path.empty() ? "" : path + ".";
        for (const auto& item : first.items()) {
            if (!ours.contains(item.key())) return prefix + item.key() + " is not there";
            const std::string found = difference(ours[item.key()], item.value(), prefix + item.key());
            if (!found.empty()) return found;
        }
        for (const auto& item : ours.items()) {
            if (!first.contains(item.key())) return prefix + item.key() + " is " + brief(item.value()) + ", not absent";
        }
    }
    if (ours.is_array() && first.is_array() && ours.size() == first.size()) {
        for (std::size_t i = 0; i < ours.size(); ++i) {
            const std::string found = difference(ours[i], first[i], path + "[" + std::to_string(i) + "]");
            if (!found.empty()) return found;
        }
    }
    return path + " is " + brief(ours) + ", not " + brief(first);
}

}  // namespace

void ShardSet::add(const ShardContent& content, const std::string& name) {
    if (names_.empty()) {
        run_ = content.run;
        first_name_ = name;
        names_.resize(content.shard.count);
    }
    const std::string other = difference(content.run, run_, "");
    if (!other.empty()) throw std::runtime_error(name + ": of another run than " + first_name_ + ": " + other);
    std::string& place = names_[content.shard.index];
    if (!place.empty()) {
        throw std::runtime_error(name + ": shard " + text_of(content.shard) + " was given before, as " + place);
    }
    place = name;
    if (std::find(compilers_.begin(), compilers_.end(), content.compiler) == compilers_.end()) {
        compilers_.push_back(content.compiler);
    }
}

void ShardSet::require_complete() const {
    constexpr std::size_t most_named = 10;
    std::size_t missing = 0;
    std::string listed;
    for (std::size_t i = 0; i < names_.size(); ++i) {
        if (!names_[i].empty()) continue;
        if (++missing <= most_named) listed += (missing == 1 ? "" : ", ") + text_of({i, names_.size()});
    }
    if (missing == 0) return;
    if (missing > most_named) listed += " and " + std::to_string(missing - most_named) + " more";
    throw std::runtime_error("missing of the run that " + first_name_ + " is of: shard" + (missing == 1 ? " " : "s ") +
                             listed);
}

std::string ShardSet::compilers() const {
    std::string text;
    for (const std::string& compiler : compilers_) text += (text.empty() ? "" : ", ") + compiler;
    return text;
}

}  // namespace sspql::shards
