// SPDX-License-Identifier: MIT
// Any bytes as a map: read to a map that is the same after writing and reading again, or refused with the place.
#include <sspql/env/grid_map.hpp>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string_view>

#include "fuzz/fuzz_testing.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using sspql::fuzz::require;
    const std::string_view text = sspql::fuzz::text_of(data, size);
    try {
        const sspql::GridMap map = sspql::GridMap::parse(text, "input");
        require(map.size() == map.rows() * map.columns() && map.size() <= text.size(), "a cell a character");
        require(!map.goals().empty() && !map.starts().empty(), "a goal, and somewhere to start");
        for (const sspql::StateId s : map.starts()) {
            require(map.state(map.row(s), map.column(s)) == s, "row and column make the state");
            require(map.cell(s) == sspql::GridCell::start || map.cell(s) == sspql::GridCell::free, "a start is free");
        }
        require(sspql::GridMap::parse(map.text()) == map, "written and read again");
    } catch (const std::runtime_error& error) {
        sspql::fuzz::require_place(error, "input");
    }
    return 0;
}
