// SPDX-License-Identifier: MIT
#include "report/mission_player.hpp"

#include <array>

#include "report/escape.hpp"
#include "report/palette.hpp"

namespace sspql::report {

namespace {

constexpr std::array<Ink, 19> used_inks{Ink::paper,   Ink::text,     Ink::faint,   Ink::axis,      Ink::grid,
                                        Ink::floor,   Ink::wall,     Ink::goal,    Ink::goal_edge, Ink::region,
                                        Ink::box,     Ink::box_edge, Ink::robot,   Ink::series0,   Ink::series1,
                                        Ink::series2, Ink::series3,  Ink::series4, Ink::series5};

std::string ink_variables(bool dark) {
    std::string css = "#player{";
    for (const Ink ink : used_inks) {
        css.append("--ink-").append(ink_name(ink)).append(":");
        css.append(dark ? dark_colour(ink) : light_colour(ink)).append(";");
    }
    return css + "}\n";
}

constexpr const char* player_css = R"css(
#player{margin:1.2rem 0 2rem}
#player *{box-sizing:border-box}
#pick{display:flex;flex-wrap:wrap;gap:.3rem;margin:.4rem 0 .8rem}
#player button{font:inherit;font-size:.875rem;color:var(--ink-text);background:var(--ink-floor);
border:1px solid var(--ink-axis);border-radius:5px;cursor:pointer}
#player #pick button{min-width:2.2rem;padding:.2rem .3rem;border-bottom-width:5px;font-variant-numeric:tabular-nums}
#player #pick .first{border-bottom-color:var(--ink-series3)}
#player #pick .won{border-bottom-color:var(--ink-series4)}
#player #pick .lost{border-bottom-color:var(--ink-series0)}
#player button[aria-pressed=true]{background:var(--ink-text);color:var(--ink-paper)}
#player :focus-visible{outline:2px solid var(--ink-series2);outline-offset:2px}
#outcome{margin:.2rem 0 .6rem;font-weight:600}
.theatre{display:grid;grid-template-columns:minmax(0,3fr) minmax(15rem,2fr);gap:1.2rem;align-items:start}
@media (max-width:46rem){.theatre{grid-template-columns:minmax(0,1fr)}}
#arena{display:block;width:100%;aspect-ratio:1}
#strip{display:block;width:100%;height:10px;border-radius:3px;margin-top:.7rem}
#scrub{width:100%;margin:.1rem 0 0;accent-color:var(--ink-series2)}
.controls{display:flex;flex-wrap:wrap;gap:.4rem .6rem;align-items:center;font-size:.8125rem}
.controls label{display:inline-flex;align-items:center;gap:.15rem}
#play{min-width:4.5rem;padding:.35rem .6rem;font-weight:600}
#time{font-variant-numeric:tabular-nums}
.controls select{font:inherit}
.steps{display:flex;list-style:none;margin:0 0 .8rem;padding:0;gap:.3rem}
.steps li{flex:1;text-align:center;padding:.25rem .2rem;border-radius:4px;font-size:.875rem;color:var(--ink-faint);
border:1px solid var(--ink-grid);border-top-width:5px}
.steps .done{color:var(--ink-text)}
.steps .now{color:var(--ink-text);font-weight:700;border-color:currentColor}
#task-search{border-top-color:var(--ink-series5)}#task-approach{border-top-color:var(--ink-series2)}
#task-turn{border-top-color:var(--ink-series1)}#task-push{border-top-color:var(--ink-series0)}
#doing{font-size:1.15rem;font-weight:600;margin:.2rem 0;min-height:2.6em;line-height:1.3}
#player dl{grid-template-columns:1fr max-content;font-size:.875rem;font-variant-numeric:tabular-nums}
#cell{font-size:.875rem;color:var(--ink-faint);min-height:3.2em;margin:.9rem 0 .3rem;line-height:1.4}
#worth{min-height:14rem}
.action{display:grid;grid-template-columns:1fr max-content;gap:0 .5rem;font-size:.8125rem;padding:.2rem .35rem;
border-left:4px solid transparent}
.action.chosen{border-left-color:var(--ink-text);font-weight:600}
.action small{grid-column:1/-1;font-size:.6875rem;color:var(--ink-faint);font-weight:400}
.action span{white-space:nowrap}
.action .value{font-variant-numeric:tabular-nums;text-align:right;font-size:.75rem}
.bar{grid-column:1/-1;display:flex;height:9px;background:var(--ink-grid);border-radius:2px;overflow:hidden}
.bar i{display:block}
.q{background:var(--ink-series2)}.ssp{background:var(--ink-series3)}.more{background:var(--ink-series4)}
.key{font-size:.8125rem;color:var(--ink-faint);line-height:1.7}
.key i{display:inline-block;width:.8em;height:.8em;border-radius:2px;margin:0 .3em 0 .7em}
.key i:first-child{margin-left:0}
#selftest{border:2px solid;padding:1rem}
kbd{font:inherit;border:1px solid var(--ink-axis);border-radius:3px;padding:0 .3em}
@media print{#player .controls,#scrub,#pick{display:none}}
)css";

constexpr const char* player_html = R"html(
<p id="outcome" aria-live="polite"></p>
<div class="theatre">
<div>
<canvas id="arena" role="img" aria-label="The arena from above: robot, box, goal, what the robot senses and believes"></canvas>
<canvas id="strip" aria-hidden="true"></canvas>
<input id="scrub" type="range" min="0" max="1" value="0" step="any" aria-label="time in the mission">
<div class="controls">
<button id="play" type="button">Play</button>
<span id="time"></span>
<label>speed <select id="speed"><option value="1">1x</option><option value="2">2x</option><option value="4" selected>4x</option><option value="8">8x</option><option value="16">16x</option></select></label>
<label><input id="show-camera" type="checkbox" checked> camera</label>
<label><input id="show-sonars" type="checkbox" checked> sonars</label>
<label><input id="show-beliefs" type="checkbox" checked> beliefs</label>
<label><input id="show-cells" type="checkbox" checked> cells</label>
</div>
</div>
<div>
<ol class="steps"><li id="task-search">search</li><li id="task-approach">approach</li><li id="task-turn">turn</li><li id="task-push">push</li></ol>
<p id="doing"></p>
<dl>
<dt>attempt</dt><dd id="attempt"></dd>
<dt>from the box to the goal</dt><dd id="rest"></dd>
<dt>box believed off by, from here</dt><dd id="box-error"></dd>
<dt>goal believed off by, from here</dt><dd id="goal-error"></dd>
<dt>odometry off by</dt><dd id="drift"></dd>
</dl>
<p id="cell"></p>
<div id="worth"></div>
<p class="key"><i class="q"></i>w_Q Q <i class="ssp"></i>w_SSP Q_SSP <i class="more"></i>w_EXP Q_EXP</p>
</div>
</div>
<p class="note"><kbd>space</kbd> plays and pauses, <kbd>&larr;</kbd> <kbd>&rarr;</kbd> step by one action (with <kbd>shift</kbd> by ten),
<kbd>Home</kbd> <kbd>End</kbd>, <kbd>n</kbd> <kbd>p</kbd> next and previous mission.</p>
<p class="note">Blue and dashed is what the robot believes: where it is itself, the box, the goal; a blue disc is twice the
standard deviation. The yellow cone is what the camera sees, green dots are the sonars' echoes. In the background: the cells
in which the learnt parts think, and behind the box the region they seek. How far there is to go is the expected length of the
shortest path learnt, on which what goes astray counts as standing still. The floor's squares are half a metre wide. Under a
mission's number: green for a box in the goal at the first push, orange for later, red for never.</p>
)html";

}  // namespace

std::string mission_player(const ReplayStage& stage, const std::vector<MissionReplay>& replays) {
    std::string out = "<style>\n" + ink_variables(false) + "@media screen and (prefers-color-scheme:dark){\n" +
                      ink_variables(true) + "}" + player_css + "</style>\n";
    out += "<div id=\"player\">\n<div id=\"pick\" role=\"group\" aria-label=\"missions\"></div>";
    out += player_html;
    out += "</div>\n<script type=\"application/json\" id=\"mission-data\">\n" + replay_json(stage, replays) +
           "</script>\n";
    out += "<script>\n(() => {\n'use strict';\nconst errors = [];\n";
    out += "window.addEventListener('error', e => errors.push(e.message));\n";
    out += "window.addEventListener('unhandledrejection', e => errors.push(String(e.reason)));";
    out += mission_drawing_script();
    out += mission_control_script();
    return out + "})();\n</script>\n";
}

}  // namespace sspql::report
