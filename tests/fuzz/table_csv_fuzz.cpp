// SPDX-License-Identifier: MIT
// Any bytes as a table: read to a table that makes sense, or refused with the place.
#include <sspql/env/table_csv.hpp>

#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>

#include "fuzz/fuzz_testing.hpp"

namespace {

/// A table may have ten million states, whose arrays take a second to fill: numbers of 5 to 8 digits are left to the
/// tests. Longer ones are refused at once.
bool is_large(std::string_view text) {
    std::size_t digits = 0;
    for (const char c : text) {
        if (std::isdigit(static_cast<unsigned char>(c)) != 0) {
            if (digits > 0 || c != '0') ++digits;  // zeros that lead count for nothing
            continue;
        }
        if (digits >= 5 && digits <= 8) return true;
        digits = 0;
    }
    return digits >= 5 && digits <= 8;
}

void check(const sspql::TransitionTable& table) {
    using sspql::fuzz::require;
    std::size_t outcomes = 0;
    for (std::size_t s = 0; s < table.states(); ++s) {
        for (std::size_t a = 0; a < table.actions(); ++a) {
            double sum = 0.0;
            for (const sspql::Outcome& outcome : table.outcomes(sspql::state_id(s), sspql::action_id(a))) {
                require(sspql::index(outcome.next) < table.states(), "an outcome is a state");
                require(outcome.probability > 0.0 && std::isfinite(outcome.reward), "numbers as promised");
                require(outcome.terminal || table.has_actions(outcome.next), "going on is possible");
                sum += outcome.probability;
                ++outcomes;
            }
            require(sum == 0.0 || std::fabs(sum - 1.0) < 1e-8, "probabilities add up");
        }
    }
    require(outcomes == table.size() && outcomes > 0, "all outcomes belong to a state and an action");
    require(!table.starts().empty(), "somewhere to start");
    for (const sspql::StateId s : table.starts()) require(table.has_actions(s), "a start has actions");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text = sspql::fuzz::text_of(data, size);
    if (is_large(text)) return 0;
    std::istringstream in{std::string(text)};
    try {
        check(sspql::read_table_csv(in, "input"));
    } catch (const std::runtime_error& error) {
        sspql::fuzz::require_place(error, "input");
    }
    return 0;
}
