// SPDX-License-Identifier: MIT
#include "viewer/panel_view.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "report/numbers.hpp"
#include "viewer/policy_view.hpp"

namespace sspql::viewer {

namespace {

using experiment::Decision;
using experiment::LiveRun;
using experiment::LiveSession;
using report::Ink;

struct Term {
    const char* name;
    Ink ink;
    double (*of)(const ActionTerms&);
};

/// The colours are those of the missions' report.
constexpr std::array<Term, 3> all_terms{{
    {"w_Q Q", Ink::series2, [](const ActionTerms& t) { return t.q; }},
    {"w_SSP Q_SSP", Ink::series3, [](const ActionTerms& t) { return t.ssp; }},
    {"w_EXP Q_EXP", Ink::series4, [](const ActionTerms& t) { return t.exploration + t.hint; }},
}};

/// The simulator's words with the signs that a font has and a terminal may not.
std::string with_signs(std::string text) {
    constexpr std::array<std::array<const char*, 2>, 3> signs{{{" deg", "°"}, {"<=", "≤"}, {">=", "≥"}}};
    for (const auto& [word, sign] : signs) {
        for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word)) {
            text.replace(at, std::char_traits<char>::length(word), sign);
        }
    }
    return text;
}

class PanelPainter {
public:
    PanelPainter(Canvas& canvas, Spot corner, float width, const LiveSession& session)
        : canvas_(canvas),
          session_(session),
          run_(session.run()),
          left_(corner.x),
          right_(corner.x + width),
          y_(corner.y) {}

    void paint_head(const PanelCaption& caption) {
        const TextStyle name{Ink::text, 30.0F, Align::left, true};
        canvas_.text({left_, y_ + 26.0F}, canvas_.fitted(run_.learner_name(), right_ - left_ - 60.0F, name), name);
        const std::string place = std::to_string(run_.learner() + 1) + "/" + std::to_string(run_.recipes().size());
        canvas_.text({right_, y_ + 26.0F}, place, {Ink::faint, 15.0F, Align::right});
        canvas_.text({left_, y_ + 50.0F}, caption.setting + ", seed " + std::to_string(run_.seed()), {Ink::faint});
        y_ += 66.0F;
    }

    void paint_counts() {
        const float column = (right_ - left_) / 3.0F;
        const std::array<std::string, 3> names{"episode", "step", "steps in all"};
        const std::array<std::size_t, 3> counts{run_.episode(), run_.episode_steps(), run_.total_steps()};
        for (std::size_t i = 0; i < names.size(); ++i) {
            const float x = left_ + static_cast<float>(i) * column;
            canvas_.text({x, y_ + 14.0F}, names[i], {Ink::faint, 14.0F});
            canvas_.text({x, y_ + 44.0F}, std::to_string(counts[i]), {Ink::text, 28.0F});
        }
        y_ += 60.0F;
        const bool stands = session_.is_paused() || run_.is_over();
        const std::string state = run_.is_over() ? "the run is over" : session_.is_paused() ? "paused" : "running";
        canvas_.circle({left_ + 6.0F, y_ + 9.0F}, 6.0F, colour(stands ? Ink::series4 : Ink::series3));
        canvas_.text({left_ + 20.0F, y_ + 14.0F}, state + ", " + session_.pace().text(), {Ink::text, 15.0F});
        y_ += 40.0F;
    }

    void paint_decision() {
        const Decision& decision = session_.shown_decision();
        canvas_.text({left_, y_ + 14.0F},
                     run_.is_episode_over()    ? "its last choice, in the state"
                     : session_.is_under_way() ? "its choice, in the state"
                                               : "its next choice, in the state",
                     {Ink::faint, 14.0F});
        canvas_.text({left_, y_ + 35.0F}, with_signs(run_.world().state_text(decision.state)), {Ink::text, 15.0F});
        y_ += 48.0F;
        double low = 0.0;
        double high = 1e-9;
        for (const ActionTerms& terms : decision.terms) {
            double below = 0.0;
            double above = 0.0;
            for (const Term& term : all_terms) (term.of(terms) < 0.0 ? below : above) += term.of(terms);
            low = std::min(low, below);
            high = std::max(high, above);
        }
        for (std::size_t a = 0; a < decision.terms.size(); ++a) paint_action(decision, a, low, high);
        float x = left_;
        for (const Term& term : all_terms) {
            canvas_.rect({x, y_ + 3.0F}, {12.0F, 12.0F}, colour(term.ink));
            canvas_.text({x + 18.0F, y_ + 14.0F}, term.name, {Ink::faint, 14.0F});
            x += 34.0F + canvas_.text_width(term.name, {Ink::faint, 14.0F});
        }
        y_ += 34.0F;
    }

    [[nodiscard]] float y() const { return y_; }

private:
    static constexpr float row = 44.0F;

