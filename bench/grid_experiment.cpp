// SPDX-License-Identifier: MIT
//
// How many steps does each learner need on a grid world, and how many after the map changed? Fig. 5 of Kwon, Suh and Lee
// (2011), Sutton and Barto's mazes, and any tabular MDP from a file: grid_experiment --help

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <sspql/core/version.hpp>
#include <sspql/env/grid_maps.hpp>
#include <sspql/env/grid_world.hpp>
#include <sspql/env/tabular_environment.hpp>
#include <sspql/learn/exact_steps.hpp>
#include <sspql/learn/exact_values.hpp>
#include <sspql/run/parallel.hpp>
#include <sspql/spaces/action_policy.hpp>
#include <sspql/spaces/enum_state.hpp>

#include "experiment/grid_phases.hpp"
#include "experiment/learner_catalog.hpp"
#include "experiment/learnt_grid.hpp"
#include "experiment/options.hpp"
#include "experiment/parts.hpp"
#include "experiment/runner.hpp"
#include "report/findings.hpp"
#include "report/numbers.hpp"
#include "report/progress.hpp"

namespace {

using namespace sspql;
using namespace sspql::experiment;

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

/// The pictures of the first seed, by phase and learner.
using Pictures = std::vector<report::GridPhasePictures>;

/// A learner's whole chain of phases with one seed; run[p] is its run of phase p.
std::vector<report::SeedRun> run_chain(std::vector<GridPhase> phases, const GridOptions& options,
                                       const LearnerRecipe& recipe, std::uint64_t seed, std::size_t learner_index,
                                       Pictures* pictures) {
    const std::unique_ptr<AnyLearner> learner =
        recipe.make(phases.front().states(), phases.front().actions(), seed);
    std::vector<report::SeedRun> runs;
    std::size_t first_episode = 0;
    for (std::size_t p = 0; p < phases.size(); ++p) {
        GridPhase& phase = phases[p];
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
    std::string names;
    for (const std::string& name : map_names()) names += name + " ";
    names += "walls60 walls60:2 (and the like)";
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

/// A run of every learner with every seed through all phases.
struct Experiment {
    GridOptions options;
    std::vector<LearnerRecipe> recipes;
    std::vector<GridPhase> phases;
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
        for (const GridPhase& phase : phases) {
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
