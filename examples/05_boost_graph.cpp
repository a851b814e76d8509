// g++ -std=c++17 -O2 -I include -I /usr/include/eigen3 examples/05_boost_graph.cpp -o boost_graph && ./boost_graph
// What a robot learnt is a graph: Boost.Graph's algorithms run on it, and its search runs on our queues.
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <sspql/paths/boost_graph.hpp>
#include <sspql/paths/boost_queue.hpp>
#include <sspql/sspql.hpp>
#include <vector>

#include <boost/graph/astar_search.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/graph/strong_components.hpp>

constexpr int side = 12;
using Cell = std::array<int, 2>;
struct Ledge {  // two floors, the charger on the lower one, and no way up again; one move in ten goes astray
    Cell at{};
    sspql::Random chance{0};
    Cell reset(std::uint64_t seed) { return chance = sspql::Random(seed), at = {0, int(chance.below(side))}; }
    sspql::Step<Cell> step(Cell move) {
        if (chance.chance(0.1)) std::swap(move[0], move[1]);
        const int highest = at[0] < side / 2 ? 0 : side / 2;
        at = {std::clamp(at[0] + move[0], highest, side - 1), std::clamp(at[1] + move[1], 0, side - 1)};
        const bool home = at == Cell{side - 1, side - 1};
        return {at, home ? 1.0 : 0.0, home, false};  // observation, reward, terminated, truncated
    }
};

struct Found {};  // ends a search
struct Looker : boost::default_astar_visitor {
    std::size_t from, *looked_at;
    void examine_vertex(std::size_t v, const sspql::ReverseGraph&) const {
        if (++*looked_at, v == from) throw Found();
    }
};

int main() {
    Ledge world;
    const sspql::UniformGrid<2> states({{{0, side, side}, {0, side, side}}});
    sspql::Agent robot(states, sspql::ActionTable<Cell>{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}, sspql::paper());
    (void)sspql::run_episodes(world, robot, 400, 1);

    auto counts = robot.learner().counts();  // a copy, to be brought up to date
    sspql::CostPublisher<>().publish(counts);
    sspql::ReverseGraph graph;  // its edges are the learnt ones reversed: a search from the goal finds the ways to it
    graph.assign(counts);
    const std::size_t n = num_vertices(graph), goal = index(states.encode(Cell{side - 1, side - 1}));
    std::printf("learnt in 400 episodes: %zu states, %zu edges\n", n, num_edges(graph));

    const auto map = [&](auto& values) {
        return boost::make_iterator_property_map(values.begin(), get(boost::vertex_index, graph));
    };
    std::vector<double> theirs(n), ours(n), near(n);
    std::vector<std::size_t> next(n), component(n);
    boost::dijkstra_shortest_paths(graph, goal, boost::distance_map(map(theirs)).distance_inf(1.0 / 0.0));
    sspql::AutoQueue<> queue;  // buckets here, instead of Boost's heap
    sspql::dijkstra_with_queue(graph, goal, queue, get(boost::edge_weight, graph), map(ours), map(next));
    std::printf("Boost's Dijkstra: a way of cost %.3f from the start; its search with our queue: %s\n", theirs[0],
                theirs == ours ? "the same" : "ANOTHER");

    const std::size_t from = index(states.encode(Cell{side / 2, side - 1}));  // below the ledge, above the charger
    const auto to_go = [&](std::size_t v) {
        return graph.least_cost() * (std::abs(int(v / side - from / side)) + std::abs(int(v % side - from % side)));
    };
    std::size_t looked_at = 0;
    try {
        boost::astar_search(graph, goal, to_go, boost::visitor(Looker{{}, from, &looked_at}).distance_map(map(near)));
    } catch (Found) {
        std::printf("Boost's A*: one of cost %.3f from below the ledge, having looked at %zu states\n", near[from],
                    looked_at);
    }
    const std::size_t components = boost::strong_components(graph, map(component));
    std::printf("%zu strong components, a letter each: out of one, no way leads back; * is the way\n", components);
    std::vector<char> picture(n);
    for (std::size_t v = 0; v < n; ++v) picture[v] = char('a' + component[v]);
    for (std::size_t v = 0; v != goal; v = next[v]) picture[v] = '*';
    for (std::size_t v = 0; v < n; v += side) std::printf("%.*s\n", side, &picture[v]);
}
