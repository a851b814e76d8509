// SPDX-License-Identifier: MIT
#include "experiment/learner_catalog.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <stdexcept>
#include <utility>

#include <sspql/learn/q_learning.hpp>
#include <sspql/learn/sspql.hpp>

#include "experiment/any_policies.hpp"

namespace sspql::experiment {

namespace {

using Settings = LearnerSettings;

/// A name, whether it has a model (and so takes the keys of SSPQL), and how it differs from the defaults.
struct Preset {
    const char* name;
    bool has_model;
    void (*change)(Settings&);
};

const std::array<Preset, 7> presets{{
    {"q", false, [](Settings& s) { s.bonus = 0.0; }},
    {"q-bonus", false, [](Settings&) {}},
    {"q-optimistic", false,
     [](Settings& s) {
         s.bonus = 0.0;
         s.initial_q = 1.0;
     }},
    {"ssp", true,
     [](Settings& s) {
         s.w_q = 0.0;
         s.bonus = 0.0;
     }},
    {"sspql", true, [](Settings& s) { s.bonus = 0.0; }},
    {"sspql-bonus", true, [](Settings&) {}},
    {"sspql-constant", true,
     [](Settings& s) {
         s.bonus = 0.0;
         s.decay = 0.0;
     }},
}};

struct NumberKey {
    const char* name;
    double Settings::*member;
    bool needs_model;
};

const std::array<NumberKey, 12> number_keys{{
    {"gamma", &Settings::gamma, false},
    {"alpha", &Settings::alpha, false},
    {"initial_q", &Settings::initial_q, false},
    {"bonus", &Settings::bonus, false},
    {"eta", &Settings::eta, false},
    {"noise", &Settings::noise, false},
    {"epsilon", &Settings::epsilon, false},
    {"temperature", &Settings::temperature, false},
    {"w_q", &Settings::w_q, true},
    {"w_ssp", &Settings::w_ssp, true},
    {"decay", &Settings::decay, true},
    {"lambda", &Settings::lambda, true},
}};

struct WordKey {
    const char* name;
    std::string Settings::*member;
    bool needs_model;
    const char* words;  ///< those allowed, each between commas
};

const std::array<WordKey, 3> word_keys{{
    {"selector", &Settings::selector, false, ",noise,epsilon-greedy,boltzmann,"},
    {"cost", &Settings::cost, true, ",risk,tries,log-risk,hops,"},
    {"probability", &Settings::probability, true, ",sum,best,"},
}};

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::size_t begin = 0;
    for (;;) {
        const std::size_t end = text.find(separator, begin);
        parts.push_back(text.substr(begin, end - begin));
        if (end == std::string::npos) return parts;
        begin = end + 1;
    }
}

std::vector<std::string> keys_of(bool has_model) {
    std::vector<std::string> keys;
    for (const auto& key : number_keys) {
        if (has_model || !key.needs_model) keys.emplace_back(key.name);
    }
    for (const auto& key : word_keys) {
        if (has_model || !key.needs_model) keys.emplace_back(key.name);
    }
    return keys;
}

[[noreturn]] void refuse(const std::string& assignment, const std::string& why) {
    throw std::invalid_argument("--set " + assignment + ": " + why);
}

AnySelector selector_of(const Settings& s) {
    if (s.selector == "epsilon-greedy") return EpsilonGreedy(s.epsilon);
    if (s.selector == "boltzmann") return Boltzmann(s.temperature);
    return ActionSelector(s.noise);
}

AnyCost cost_of(const Settings& s) {
    if (s.cost == "tries") return ExpectedTries{};
    if (s.cost == "log-risk") return LogRisk(s.lambda);
    if (s.cost == "hops") return HopCount{};
    return RiskWeighted(s.lambda);
}

template <class Params>
Params common_params(const Settings& s) {
    Params params;
    params.gamma = s.gamma;
    params.alpha = s.alpha;
    params.initial_q = s.initial_q;
    params.w_exp = s.bonus;
    params.bonus = ExplorationBonus(s.eta);
    params.selector = selector_of(s);
    return params;
}

}  // namespace

/// Collects assignments into recipes.
class RecipeBuilder {
public:
    static LearnerRecipe start(const std::string& name) {
        for (const Preset& preset : presets) {
            if (name != preset.name) continue;
            LearnerRecipe recipe;
            recipe.name_ = name;
            recipe.has_model_ = preset.has_model;
            preset.change(recipe.settings_);
            return recipe;
        }
        throw std::invalid_argument("unknown learner '" + name + "'; known are " + joined(learner_names()));
    }

