// SPDX-License-Identifier: MIT
#include "report/mission_player.hpp"

namespace sspql::report {

const char* mission_control_script() {
    return R"js(
const el = id => document.getElementById(id);
const show = {sonars: true, camera: true, beliefs: true, cells: true};
const slider = el('scrub'), playButton = el('play'), speedChoice = el('speed'), strip = el('strip');
let mission = data.missions[0], clock = 0, playing = false, last = 0, turn = 0, shownMoment = -1;

// The moment a time belongs to: the last one that has begun.
function momentAt(t) {
  const k = mission.moments;
  let low = 0, high = k.length - 1;
  while (low < high) { const mid = (low + high + 1) >> 1; if (k[mid].t <= t) low = mid; else high = mid - 1; }
  return low;
}

function clockText(t) {
  const s = Math.floor(t + 1e-6);
  return Math.floor(s / 60) + ':' + String(s % 60).padStart(2, '0');
}
const cm = metres => (100 * metres).toFixed(0) + ' cm';
// A place as seen from a pose: what the robot acts on, whatever has become of its frame.
function seenFrom(p, pose) {
  const c = Math.cos(pose.a), s = Math.sin(pose.a), x = p.x - pose.x, y = p.y - pose.y;
  return {x: x * c + y * s, y: y * c - x * s};
}

function commandText(m) {
  if (m.command < 0) return 'over: ' + mission.outcome;
  if (m.action >= 0) return (m.task === 1 ? stage.approach : stage.turn)[m.action];
  const size = Math.abs(m.amount);
  if (m.command === 1) return 'turn ' + (m.amount / deg).toFixed(0) + ' deg';
  return (m.amount < 0 ? 'back ' : 'forward ') + size.toFixed(2) + ' m';
}

function toGoText(way) { return way < 0 ? 'no way known' : way.toFixed(mission.unit === 'steps' ? 1 : 3) + ' ' + mission.unit + ' to go'; }

function cellText(m) {
  const place = placeText(m);
  return m.state < 0 ? place : place + '; ' + toGoText(m.toGo);
}

function placeText(m) {
  if (m.state < 0) return m.command < 0 ? '' : 'not a learnt sub-task: a rule decides';
  if (m.task === 2) return 'state ' + m.state + ' of 12: heading ' + m.state * 30 + ' deg';
  const place = Math.floor(m.state / 12);
  const rings = ['r < 0.7 m', '0.7 m to 1 m', 'r > 1 m'];
  return 'state ' + m.state + ' of 432: sector ' + (place % 12) * 30 + ' deg, ' + rings[Math.floor(place / 12)] +
    ', heading ' + (m.state % 12) * 30 + ' deg';
}

// The terms of eq. 8 as bars, an action a row; built anew for every moment.
function showWorth(m) {
  const box = el('worth');
  box.textContent = '';
  if (!m.terms.length) return;
  const names = m.task === 1 ? stage.approach : stage.turn;
  const sums = m.terms.map(t => t.q + t.ssp + t.more);
  const top = Math.max(1e-3, ...sums);
  m.terms.forEach((t, a) => {
    const row = document.createElement('div');
    row.className = 'action' + (a === m.action ? ' chosen' : '');
    const bar = document.createElement('div');
    bar.className = 'bar';
    for (const part of ['q', 'ssp', 'more']) {
      const piece = document.createElement('i');
      piece.className = part;
      piece.style.width = Math.max(0, 100 * t[part] / top) + '%';
      bar.append(piece);
    }
    const parts = [t.q, t.ssp, t.more].map(v => v.toFixed(3)).join(' + ');
    const label = document.createElement('span'), value = document.createElement('span');
    const tried = document.createElement('small');
    label.textContent = names[a];
    tried.textContent = t.n === 0 ? 'never tried' : 'tried ' + t.n + 'x' +
      (t.next < 0 ? '' : ', mostly to ' + t.next + ', ' + toGoText(t.toGo));
    value.textContent = parts + ' = ' + sums[a].toFixed(3);
    value.className = 'value';
    row.append(label, value, bar, tried);
    box.append(row);
  });
}

function showPanel(i) {
  const m = mission.moments[i];
  tasks.forEach((name, t) => {
    el('task-' + name).className = m.command < 0 ? (mission.won ? 'done' : '') : t === m.task ? 'now' : t < m.task ? 'done' : '';
  });
  el('doing').textContent = commandText(m);
  el('attempt').textContent = m.attempt;
  el('cell').textContent = cellText(m);
  const goal = {x: mission.goal[0], y: mission.goal[1]};
  const error = (belief, truth) => belief ? cm(off(seenFrom(belief, m.odometry), seenFrom(truth, m.robot))) : 'unknown';
  el('box-error').textContent = error(m.boxBelief, m.box) + (m.boxSeen ? ', in view' : '');
  el('goal-error').textContent = error(m.goalBelief, goal) + (m.goalSeen ? ', in view' : '');
  el('drift').textContent = cm(off(m.odometry, m.robot));
  el('rest').textContent = cm(off(m.box, goal));
  showWorth(m);
}

function render() {
  const i = momentAt(clock), m = mission.moments[i];
  const f = m.seconds > 0 ? Math.min(1, (clock - m.t) / m.seconds) : 0;
  draw(mission, i, f);
  if (i !== shownMoment) { shownMoment = i; showPanel(i); }
  slider.value = clock;
  slider.setAttribute('aria-valuetext', tasks[m.task] + ', ' + clockText(clock));
  el('time').textContent = clockText(clock) + ' / ' + clockText(mission.seconds);
}

function drawStrip() {
  const wide = strip.clientWidth, dots = window.devicePixelRatio || 1, pen2 = strip.getContext('2d');
  strip.width = wide * dots; strip.height = strip.clientHeight * dots;
  pen2.scale(dots, dots);
  for (const m of mission.moments) {
    pen2.fillStyle = inks[taskInks[m.task]];
    pen2.fillRect(wide * m.t / mission.seconds, 0, wide * m.seconds / mission.seconds + 0.6, strip.clientHeight);
  }
}

function setPlaying(on) {
  if (on && clock >= mission.seconds) clock = 0;
  playing = on;
  playButton.textContent = on ? 'Pause' : 'Play';
  last = 0;
  ++turn;
  if (on) nextFrame();
}
// The browser's next frame; where it draws none for a while (a window out of sight), the film goes on all the same.
function nextFrame() {
  const mine = ++turn;
  const go = now => { if (mine === turn && playing) tick(now); };
  requestAnimationFrame(go);
  setTimeout(() => go(performance.now()), 150);
}
function tick(now) {
  const passed = last ? Math.max(0, Math.min(0.2, (now - last) / 1000)) : 0;
  clock = Math.min(mission.seconds, clock + passed * Number(speedChoice.value));
  last = now;
  render();
  if (clock >= mission.seconds) setPlaying(false); else nextFrame();
}
function seek(t) { clock = Math.max(0, Math.min(mission.seconds, t)); render(); }
function stepBy(n) {
  setPlaying(false);
  const k = mission.moments, i = Math.max(0, Math.min(k.length - 1, momentAt(clock) + n));
  seek(k[i].t);
}
function choose(index) {
  const n = data.missions.length;
  mission = data.missions[(index + n) % n];
  clock = 0; shownMoment = -1;
  slider.max = mission.seconds;
  [...el('pick').children].forEach((b, i) => b.setAttribute('aria-pressed', data.missions[i] === mission));
  el('outcome').textContent = 'Mission ' + mission.n + ': ' + mission.outcome + '.';
  drawStrip(); render();
}
function refresh() { readInks(); fit(); drawStrip(); render(); }

data.missions.forEach((m, i) => {
  const b = document.createElement('button');
  b.textContent = m.n;
  b.title = 'mission ' + m.n + ': ' + m.outcome;
  b.className = m.first ? 'first' : m.won ? 'won' : 'lost';
  b.addEventListener('click', () => { setPlaying(false); choose(i); });
  el('pick').append(b);
});
playButton.addEventListener('click', () => setPlaying(!playing));
slider.addEventListener('input', () => { setPlaying(false); seek(Number(slider.value)); });
for (const name of Object.keys(show)) {
  el('show-' + name).addEventListener('change', e => { show[name] = e.target.checked; render(); });
}
document.addEventListener('keydown', e => {
  if (e.ctrlKey || e.metaKey || e.altKey || /SELECT|TEXTAREA/.test(e.target.tagName)) return;
  if (e.key === ' ' && /BUTTON|INPUT/.test(e.target.tagName) && e.target !== slider) return;
  const keys = {' ': () => setPlaying(!playing), 'ArrowRight': () => stepBy(e.shiftKey ? 10 : 1),
    'ArrowLeft': () => stepBy(e.shiftKey ? -10 : -1), 'Home': () => { setPlaying(false); seek(0); },
    'End': () => { setPlaying(false); seek(mission.seconds); },
    'n': () => choose(data.missions.indexOf(mission) + 1), 'p': () => choose(data.missions.indexOf(mission) - 1)};
  if (!keys[e.key]) return;
  e.preventDefault();
  keys[e.key]();
});
window.addEventListener('resize', refresh);
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', refresh);
readInks(); fit();
const wanted = /^#mission-(\d+)(?:@([\d.]+))?$/.exec(location.hash);
choose(wanted ? Math.max(0, data.missions.findIndex(m => m.n === Number(wanted[1]))) : 0);
if (wanted && wanted[2]) seek(Number(wanted[2]));

// With "#selftest" the page tries itself out as a person would and says what it found.
async function selftest() {
  const out = document.createElement('pre'), failed = [];
  const check = (what, good) => { if (!good) failed.push(what); out.textContent += (good ? 'ok   ' : 'FAIL ') + what + '\n'; };
  const wait = ms => new Promise(done => setTimeout(done, ms));
  const until = async good => { for (let i = 0; i < 200 && !good(); ++i) await wait(20); };
  const key = (name, more) => document.body.dispatchEvent(new KeyboardEvent('keydown', {key: name, bubbles: true, ...more}));
  const picture = () => canvas.toDataURL().length + ':' + clock;
  const colours = () => {
    const d = pen.getImageData(0, 0, canvas.width, canvas.height).data, seen = new Set();
    for (let i = 0; i < d.length; i += 4 * 37) seen.add(d[i] << 16 | d[i + 1] << 8 | d[i + 2]);
    return seen.size;
  };
  check('missions to play', data.missions.length > 0 && data.missions.every(m => m.moments.length > 1 && m.seconds > 0));
  check('the arena is drawn', colours() > 8);
  check('at rest at first', !playing && clock === 0);
  playButton.click();
  const before = picture();
  await until(() => clock > 0.1);
  check('play advances', playing && clock > 0.1 && picture() !== before);
  playButton.click();
  const paused = clock;
  await wait(300);
  check('pause holds', !playing && clock === paused && paused > 0);
  slider.value = mission.seconds / 2; slider.dispatchEvent(new Event('input'));
  check('scrubbing moves', Math.abs(clock - mission.seconds / 2) < 0.2 && !playing);
  slider.value = slider.max; slider.dispatchEvent(new Event('input'));
  check('the end says how it went', el('doing').textContent.startsWith('over: ') && momentAt(clock) === mission.moments.length - 1);
  key('Home'); check('Home goes to the start', clock === 0);
  key('ArrowRight'); check('an arrow key steps', momentAt(clock) === 1);
  key('End'); check('End goes to the end', clock === mission.seconds);
  key('Home'); key(' '); await until(() => clock > 0);
  check('the space key plays', playing && clock > 0);
  key(' '); check('... and pauses', !playing);
  el('pick').lastChild.click();
  check('another mission can be picked', mission === data.missions[data.missions.length - 1] && clock === 0);
  key('n'); check('... also by key', mission === data.missions[0]);
  const learnt = mission.moments.findIndex(m => m.terms.length > 0);
  if (learnt >= 0) { seek(mission.moments[learnt].t); check('action values are shown', el('worth').children.length > 1);
    check('... and where actions lead', mission.moments.some((m, i) => { showPanel(i); return /mostly to \d+, .* to go/.test(el('worth').textContent); })); }
  const full = picture().split(':')[0];
  el('show-camera').click(); el('show-sonars').click();
  check('sensors can be hidden', picture().split(':')[0] !== full);
  el('show-camera').click(); el('show-sonars').click();
  for (const m of data.missions) { for (let i = 0; i < m.moments.length; i += 7) { mission = m; draw(m, i, 0.5); showPanel(i); } }
  choose(0);
  check('no errors: ' + errors.join('; '), errors.length === 0);
  out.id = 'selftest';
  out.textContent += failed.length ? 'SELFTEST FAILED\n' : 'SELFTEST PASSED\n';
  document.querySelector('main').prepend(out);
}
if (location.hash === '#selftest') selftest().catch(e => {
  const out = document.createElement('pre');
  out.id = 'selftest'; out.textContent = 'SELFTEST FAILED\n' + e;
  document.querySelector('main').prepend(out);
});
)js";
}

}  // namespace sspql::report
