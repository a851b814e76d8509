// SPDX-License-Identifier: MIT
//
// How many steps does each learner need on a grid world, and how many after the map changed? Fig. 5 of Kwon, Suh and Lee
// (2011), Sutton and Barto's mazes, and any tabular MDP from a file: grid_experiment --help

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <sspql/core/version.hpp>
#include <sspql/env/chain.hpp>
#include <sspql/env/changing_grid_world.hpp>
#include <sspql/env/grid_maps.hpp>
#include <sspql/env/grid_world.hpp>
#include <sspql/env/table_csv.hpp>
#include <sspql/env/tabular_environment.hpp>
#include <sspql/env/windy.hpp>
#include <sspql/io/crc32.hpp>
#include <sspql/learn/exact_steps.hpp>
#include <sspql/learn/exact_values.hpp>
#include <sspql/run/parallel.hpp>
#include <sspql/spaces/action_policy.hpp>
#include <sspql/spaces/enum_state.hpp>

#include "experiment/learner_catalog.hpp"
#include "experiment/options.hpp"
#include "experiment/parts.hpp"
#include "experiment/runner.hpp"
#include "report/findings.hpp"
#include "report/numbers.hpp"
#include "report/progress.hpp"

namespace {

using namespace sspql;
using namespace sspql::experiment;

struct GridOptions : CommonOptions {
    std::string maps;
    std::string table;
    std::optional<double> slip;
    std::string noise_kind = "other";
    std::int64_t total_steps = 0;
    std::string report_at;
    ShardOptions shards;

    GridOptions() {
        learners = "q-bonus,ps-bonus,sspql-bonus";
        seeds = 20;
        episodes = 50;
        steps_per_episode = 5000;
    }
};

/// One phase of the experiment: its world and what is known about it exactly.
struct Phase {
    std::string name;
    std::variant<GridWorld, ChangingGridWorld, TabularEnvironment> world;
    std::optional<TransitionTable> table;  ///< the world's, if it stays the same
    std::vector<std::uint64_t> report_at;
    std::size_t total_steps = 0;

