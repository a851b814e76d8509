// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <utility>

namespace sspql::rivals {

/// One way of finding the shortest paths of one graph, built beforehand: only run() is timed.
class Contender {
public:
    explicit Contender(std::string name) : name_(std::move(name)) {}
    Contender(const Contender&) = delete;
    Contender& operator=(const Contender&) = delete;
    virtual ~Contender() = default;

    [[nodiscard]] const std::string& name() const noexcept { return name_; }

    virtual void run() = 0;

    /// Of a state, after run(). Those that find no distances (floors) say so.
    [[nodiscard]] virtual double distance(std::size_t state) const = 0;
    [[nodiscard]] virtual bool finds_distances() const { return true; }

private:
    std::string name_;
};

}  // namespace sspql::rivals
