// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Everything, in the order data flows: an observation becomes a state, a state is counted, counts become a graph of
/// expected costs, the graph shortest paths, the paths values, the values an action. Two things are slow to compile and
/// left out: Boost.Graph's algorithms on the learnt graph, and its search on our queues (<sspql/paths/boost_graph.hpp>,
/// <sspql/paths/boost_queue.hpp>), and exact answers (<sspql/learn/exact_values.hpp>, <sspql/learn/exact_steps.hpp>).

// core: ids, random numbers, errors
#include <sspql/core/assert.hpp>
#include <sspql/core/errors.hpp>
#include <sspql/core/ids.hpp>
#include <sspql/core/random.hpp>
#include <sspql/core/serialization.hpp>
#include <sspql/core/step_budget.hpp>
#include <sspql/core/version.hpp>

// spaces: observations to states, actions to commands
#include <sspql/spaces/action_policy.hpp>
#include <sspql/spaces/action_set.hpp>
#include <sspql/spaces/enum_state.hpp>
#include <sspql/spaces/hashed_state.hpp>
#include <sspql/spaces/legal_actions.hpp>
#include <sspql/spaces/polar_grid.hpp>
#include <sspql/spaces/product_state.hpp>
#include <sspql/spaces/state_policy.hpp>
#include <sspql/spaces/uniform_grid.hpp>

// model: what was observed, and its probabilities
#include <sspql/model/cells.hpp>
#include <sspql/model/probability.hpp>
#include <sspql/model/transition_counts.hpp>

// paths: expected costs, the graph, queues, shortest paths
#include <sspql/paths/auto_queue.hpp>
#include <sspql/paths/bucket_queue.hpp>
#include <sspql/paths/cost.hpp>
#include <sspql/paths/cost_publisher.hpp>
#include <sspql/paths/dary_heap.hpp>
#include <sspql/paths/fibonacci_heap.hpp>
#include <sspql/paths/path_solver.hpp>
#include <sspql/paths/published_changes.hpp>
#include <sspql/paths/queue.hpp>
#include <sspql/paths/resumable_search.hpp>
#include <sspql/paths/reverse_graph.hpp>
#include <sspql/paths/ring_queue.hpp>
#include <sspql/paths/shortest_paths.hpp>
#include <sspql/paths/ssp_planner.hpp>
#include <sspql/paths/ssp_values.hpp>
#include <sspql/paths/tree_repair.hpp>

// learn: values, selectors, learners, the agent
#include <sspql/learn/action_selector.hpp>
#include <sspql/learn/adaptive_params.hpp>
#include <sspql/learn/adaptive_sspql.hpp>
#include <sspql/learn/agent.hpp>
#include <sspql/learn/dyna_q.hpp>
#include <sspql/learn/dyna_q_plus.hpp>
#include <sspql/learn/exploration_bonus.hpp>
#include <sspql/learn/greedy.hpp>
#include <sspql/learn/learner.hpp>
#include <sspql/learn/prioritized_sweeping.hpp>
#include <sspql/learn/q_learning.hpp>
#include <sspql/learn/q_table.hpp>
#include <sspql/learn/r_max.hpp>
#include <sspql/learn/rtdp.hpp>
#include <sspql/learn/sarsa.hpp>
#include <sspql/learn/schedule.hpp>
#include <sspql/learn/sspql.hpp>
#include <sspql/learn/value_learner.hpp>

// env: what the agent acts in
#include <sspql/env/chain.hpp>
#include <sspql/env/changing_grid_world.hpp>
#include <sspql/env/environment.hpp>
#include <sspql/env/grid_maps.hpp>
#include <sspql/env/grid_world.hpp>
#include <sspql/env/mountain_car.hpp>
#include <sspql/env/random_mdp.hpp>
#include <sspql/env/random_walls.hpp>
#include <sspql/env/table_csv.hpp>
#include <sspql/env/tabular_environment.hpp>
#include <sspql/env/time_limit.hpp>
#include <sspql/env/windy.hpp>

// io: what was learnt, in files
#include <sspql/io/checkpoint.hpp>
#include <sspql/io/dot.hpp>
#include <sspql/io/explain.hpp>
#include <sspql/io/logged.hpp>
#include <sspql/io/npy.hpp>
#include <sspql/io/policy_csv.hpp>
#include <sspql/io/replay.hpp>
#include <sspql/io/step_log.hpp>

// run: episodes, threads, statistics
#include <sspql/run/checkpoint_every.hpp>
#include <sspql/run/episode.hpp>
#include <sspql/run/parallel.hpp>
#include <sspql/run/statistics.hpp>
