// SPDX-License-Identifier: MIT
#include "viewer/curve_view.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "report/axis.hpp"

namespace sspql::viewer {

namespace {

using experiment::LiveEpisode;
using experiment::LiveRun;
using experiment::LiveSession;
using report::Ink;

constexpr std::size_t fewest_episodes = 20;  // the axis is never shorter
constexpr std::size_t most_points = 120;

class CurvePainter {
public:
    CurvePainter(Canvas& canvas, Spot corner, Spot size, const LiveSession& session)
        : canvas_(canvas), session_(session), run_(session.run()) {
        left_ = corner.x + 44.0F;
        right_ = corner.x + size.x;
        top_ = corner.y + 26.0F;
        bottom_ = corner.y + size.y - 22.0F;
        std::size_t most = std::max(fewest_episodes, run_.episode());
        double low = 5.0;
        double high = 100.0;
        const auto span = [&](const std::vector<LiveEpisode>& episodes) {
            most = std::max(most, episodes.size());
            for (const LiveEpisode& episode : episodes) {
                low = std::min(low, static_cast<double>(episode.steps));
                high = std::max(high, static_cast<double>(episode.steps));
            }
        };
        span(run_.episodes());
        for (const auto& past : session.past()) span(past.episodes);
        high = std::max(high, static_cast<double>(run_.episode_steps()));
        x_ = report::whole_axis(1.0, static_cast<double>(most), 6);
        y_ = report::log_axis(std::max(1.0, low), high);
        group_ = (most + most_points - 1) / most_points;
    }

    void paint() {
        canvas_.text({left_ - 44.0F, top_ - 12.0F}, "steps of each episode", {Ink::faint, 14.0F});
        for (const double tick : y_.ticks) {
            const float y = y_at(tick);
            canvas_.line({left_, y}, {right_, y}, colour(Ink::grid), 1.0F);
            canvas_.text({left_ - 7.0F, y + 4.5F}, report::tick_text(tick), {Ink::faint, 12.0F, Align::right});
        }
        for (const double tick : x_.ticks) {
            canvas_.text({x_at(tick), bottom_ + 16.0F}, report::tick_text(tick), {Ink::faint, 12.0F, Align::centre});
        }
        canvas_.line({left_, bottom_}, {right_, bottom_}, colour(Ink::axis), 1.2F);
        float label = top_ + 4.0F;
        for (const auto& past : session_.past()) {
            const Ink ink = ink_of(past.learner);
            canvas_.polyline(points(past.episodes), colour(ink, 0.55), 1.5F);
            canvas_.text({right_, label}, run_.recipes()[past.learner].name(), {ink, 12.0F, Align::right});
            label += 15.0F;
        }
        const std::vector<Spot> now = points(run_.episodes());
        canvas_.polyline(now, colour(Ink::text), 2.2F);
        for (const Spot& spot : now) canvas_.circle(spot, 2.6F, colour(Ink::text));
        if (!run_.is_episode_over() && run_.episode_steps() > 0) {
            const Spot head(x_at(static_cast<double>(run_.episode())), y_at(static_cast<double>(run_.episode_steps())));
            canvas_.circle(head, 3.5F, colour(Ink::paper), colour(Ink::series4), 2.0F);
        }
    }

private:
    /// The other learners, each in its colour: those of lines that are told apart on dark ground.
    [[nodiscard]] static Ink ink_of(std::size_t learner) {
        static constexpr Ink inks[] = {Ink::series2, Ink::series1, Ink::series3, Ink::series0,
                                       Ink::series5, Ink::series7, Ink::series4};
        return inks[learner % std::size(inks)];
    }

    [[nodiscard]] float x_at(double episode) const {
        return left_ + (right_ - left_) * static_cast<float>(x_.fraction(episode));
    }
    [[nodiscard]] float y_at(double steps) const {
        return bottom_ - (bottom_ - top_) * static_cast<float>(y_.fraction(std::max(steps, y_.low)));
    }

    [[nodiscard]] std::vector<Spot> points(const std::vector<LiveEpisode>& episodes) const {
        std::vector<Spot> spots;
        for (std::size_t begin = 0; begin < episodes.size(); begin += group_) {
            const std::size_t end = std::min(begin + group_, episodes.size());
            double sum = 0.0;
            for (std::size_t i = begin; i < end; ++i) sum += static_cast<double>(episodes[i].steps);
            const double middle = 0.5 * static_cast<double>(begin + end - 1) + 1.0;
            spots.emplace_back(x_at(middle), y_at(sum / static_cast<double>(end - begin)));
        }
        return spots;
    }

    Canvas& canvas_;
    const LiveSession& session_;
    const LiveRun& run_;
    float left_;
    float right_;
    float top_;
    float bottom_;
    report::Axis x_;
    report::Axis y_;
    std::size_t group_ = 1;
};

}  // namespace

void draw_curve(Canvas& canvas, Spot corner, Spot size, const LiveSession& session) {
    CurvePainter(canvas, corner, size, session).paint();
}

}  // namespace sspql::viewer