    [[nodiscard]] std::size_t states() const {
        return std::visit([](const auto& w) { return w.size(); }, world);
    }
    [[nodiscard]] std::size_t actions() const {
        const auto* tabular = std::get_if<TabularEnvironment>(&world);
        return tabular != nullptr ? tabular->table().actions() : GridWorld::actions;
    }
};

SlipKind slip_kind(const std::string& name) {
    if (name == "perpendicular") return SlipKind::perpendicular;
    return name == "lost" ? SlipKind::lost : SlipKind::other;
}

/// Sutton and Barto's windy grid worlds: example 6.5, exercises 6.9 and 6.10.
std::optional<WindyParams> windy_params(const std::string& name) {
    if (name != "windy" && name != "windy-king" && name != "windy-gusts") return std::nullopt;
    WindyParams params;
    if (name != "windy") params.moves = WindyMoves::king;
    if (name == "windy-gusts") params.gusts = 1.0 / 3.0;
    return params;
}

Phase map_phase(const std::string& name, const GridOptions& options) {
    if (name == "chain") {
        const double slip = options.slip.value_or(0.1);
        if (slip >= 1.0) throw std::invalid_argument("--slip must be below 1 for the chain, whose goal is out of reach else");
        ChainParams params;
        params.probability = 1.0 - slip;
        TransitionTable table = chain_table(params);
        return {name, TabularEnvironment(table), table, {}, 0};
    }
    if (const std::optional<WindyParams> params = windy_params(name)) {
        if (options.slip) throw std::invalid_argument("--slip does not go with " + name + ": its chance is the wind's");
        TransitionTable table = windy_table(*params);
        return {name, TabularEnvironment(table), table, {}, 0};
    }
    std::optional<GridTask> task = find_grid_task(name);
    if (!task && name.find('/') == std::string::npos && name.find('.') == std::string::npos) {
        static_cast<void>(grid_task(name));  // says which there are
    }
    if (!task) {
        task.emplace(GridTask{name, GridMap::load(name), {}, 0, {}});
        task->params.slip = 0.1;
        task->name = name.substr(name.find_last_of('/') + 1);
    }
    if (options.slip) task->params.slip = *options.slip;
    task->params.slip_kind = slip_kind(options.noise_kind);
    if (!task->changes.empty()) return {task->name, task->changing_world(), std::nullopt, {}, task->total_steps};
    GridWorld world = task->world();
    TransitionTable table = world.table();
    return {task->name, std::move(world), std::move(table), {}, 0};
}

std::vector<std::uint64_t> report_steps(const Phase& phase, const GridOptions& options) {
    std::vector<std::uint64_t> steps;
    for (const std::string& word : split(options.report_at, ',')) {
        std::uint64_t step = 0;
        for (const char c : word) {
            if (c < '0' || c > '9' || step > 1000000000) step = 0;
            if (c < '0' || c > '9') break;
            step = step * 10 + static_cast<std::uint64_t>(c - '0');
        }
        if (step == 0 || step > phase.total_steps || (!steps.empty() && step <= steps.back())) {
            throw std::invalid_argument("--report-at must be increasing steps from 1 to " +
                                        std::to_string(phase.total_steps) + ", got '" + options.report_at + "'");
        }
        steps.push_back(step);
    }
    if (!steps.empty() || phase.total_steps == 0) return steps;
    if (const auto* changing = std::get_if<ChangingGridWorld>(&phase.world)) {
        for (const MapChange& change : changing->changes()) steps.push_back(change.from_step);
    }
    if (steps.empty() || steps.back() < phase.total_steps) steps.push_back(phase.total_steps);
    return steps;
}

std::vector<Phase> phases_of(const GridOptions& options) {
    if (options.maps.empty() == options.table.empty()) {
        throw std::invalid_argument(options.maps.empty() ? "give --maps or --table (--help lists the options)"
                                                         : "give --maps or --table, not both");
    }
    std::vector<Phase> phases;
    if (!options.table.empty()) {
        TransitionTable table = load_table_csv(options.table);
        phases.push_back({options.table.substr(options.table.find_last_of('/') + 1), TabularEnvironment(table), table, {}, 0});
    }
    for (const std::string& name : split(options.maps, ',')) phases.push_back(map_phase(name, options));
    for (Phase& phase : phases) {
        if (phase.states() != phases.front().states() || phase.actions() != phases.front().actions()) {
            const auto size = [](const Phase& p) {
                return p.name + " has " + std::to_string(p.states()) + " cells and " + std::to_string(p.actions()) + " actions";
            };
            throw std::invalid_argument("the maps of a chain must be equally large: " + size(phases.front()) + ", " +
                                        size(phase));
        }
        if (options.total_steps > 0) phase.total_steps = static_cast<std::size_t>(options.total_steps);
        if (phase.total_steps == 0 && !options.report_at.empty()) {
            throw std::invalid_argument("--report-at needs --total-steps, or a map that changes while it runs");
        }
        phase.report_at = report_steps(phase, options);
    }
    return phases;
}

/// Tells a learner which actions the states of a table have.
void restrict_actions(AnyLearner& learner, const TransitionTable& table) {
    for (std::size_t s = 0; s < table.states(); ++s) {
        if (!table.has_actions(state_id(s))) continue;
        const auto allowed = table.allowed(state_id(s));
        bool all = true;
        for (std::size_t a = 0; a < table.actions(); ++a) all = all && allowed.contains(action_id(a));
        if (!all) learner.set_legal_actions(state_id(s), table.action_set(state_id(s)));
    }
}

/// Maps of more cells say nothing but the action: pages would grow, and paths are searched anew for each cell.
constexpr std::size_t most_explained_cells = 400;

/// What there is to say about each move, a line each.
std::string reasons_of(const GridMap& map, const AnyLearner& learner, StateId s) {
    static constexpr std::array<const char*, GridWorld::actions> moves{"up", "down", "left", "right"};
    const Explanation why = learner.explain(s);
    const std::string unit = why.distance_in_steps ? " steps to go" : " of cost to go";
    const auto distance = [&](double far) { return report::short_text(far, 3) + unit; };
    std::string text = std::isfinite(why.distance) ? distance(why.distance) : "";
    for (const ActionExplanation& a : why.actions) {
        text += (text.empty() ? "" : "\n") + std::string(moves[index(a.action)]) + ": " + report::short_text(a.terms.sum(), 4);
        text += a.terms.n > 0.0 ? ", tried " + report::fixed_text(a.terms.n, 0) + "x" : ", never tried";
        if (a.likely == no_state) continue;
        text += ", mostly to row " + std::to_string(map.row(a.likely)) + ", column " + std::to_string(map.column(a.likely));
        if (std::isfinite(a.distance)) text += ", " + distance(a.distance);
    }
    return text;
}

report::GridPicture picture_of(const GridMap& map, const AnyLearner& learner) {
    report::GridPicture picture;
    picture.rows = map.rows();
    picture.columns = map.columns();
    picture.value_name = "Q, and Q_SSP where there is one";
    for (std::size_t i = 0; i < map.size(); ++i) {
        report::GridPictureCell cell;
        const StateId s = state_id(i);
        switch (map.cell(s)) {
            case GridCell::wall: cell.kind = report::GridCellKind::wall; break;
            case GridCell::goal: cell.kind = report::GridCellKind::goal; break;
            case GridCell::hazard: cell.kind = report::GridCellKind::hazard; break;
            case GridCell::start: cell.kind = report::GridCellKind::start; break;
            default: break;
        }
        if (map.cell(s) == GridCell::free || map.cell(s) == GridCell::start) {
            const ActionId best = learner.best(s);
            const ActionTerms terms = learner.terms(s, best);
            cell.value = terms.q + terms.ssp;
            if (*cell.value != 0.0) cell.action = static_cast<report::GridMove>(index(best));
            if (map.size() <= most_explained_cells) cell.why = reasons_of(map, learner, s);
        }
        picture.cells.push_back(cell);
    }
    return picture;
}

/// The pictures of the first seed, by phase and learner.
using Pictures = std::vector<report::GridPhasePictures>;

/// A learner's whole chain of phases with one seed; run[p] is its run of phase p.
std::vector<report::SeedRun> run_chain(std::vector<Phase> phases, const GridOptions& options,
                                       const LearnerRecipe& recipe, std::uint64_t seed, std::size_t learner_index,
                                       Pictures* pictures) {
    const std::unique_ptr<AnyLearner> learner =
        recipe.make(phases.front().states(), phases.front().actions(), seed);
    std::vector<report::SeedRun> runs;
    std::size_t first_episode = 0;
    for (std::size_t p = 0; p < phases.size(); ++p) {
        Phase& phase = phases[p];
        RunPlan plan;
        plan.episodes = static_cast<std::size_t>(options.episodes);
        plan.steps_per_episode = static_cast<std::size_t>(options.steps_per_episode);
        plan.total_steps = phase.total_steps;
        plan.report_at = phase.report_at;
        if (phase.table) plan.is_success = [&phase](double reward) { return phase.table->is_success(reward); };
        const EnumState<StateId> states(phase.states());
        if (auto* tabular = std::get_if<TabularEnvironment>(&phase.world)) {
            if (tabular->table().actions() <= ActionSet::most) restrict_actions(*learner, tabular->table());
            TimedAgent agent(states, EnumActions<ActionId>(phase.actions()), *learner);
            runs.push_back(run_seed(*tabular, agent, seed, first_episode, plan));
        } else {
            TimedAgent agent(states, EnumActions<Move>(GridWorld::actions), *learner);
            auto* grid = std::get_if<GridWorld>(&phase.world);
            auto* changing = std::get_if<ChangingGridWorld>(&phase.world);
            runs.push_back(grid != nullptr ? run_seed(*grid, agent, seed, first_episode, plan)
                                           : run_seed(*changing, agent, seed, first_episode, plan));
            const GridMap& map = grid != nullptr ? grid->map() : changing->world().map();
            if (pictures != nullptr && map.size() <= report::most_picture_cells) {
                (*pictures)[p].learners[learner_index] = picture_of(map, *learner);
            }
        }
        first_episode += 1000000;
    }
    return runs;
}

std::vector<report::Setting> settings_of(const GridOptions& options, const std::vector<LearnerRecipe>& recipes) {
    std::vector<std::string> names;
    for (const LearnerRecipe& recipe : recipes) names.push_back(recipe.name());
    std::vector<std::string> maps;
    for (const std::string& map : split(options.maps, ',')) maps.push_back(map.substr(map.find_last_of('/') + 1));
    return {{"maps", json_list(maps), false},
            {"table", options.table.substr(options.table.find_last_of('/') + 1)},
            {"slip", options.slip ? report::exact_text(*options.slip) : "null", false},
            {"noise_kind", options.noise_kind},
            {"learners", json_list(names), false},
            {"set", json_list(options.set), false},
            {"seeds", std::to_string(options.seeds), false},
            {"episodes", std::to_string(options.episodes), false},
            {"steps_per_episode", std::to_string(options.steps_per_episode), false},
            {"total_steps", std::to_string(options.total_steps), false},
            {"report_at", options.report_at}};
}

bool parse(GridOptions& options, int argc, char** argv) {
    Options parser("grid_experiment",
                   "Learners on grid worlds: steps per episode, and how they cope when the map changes (Fig. 5 of Kwon, "
                   "Suh and Lee 2011), Sutton and Barto's mazes, or any tabular MDP from a CSV file.");
    std::string names = "chain windy windy-king windy-gusts";
    for (const std::string& name : grid_task_names()) names += " " + name;
    names += " walls60 walls60:2 (and the like)";
    parser.text("--maps", options.maps, "Maps, one after the other, what was learnt goes along: names or files");
    parser.text("--table", options.table, "A tabular MDP instead: CSV with s,a,next,p,reward,terminal");
    parser.number("--slip", options.slip, 0.0, 1.0, "Chance that a step goes astray (default 0.1; 0 for the book's mazes)");
    parser.choice("--noise-kind", options.noise_kind, {"other", "perpendicular", "lost"}, "Where it goes then");
    parser.whole("--total-steps", options.total_steps, 0, 1000000000, "Run for N steps instead of --episodes; 0 = no");
    parser.text("--report-at", options.report_at, "Note the reward collected after these steps, as 1000,3000");
    parser.common(options);
    parser.shards(options.shards);
    std::string learners;
    for (const std::string& name : learner_names()) learners += " " + name;
    parser.footer("Maps: " + names + "; in a file: . free, # wall, G goal, S start, H hazard\nLearners:" + learners +
                  "; dyna-q:20 and the like set k"
                  "\nKeys of --set: an unknown one is answered with those the learner has");
    return parser.parse(argc, argv);
}

/// Of the world as it is, not of its file: line ends and comments do not count.
std::uint32_t checksum_of(const Phase& phase) {
    detail::Crc32 crc;
    const auto add = [&](const auto& value) { crc.add(&value, sizeof value); };
    const auto add_table = [&](const TransitionTable& table) {
        for (std::size_t i = 0; i < table.states() * table.actions(); ++i) {
            const StateId s = state_id(i / table.actions());
            for (const Outcome& outcome : table.outcomes(s, action_id(i % table.actions()))) {
                add(i);
                add(index(outcome.next));
                add(outcome.probability);
                add(outcome.reward);
                add(outcome.terminal);
            }
        }
        for (const StateId s : table.starts()) add(index(s));
    };
    add(phase.states());
    if (phase.table) add_table(*phase.table);
    return crc.value();
}

/// A run of every learner with every seed through all phases.
struct Experiment {
    GridOptions options;
    std::vector<LearnerRecipe> recipes;
    std::vector<Phase> phases;
    Parts parts;