    /// Whether the recipe has this key; sets it then.
    static bool assign(LearnerRecipe& recipe, const std::string& assignment, const std::string& key,
                       const std::string& value) {
        for (const auto& known : number_keys) {
            if (key != known.name || (known.needs_model && !recipe.has_model_)) continue;
            recipe.settings_.*known.member = number(assignment, value);
            return true;
        }
        for (const auto& known : word_keys) {
            if (key != known.name || (known.needs_model && !recipe.has_model_)) continue;
            const std::string words = known.words;
            if (value.empty() || value.find(',') != std::string::npos ||
                words.find("," + value + ",") == std::string::npos) {
                std::vector<std::string> choices = split(words.substr(1, words.size() - 2), ',');
                refuse(assignment, "'" + value + "' is none of " + joined(choices));
            }
            recipe.settings_.*known.member = value;
            return true;
        }
        return false;
    }

    static bool has_model(const LearnerRecipe& recipe) { return recipe.has_model_; }

private:
    static double number(const std::string& assignment, const std::string& text) {
        double value = 0.0;
        const char* end = text.data() + text.size();
        const auto result = std::from_chars(text.data(), end, value);
        if (result.ec != std::errc{} || result.ptr != end) refuse(assignment, "'" + text + "' is no number");
        return value;
    }
};

std::unique_ptr<AnyLearner> LearnerRecipe::make(std::size_t states, std::size_t actions, std::uint64_t seed) const {
    if (!has_model_) {
        using Learner = QLearning<AnyPolicies>;
        return std::make_unique<LearnerBox<Learner>>(
            Learner(states, actions, common_params<Learner::Params>(settings_), seed));
    }
    using Learner = Sspql<AnySspqlPolicies>;
    auto params = common_params<Learner::Params>(settings_);
    params.w_q = settings_.w_q;
    params.w_ssp = settings_.w_ssp;
    params.ssp_decay = VisitDecay{settings_.decay};
    params.cost = cost_of(settings_);
    if (settings_.probability == "best") params.probability = BestAction{};
    return std::make_unique<LearnerBox<Learner>>(Learner(states, actions, std::move(params), seed));
}

std::vector<std::string> learner_names() {
    std::vector<std::string> names;
    for (const Preset& preset : presets) names.emplace_back(preset.name);
    return names;
}

std::vector<LearnerRecipe> learner_recipes(const std::string& names, const std::vector<std::string>& assignments) {
    std::vector<LearnerRecipe> recipes;
    for (const std::string& name : split(names, ',')) {
        LearnerRecipe recipe = RecipeBuilder::start(name);
        for (const LearnerRecipe& other : recipes) {
            if (other.name() == name) throw std::invalid_argument("learner '" + name + "' is named twice");
        }
        recipes.push_back(std::move(recipe));
    }
    for (const std::string& assignment : assignments) {
        const std::size_t equals = assignment.find('=');
        const std::size_t dot = assignment.find('.');
        if (equals == std::string::npos || dot == std::string::npos || dot > equals) {
            refuse(assignment, "write it as NAME.key=value, such as sspql.lambda=1 or '*.gamma=.95'");
        }
        const std::string name = assignment.substr(0, dot);
        const std::string key = assignment.substr(dot + 1, equals - dot - 1);
        const std::string value = assignment.substr(equals + 1);
        bool named = false;
        bool assigned = false;
        bool model = false;
        for (LearnerRecipe& recipe : recipes) {
            if (name != "*" && name != recipe.name()) continue;
            named = true;
            model = model || RecipeBuilder::has_model(recipe);
            if (RecipeBuilder::assign(recipe, assignment, key, value)) assigned = true;
        }
        if (!named) refuse(assignment, "'" + name + "' is none of the learners " + names);
        if (!assigned) refuse(assignment, "unknown key '" + key + "'; known are " + joined(keys_of(model)));
    }
    for (const LearnerRecipe& recipe : recipes) {
        try {
            static_cast<void>(recipe.make(1, 1, 0));
        } catch (const std::invalid_argument& error) {
            throw std::invalid_argument("learner " + recipe.name() + ": " + error.what());
        }
    }
    return recipes;
}

}  // namespace sspql::experiment
