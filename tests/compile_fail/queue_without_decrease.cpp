// expect: sspql: this Queue lacks one of prepare(n, least_cost, greatest_cost), push(vertex, key), decrease(vertex, key), pop() -> vertex, empty()
// SPDX-License-Identifier: MIT
#include <sspql/sspql.hpp>

struct Fifo {
    void prepare(std::size_t, double, double) { items.clear(); }
    void push(std::uint32_t vertex, double) { items.push_back(vertex); }
    std::uint32_t pop() {
        const std::uint32_t vertex = items.back();
        items.pop_back();
        return vertex;
    }
    bool empty() const { return items.empty(); }
    std::vector<std::uint32_t> items;
};

struct MyPolicies : sspql::SspqlPolicies {
    using Queue = Fifo;
};

int main() {
    sspql::Sspql<MyPolicies> learner(4, 2);
    sspql::ActionId a = learner.begin(sspql::state_id(0));
    a = learner.step(0.0, sspql::state_id(1));
    learner.end(1.0, sspql::state_id(2), true);
    a = learner.best(sspql::state_id(0));
    return static_cast<int>(sspql::index(a));
}