    void paint_action(const Decision& decision, std::size_t a, double low, double high) {
        const ActionTerms& terms = decision.terms[a];
        const bool chosen = index(decision.action) == a;
        if (chosen) {
            canvas_.rect({left_ - 8.0F, y_}, {right_ - left_ + 16.0F, row - 2.0F}, colour(Ink::grid));
            canvas_.rect({left_ - 8.0F, y_}, {4.0F, row - 2.0F}, colour(Ink::series4));
        }
        const sim::PusherCommand command = run_.world().command(action_id(a));
        draw_action_sign(canvas_, {left_ + 14.0F, y_ + 21.0F}, 11.0F, 0.5 * sim::pi, command,
                         colour(chosen ? Ink::text : Ink::faint));
        canvas_.text({left_ + 36.0F, y_ + 17.0F}, with_signs(run_.world().action_text(action_id(a))),
                     {chosen ? Ink::text : Ink::faint, 15.0F, Align::left, chosen});
        canvas_.text({right_, y_ + 17.0F}, "tried " + report::short_text(terms.n, 3) + " ×",
                     {Ink::faint, 14.0F, Align::right});
        const float begin = left_ + 36.0F;
        const float whole = right_ - begin - 66.0F;
        const auto x_of = [&](double value) {
            return begin + whole * static_cast<float>((value - low) / (high - low));
        };
        double above = 0.0;
        double below = 0.0;
        canvas_.rect({begin, y_ + 25.0F}, {whole, 10.0F}, colour(Ink::axis, 0.18));
        for (const Term& term : all_terms) {
            const double value = term.of(terms);
            double& end = value < 0.0 ? below : above;
            const float from = x_of(std::min(end, end + value));
            const float to = x_of(std::max(end, end + value));
            canvas_.rect({from, y_ + 25.0F}, {to - from, 10.0F}, colour(term.ink));
            end += value;
        }
        canvas_.text({right_, y_ + 35.0F}, report::short_text(terms.sum(), std::fabs(terms.sum()) < 0.1 ? 5 : 3),
                     {Ink::text, 14.0F, Align::right});
        y_ += row;
    }

    Canvas& canvas_;
    const LiveSession& session_;
    const LiveRun& run_;
    float left_;
    float right_;
    float y_;
};

struct Key {
    const char* keys;
    const char* meaning;
};

constexpr std::array<Key, 8> all_keys{{
    {"space", "pause, go on"},
    {"↑ ↓  or  + −", "faster, slower"},
    {"n", "one action, then pause"},
    {"l", "the next learner, from nothing"},
    {"1 to 9", "the learner of that number"},
    {"r", "begin anew with the next seed"},
    {"h", "this help"},
    {"q  or  Esc", "quit"},
}};

}  // namespace

float draw_panel(Canvas& canvas, Spot corner, float width, const LiveSession& session, const PanelCaption& caption) {
    PanelPainter painter(canvas, corner, width, session);
    painter.paint_head(caption);
    painter.paint_counts();
    painter.paint_decision();
    return painter.y();
}

void draw_help_line(Canvas& canvas, Spot baseline) {
    static constexpr std::array<Key, 7> short_keys{{{"space", "pause"},
                                                    {"↑ ↓", "speed"},
                                                    {"n", "one action"},
                                                    {"l, 1 to 9", "learner"},
                                                    {"r", "next seed"},
                                                    {"h", "help"},
                                                    {"q", "quit"}}};
    const TextStyle bold{Ink::text, 15.0F, Align::left, true};
    const TextStyle plain{Ink::faint, 15.0F};
    for (const Key& key : short_keys) {
        canvas.text(baseline, key.keys, bold);
        baseline.x += canvas.text_width(key.keys, bold) + 8.0F;
        canvas.text(baseline, key.meaning, plain);
        baseline.x += canvas.text_width(key.meaning, plain) + 26.0F;
    }
}

void draw_help(Canvas& canvas, const LiveSession& session) {
    const LiveRun& run = session.run();
    canvas.rect({0.0F, 0.0F}, {canvas_width, canvas_height}, colour(Ink::paper, 0.72));
    const float rows = static_cast<float>(all_keys.size() + std::min<std::size_t>(9, run.recipes().size()));
    const Spot size(520.0F, 80.0F + 30.0F * rows);
    const Spot corner(0.5F * (canvas_width - size.x), 0.5F * (canvas_height - size.y));
    canvas.rect(corner, size, colour(Ink::floor));
    canvas.frame(corner, size, colour(Ink::axis), 1.5F);
    float y = corner.y + 44.0F;
    canvas.text({corner.x + 32.0F, y}, "Keys", {Ink::text, 22.0F, Align::left, true});
    for (const Key& key : all_keys) {
        y += 30.0F;
        canvas.text({corner.x + 32.0F, y}, key.keys, {Ink::text, 17.0F, Align::left, true});
        canvas.text({corner.x + 200.0F, y}, key.meaning, {Ink::text, 17.0F});
    }
    y += 14.0F;
    for (std::size_t i = 0; i < std::min<std::size_t>(9, run.recipes().size()); ++i) {
        y += 30.0F;
        const bool running = i == run.learner();
        canvas.text({corner.x + 32.0F, y}, std::to_string(i + 1), {Ink::text, 17.0F, Align::left, true});
        canvas.text({corner.x + 200.0F, y}, run.recipes()[i].name() + (running ? "  (learning now)" : ""),
                    {running ? Ink::series4 : Ink::text, 17.0F});
    }
}

}  // namespace sspql::viewer
