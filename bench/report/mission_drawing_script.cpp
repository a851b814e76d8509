// SPDX-License-Identifier: MIT
#include "report/mission_player.hpp"

namespace sspql::report {

const char* mission_drawing_script() {
    return R"js(
const data = JSON.parse(document.getElementById('mission-data').textContent);
const stage = data.stage;
const tasks = ['search', 'approach', 'turn', 'push'];
const taskInks = ['series5', 'series2', 'series1', 'series0'];
const deg = Math.PI / 180;

// A moment's list of whole numbers, by name. The order is that of the report's writer.
function moment(row) {
  const mm = i => row[i] / 1000;
  const pose = i => ({x: mm(i), y: mm(i + 1), a: mm(i + 2)});
  const belief = i => row[i + 2] < 0 ? null : {x: mm(i), y: mm(i + 1), d: mm(i + 2)};
  const terms = [];
  for (let i = 40; i < row.length; i += 6) {
    terms.push({q: mm(i), ssp: mm(i + 1), more: mm(i + 2), n: row[i + 3], next: row[i + 4], toGo: mm(i + 5)});
  }
  return {task: row[0], attempt: row[1], robot: pose(2), box: pose(5), odometry: pose(8), boxBelief: belief(11),
    goalBelief: belief(14), boxSeen: (row[17] & 1) > 0, goalSeen: (row[17] & 2) > 0, seconds: mm(18),
    command: row[19], amount: mm(20), state: row[21], action: row[22], toGo: mm(23), sonars: row.slice(24, 40).map(v => v / 100),
    terms: terms};
}
for (const m of data.missions) {
  m.moments = m.moments.map(moment);
  let t = 0;
  for (const k of m.moments) { k.t = t; t += k.seconds; }
  m.seconds = t;
}

const canvas = document.getElementById('arena');
const pen = canvas.getContext('2d');
let inks = {};
function readInks() {
  const style = getComputedStyle(document.getElementById('player'));
  for (const name of ['paper', 'text', 'faint', 'axis', 'grid', 'floor', 'wall', 'goal', 'goal-edge', 'region', 'box',
    'box-edge', 'robot', 'series0', 'series1', 'series2', 'series3', 'series4', 'series5']) {
    inks[name] = style.getPropertyValue('--ink-' + name).trim();
  }
}

let scale = 100;
const at = p => [(p.x + stage.half) * scale + edge, (stage.half - p.y) * scale + edge];
const edge = 8;
function fit() {
  const side = canvas.clientWidth;
  const dots = window.devicePixelRatio || 1;
  canvas.width = canvas.height = Math.round(side * dots);
  pen.setTransform(dots, 0, 0, dots, 0, 0);
  scale = (side - 2 * edge) / (2 * stage.half);
}

const between = (a, b, f) => a + (b - a) * f;
const turned = (a, b, f) => a + Math.atan2(Math.sin(b - a), Math.cos(b - a)) * f;
const poseBetween = (p, q, f) => ({x: between(p.x, q.x, f), y: between(p.y, q.y, f), a: turned(p.a, q.a, f)});
const off = (p, q) => Math.hypot(p.x - q.x, p.y - q.y);
const ahead = (p, angle, d) => ({x: p.x + d * Math.cos(angle), y: p.y + d * Math.sin(angle)});

function stroke(ink, width, dash, alpha) {
  pen.strokeStyle = inks[ink]; pen.lineWidth = width; pen.setLineDash(dash || []);
  pen.globalAlpha = alpha === undefined ? 1 : alpha; pen.stroke(); pen.globalAlpha = 1; pen.setLineDash([]);
}
function fill(ink, alpha) {
  pen.fillStyle = inks[ink]; pen.globalAlpha = alpha === undefined ? 1 : alpha; pen.fill(); pen.globalAlpha = 1;
}
function line(points) { pen.beginPath(); for (const p of points) pen.lineTo(...at(p)); }
function disc(p, r) { pen.beginPath(); pen.arc(...at(p), Math.max(r, 0) * scale, 0, 2 * Math.PI); }
function oblong(p, length, width) {
  const c = Math.cos(p.a), s = Math.sin(p.a);
  pen.beginPath();
  for (const [u, v] of [[1, 1], [-1, 1], [-1, -1], [1, -1]]) {
    const x = u * length / 2, y = v * width / 2;
    pen.lineTo(...at({x: p.x + x * c - y * s, y: p.y + x * s + y * c}));
  }
  pen.closePath();
}

// How far one sees from a point: to the box or a wall.
function sight(from, angle, box) {
  const d = {x: Math.cos(angle), y: Math.sin(angle)};
  let far = Infinity;
  if (d.x) far = Math.min(far, ((d.x > 0 ? stage.half : -stage.half) - from.x) / d.x);
  if (d.y) far = Math.min(far, ((d.y > 0 ? stage.half : -stage.half) - from.y) / d.y);
  const c = Math.cos(box.a), s = Math.sin(box.a), x = from.x - box.x, y = from.y - box.y, h = stage.box / 2;
  let enter = 0, leave = Infinity;
  for (const [p, v] of [[x * c + y * s, d.x * c + d.y * s], [y * c - x * s, d.y * c - d.x * s]]) {
    if (Math.abs(v) < 1e-12) { if (Math.abs(p) > h) leave = -1; continue; }
    enter = Math.max(enter, Math.min((-h - p) / v, (h - p) / v));
    leave = Math.min(leave, Math.max((-h - p) / v, (h - p) / v));
  }
  return Math.max(0, enter <= leave ? Math.min(far, enter) : far);
}

function drawFloor() {
  const side = canvas.clientWidth;
  pen.clearRect(0, 0, side, side);
  pen.beginPath(); pen.rect(edge, edge, side - 2 * edge, side - 2 * edge); fill('floor');
  for (let v = -Math.floor(stage.half); v <= stage.half; v += 0.5) {
    line([{x: v, y: -stage.half}, {x: v, y: stage.half}]); stroke('grid', 1);
    line([{x: -stage.half, y: v}, {x: stage.half, y: v}]); stroke('grid', 1);
  }
}

// The cells of Fig. 7 about the believed box, while a learnt sub-task looks at them.
function drawCells(m) {
  if (!m.boxBelief || !m.goalBelief || m.state < 0) return;
  const middle = m.boxBelief, phi = Math.atan2(m.goalBelief.y - middle.y, m.goalBelief.x - middle.x);
  const slice = (from, to, r0, r1) => {
    const [x, y] = at(middle);
    pen.beginPath();
    pen.arc(x, y, r1 * scale, -to, -from); pen.arc(x, y, r0 * scale, -from, -to, true); pen.closePath();
  };
  slice(phi + 165 * deg, phi + 195 * deg, 0.2, 1.3); fill('region', 0.45);
  if (m.task === 1) {
    const place = Math.floor(m.state / 12), ring = Math.floor(place / 12), sector = place % 12;
    const edges = [0.2, 0.7, 1, 1.3];
    slice(phi + (sector * 30 - 15) * deg, phi + (sector * 30 + 15) * deg, edges[ring], edges[ring + 1]);
    fill('series2', 0.28);
  }
  for (const r of [0.7, 1, 1.3]) { disc(middle, r); stroke('axis', 1, r > 1.2 ? [2, 5] : [], 0.7); }
  for (let i = 0; i < 12; ++i) {
    const a = phi + (i * 30 + 15) * deg;
    line([ahead(middle, a, 0.22), ahead(middle, a, 1.3)]); stroke('axis', 1, [], 0.45);
  }
}

function drawSensors(m, n, f, robot, box) {
  if (show.camera) {
    pen.beginPath(); pen.moveTo(...at(robot));
    for (let i = 0; i <= 60; ++i) {
      const a = robot.a + stage.field * (i / 60 - 0.5);
      pen.lineTo(...at(ahead(robot, a, sight(robot, a, box))));
    }
    pen.closePath(); fill('series4', 0.2); stroke('series4', 1, [], 0.6);
  }
  if (!show.sonars) return;
  for (let i = 0; i < 16; ++i) {
    const a = robot.a + i * 22.5 * deg;
    const reading = between(m.sonars[i], n.sonars[i], f);
    const from = ahead(robot, a, stage.sonars[i]), to = ahead(from, a, reading);
    line([from, to]); stroke('series3', 1, [], 0.35);
    pen.beginPath(); pen.arc(...at(to), 2.2, 0, 2 * Math.PI); fill('series3', 0.9);
  }
}

function drawBox(box, alpha) {
  oblong(box, stage.box, stage.box); fill('box', alpha); stroke('box-edge', 2, [], alpha);
  oblong(box, stage.box * 0.68, stage.box * 0.68); stroke('box-edge', 1, [], alpha);
  const h = stage.box * 0.34 * Math.SQRT2;
  for (const a of [45, 135]) {
    line([ahead(box, box.a + a * deg, h), ahead(box, box.a + a * deg, -h)]); stroke('box-edge', 1, [], alpha);
  }
}

function drawBeliefs(m, odometry) {
  if (!show.beliefs) return;
  oblong(odometry, stage.length, stage.width); stroke('series2', 1.5, [4, 3]);
  if (m.goalBelief) {
    disc(m.goalBelief, stage.goal); stroke('series2', 1.8, [6, 4]);
    disc(m.goalBelief, 2 * m.goalBelief.d); fill('series2', 0.22);
    line([{x: m.goalBelief.x - .05, y: m.goalBelief.y}, {x: m.goalBelief.x + .05, y: m.goalBelief.y}]); stroke('series2', 2);
    line([{x: m.goalBelief.x, y: m.goalBelief.y - .05}, {x: m.goalBelief.x, y: m.goalBelief.y + .05}]); stroke('series2', 2);
  }
  if (m.boxBelief) {
    disc(m.boxBelief, stage.box / 2); stroke('series2', 1.8, [6, 4]);
    disc(m.boxBelief, 2 * m.boxBelief.d); fill('series2', 0.22);
  }
}

function drawTrail(mission, i, robot) {
  const moments = mission.moments;
  pen.lineJoin = pen.lineCap = 'round';
  for (let k = 0; k <= i;) {
    let end = k;
    while (end <= i && moments[end].task === moments[k].task) ++end;
    const points = moments.slice(k, end + 1).map(q => q.robot);
    if (end > i) { points.length = i - k + 1; points.push(robot); }
    line(points); stroke(taskInks[moments[k].task], 2.4, [], 0.75);
    k = end;
  }
  line(moments.slice(0, i + 1).map(q => q.box)); stroke('box-edge', 1.5, [2, 4]);
  pen.lineCap = 'butt';
}

function drawRobot(m, robot) {
  oblong(robot, stage.length, stage.width); fill('robot'); stroke('wall', 2);
  const nose = ahead(robot, robot.a, stage.length / 2), back = ahead(robot, robot.a, stage.length / 2 - 0.2);
  const left = ahead(back, robot.a + Math.PI / 2, 0.08), right = ahead(back, robot.a - Math.PI / 2, 0.08);
  pen.beginPath(); pen.moveTo(...at(nose)); pen.lineTo(...at(left)); pen.lineTo(...at(right)); pen.closePath();
  fill(taskInks[m.task]);
}

function draw(mission, i, f) {
  const m = mission.moments[i], n = mission.moments[Math.min(i + 1, mission.moments.length - 1)];
  const robot = poseBetween(m.robot, n.robot, f), box = poseBetween(m.box, n.box, f);
  const odometry = poseBetween(m.odometry, n.odometry, f);
  const goal = {x: mission.goal[0], y: mission.goal[1]};
  drawFloor();
  pen.save();
  pen.beginPath(); pen.rect(edge, edge, canvas.clientWidth - 2 * edge, canvas.clientHeight - 2 * edge); pen.clip();
  if (show.cells) drawCells(m);
  disc(goal, stage.goal); fill('goal', 0.9); stroke('goal-edge', 2);
  drawSensors(m, n, f, robot, box);
  drawTrail(mission, i, robot);
  drawBox(box);
  drawRobot(m, robot);
  drawBeliefs(m, odometry);
  pen.restore();
  pen.font = '600 13px system-ui, sans-serif'; pen.textAlign = 'center'; pen.fillStyle = inks.text;
  const [gx, gy] = at(goal);
  const low = gy + stage.goal * scale + 16;
  pen.fillText('goal', gx, low > canvas.clientHeight - 6 ? gy - stage.goal * scale - 6 : low);
  pen.beginPath();
  pen.rect(edge - 3, edge - 3, canvas.clientWidth - 2 * edge + 6, canvas.clientHeight - 2 * edge + 6);
  stroke('wall', 6);
}
)js";
}

}  // namespace sspql::report