    /// \throws std::exception for anything wrong with the options, as prepare does.
    [[nodiscard]] bool read(int argc, char** argv) { return parse(options, argc, argv); }

    void prepare(const Ranks& ranks, int argc, char** argv) {
        recipes = learner_recipes(options.learners, options.set);
        phases = phases_of(options);
        parts = parts_of("grid_experiment", options.shards, options.files, ranks, argc, argv);
    }

    [[nodiscard]] report::GridFindings blank(int argc, char** argv) const {
        report::GridFindings findings;
        report::ExperimentResults& results = findings.results;
        results.experiment = "grid_experiment";
        results.settings = settings_of(options, recipes);
        results.manifest = {command_line(argc, argv), SSPQL_VERSION, compiler_name()};
        for (const Phase& phase : phases) {
            report::PhaseRuns runs;
            runs.name = phase.name;
            if (phase.table) {
                runs.optimal_steps = optimal_steps(*phase.table);
                runs.optimal_return = optimal_return(*phase.table);
            }
            runs.report_at = phase.report_at;
            for (const LearnerRecipe& recipe : recipes) {
                runs.learners.push_back(
                    {recipe.name(), std::vector<report::SeedRun>(static_cast<std::size_t>(options.seeds))});
            }
            results.phases.push_back(std::move(runs));
            findings.checksums.push_back(checksum_of(phase));
        }
        findings.pictures.resize(options.table.empty() ? phases.size() : 0);
        for (std::size_t p = 0; p < findings.pictures.size(); ++p) {
            const bool drawn = !std::holds_alternative<TabularEnvironment>(phases[p].world);
            findings.pictures[p].learners.resize(drawn ? recipes.size() : 0);
            findings.pictures[p].caption = "Seed 1 at the end of the phase. Pointing at a cell tells why.";
        }
        return findings;
    }

    void run(const shards::Shard& shard, const Ranks& ranks, report::GridFindings& findings) const {
        const std::size_t count = recipes.size() * shard.share(static_cast<std::size_t>(options.seeds));
        report::Progress progress("grid_experiment", count, "runs", ranks.progress_descriptor());
        parallel_for(count, ranks.threads(static_cast<std::size_t>(options.threads)), [&](std::size_t i) {
            const std::size_t learner = i % recipes.size();
            const std::size_t k = shard.unit(i / recipes.size());
            std::vector<report::SeedRun> runs = run_chain(phases, options, recipes[learner], k + 1, learner,
                                                          k == 0 ? &findings.pictures : nullptr);
            for (std::size_t p = 0; p < runs.size(); ++p) {
                findings.results.phases[p].learners[learner].runs[k] = std::move(runs[p]);
            }
            progress.advance();
        });
    }
};

}  // namespace

int main(int argc, char** argv) {
    return sspql::experiment::run_on_ranks("grid_experiment", run_experiment<Experiment>, argc, argv);
}
