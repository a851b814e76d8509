// SPDX-License-Identifier: MIT
#include "experiment/learnt_grid.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <string>

#include <sspql/env/grid_world.hpp>

#include "report/numbers.hpp"

namespace sspql::experiment {

namespace {

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

}  // namespace

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

}  // namespace sspql::experiment
