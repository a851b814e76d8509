// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace sspql::detail {

/// The values f(0), ..., f(1023) of a function of a visit count, computed once and shared by copies (8 kB): a power
/// costs more than a whole action selection.
class Tabulated {
public:
    static constexpr std::size_t size = 1024;

    template <class F>
    explicit Tabulated(const F& f) {
        auto values = std::make_shared<std::vector<double>>(size);
        for (std::size_t n = 0; n < size; ++n) (*values)[n] = f(std::uint64_t{n});
        table_ = values->data();
        values_ = std::move(values);
    }

    [[nodiscard]] static constexpr bool covers(std::uint64_t n) noexcept { return n < size; }
    [[nodiscard]] double operator[](std::uint64_t n) const noexcept { return table_[n]; }

private:
    std::shared_ptr<const std::vector<double>> values_;
    const double* table_ = nullptr;
};

}  // namespace sspql::detail
