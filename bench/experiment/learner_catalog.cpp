// SPDX-License-Identifier: MIT
#include "experiment/learner_catalog.hpp"

#include <charconv>
#include <stdexcept>
#include <utility>

#include "experiment/options.hpp"

namespace sspql::experiment {

namespace {

using Kind = LearnerKind;
using Settings = LearnerSettings;

/// A name, its learner, and how its parameters differ from that learner's defaults.
struct Preset {
    const char* name;
    Kind kind;
    void (*change)(Settings&);
};

void plain(Settings&) {}
void with_bonus(Settings& s) { s.bonus = 0.1; }
void with_model_bonus(Settings& s) {
    s.bonus = 0.1;
    s.eta = 1.0;
}

void adaptive(Settings& s) {
    s.gamma = 0.99;
    s.bonus = 0.1;
    s.cap = 50.0;
}

const Preset presets[] = {
    {"q", Kind::q_learning, plain},
    {"q-bonus", Kind::q_learning, with_bonus},
    {"q-optimistic", Kind::q_learning, [](Settings& s) { s.initial_q = 1.0; }},
    {"sarsa", Kind::sarsa, plain},
    {"expected-sarsa", Kind::sarsa, [](Settings& s) { s.expected = true; }},
    {"dyna-q", Kind::dyna_q, plain},
    {"dyna-q-bonus", Kind::dyna_q, with_model_bonus},
    {"dyna-q-last", Kind::dyna_q, [](Settings& s) { s.replay = "last"; }},
    {"dyna-q-plus", Kind::dyna_q_plus, plain},
    {"ps", Kind::prioritized_sweeping, plain},
    {"ps-bonus", Kind::prioritized_sweeping, with_model_bonus},
    {"ps-optimistic", Kind::prioritized_sweeping,
     [](Settings& s) {
         s.initial_q = 1.0;
         s.cap = 5.0;
         s.kappa = 0.05;
     }},
    {"rtdp", Kind::rtdp, plain},
    {"rmax", Kind::r_max, [](Settings& s) { s.initial_q = 1.0; }},
    {"ssp", Kind::sspql, [](Settings& s) { s.w_q = 0.0; }},
    {"sspql", Kind::sspql, plain},
    {"sspql-bonus", Kind::sspql, with_bonus},
    {"sspql-constant", Kind::sspql, [](Settings& s) { s.decay = 0.0; }},
    {"paper", Kind::sspql, with_bonus},
    {"adaptive", Kind::adaptive, adaptive},
};

bool keeps_model(Kind kind) {
    return kind == Kind::dyna_q || kind == Kind::prioritized_sweeping || kind == Kind::rtdp || kind == Kind::r_max;
}
bool plans(Kind kind) {
    return kind == Kind::dyna_q || kind == Kind::dyna_q_plus || kind == Kind::prioritized_sweeping;
}
bool always(Kind) { return true; }
bool selects(Kind kind) { return kind != Kind::adaptive; }
bool updates_by_rate(Kind kind) {
    return kind != Kind::prioritized_sweeping && kind != Kind::rtdp && kind != Kind::r_max && kind != Kind::adaptive;
}
template <Kind K>
bool only(Kind kind) {
    return kind == K;
}

struct NumberKey {
    const char* name;
    double Settings::*member;
    bool (*applies)(Kind);
};

const NumberKey number_keys[] = {
    {"gamma", &Settings::gamma, always},
    {"alpha", &Settings::alpha, updates_by_rate},
    {"alpha_decay", &Settings::alpha_decay, updates_by_rate},
    {"initial_q", &Settings::initial_q, selects},
    {"bonus", &Settings::bonus, always},
    {"eta", &Settings::eta, selects},
    {"noise", &Settings::noise, selects},
    {"epsilon", &Settings::epsilon, selects},
    {"temperature", &Settings::temperature, selects},
    {"cap", &Settings::cap, [](Kind kind) { return keeps_model(kind) || kind == Kind::adaptive; }},
    {"kappa", &Settings::kappa, keeps_model},
    {"unknown_value", &Settings::unknown_value, keeps_model},
    {"k", &Settings::k, plans},
    {"threshold", &Settings::threshold,
     [](Kind kind) { return kind == Kind::prioritized_sweeping || kind == Kind::r_max; }},
    {"time_bonus", &Settings::time_bonus, only<Kind::dyna_q_plus>},
    {"known_after", &Settings::known_after, only<Kind::r_max>},
    {"w_q", &Settings::w_q, only<Kind::sspql>},
    {"w_ssp", &Settings::w_ssp, only<Kind::sspql>},
    {"decay", &Settings::decay, only<Kind::sspql>},
    {"lambda", &Settings::lambda, only<Kind::sspql>},
    {"budget", &Settings::budget, only<Kind::adaptive>},
    {"kappa_noise", &Settings::kappa_noise, only<Kind::adaptive>},
    {"tau", &Settings::tau, only<Kind::adaptive>},
    {"retrace", &Settings::retrace, only<Kind::adaptive>},
    {"alarm", &Settings::alarm, only<Kind::adaptive>},
    {"alarm_offset", &Settings::alarm_offset, only<Kind::adaptive>},
};

struct WordKey {
    const char* name;
    std::string Settings::*member;
    bool (*applies)(Kind);
    const char* words;  ///< those allowed, between commas
};

const WordKey word_keys[] = {
    {"selector", &Settings::selector, selects, "noise,epsilon-greedy,boltzmann"},
    {"replay", &Settings::replay, only<Kind::dyna_q>, "counts,last"},
    {"cost", &Settings::cost, only<Kind::sspql>, "risk,tries,log-risk,hops"},
    {"probability", &Settings::probability, only<Kind::sspql>, "sum,best"},
    {"paths", &Settings::paths, only<Kind::adaptive>, "on,off"},
};

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

bool parse_number(const std::string& text, double& value) {
    const char* end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, value);
    return result.ec == std::errc{} && result.ptr == end;
}

[[noreturn]] void refuse(const std::string& assignment, const std::string& why) {
    throw std::invalid_argument("--set " + assignment + ": " + why);
}

LearnerRecipe recipe_of(const std::string& name) {
    const std::size_t colon = name.find(':');
    const std::string base = name.substr(0, colon);
    for (const Preset& preset : presets) {
        if (base != preset.name) continue;
        Settings settings;
        preset.change(settings);
        if (colon != std::string::npos) {
            if (!plans(preset.kind)) throw std::invalid_argument("learner '" + base + "' takes no ':k', got '" + name + "'");
            if (!parse_number(name.substr(colon + 1), settings.k)) {
                throw std::invalid_argument("planning steps must be a number after ':', got '" + name + "'");
            }
        }
        return {name, preset.kind, settings};
    }
    throw std::invalid_argument("unknown learner '" + name + "'; known are " + joined(learner_names()));
}

/// Whether this learner has the key; it is set then.
bool assign(LearnerRecipe& recipe, const std::string& assignment, const std::string& key, const std::string& value) {
    for (const NumberKey& known : number_keys) {
        if (key != known.name || !known.applies(recipe.kind())) continue;
        if (!parse_number(value, recipe.settings().*known.member)) refuse(assignment, "'" + value + "' is no number");
        return true;
    }
    for (const WordKey& known : word_keys) {
        if (key != known.name || !known.applies(recipe.kind())) continue;
        const std::vector<std::string> words = split(known.words, ',');
        for (const std::string& word : words) {
            if (value != word) continue;
            recipe.settings().*known.member = value;
            return true;
        }
        refuse(assignment, "'" + value + "' is none of " + joined(words));
    }
    return false;
}

void apply(std::vector<LearnerRecipe>& recipes, const std::string& assignment) {
    const std::size_t equals = assignment.find('=');
    const std::size_t dot = assignment.find('.');
    if (equals == std::string::npos || dot == std::string::npos || dot > equals) {
        refuse(assignment, "write it as NAME.key=value, such as sspql.lambda=1 or '*.gamma=.95'");
    }
    const std::string name = assignment.substr(0, dot);
    const std::string key = assignment.substr(dot + 1, equals - dot - 1);
    const std::string value = assignment.substr(equals + 1);
    bool assigned = false;
    const LearnerRecipe* named = nullptr;
    std::string names;
    for (LearnerRecipe& recipe : recipes) {
        names += (names.empty() ? "" : ", ") + recipe.name();
        if (name != "*" && name != recipe.name()) continue;
        named = &recipe;
        if (assign(recipe, assignment, key, value)) assigned = true;
    }
    if (named == nullptr) refuse(assignment, "'" + name + "' is none of the learners " + names);
    if (!assigned && name == "*") refuse(assignment, "none of the learners has a key '" + key + "'");
    if (!assigned) refuse(assignment, "unknown key '" + key + "'; known are " + joined(keys_of(named->kind())));
}

}  // namespace

std::vector<std::string> learner_names() {
    std::vector<std::string> names;
    for (const Preset& preset : presets) names.emplace_back(preset.name);
    return names;
}

std::vector<std::string> keys_of(LearnerKind kind) {
    std::vector<std::string> keys;
    for (const NumberKey& key : number_keys) {
        if (key.applies(kind)) keys.emplace_back(key.name);
    }
    for (const WordKey& key : word_keys) {
        if (key.applies(kind)) keys.emplace_back(key.name);
    }
    return keys;
}

std::vector<LearnerRecipe> learner_recipes(const std::string& names, const std::vector<std::string>& assignments) {
    std::vector<LearnerRecipe> recipes;
    if (names.empty()) throw std::invalid_argument("no learner named; known are " + joined(learner_names()));
    for (const std::string& name : split(names, ',')) {
        for (const LearnerRecipe& other : recipes) {
            if (other.name() == name) throw std::invalid_argument("learner '" + name + "' is named twice");
        }
        recipes.push_back(recipe_of(name));
    }
    for (const std::string& assignment : assignments) apply(recipes, assignment);
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
