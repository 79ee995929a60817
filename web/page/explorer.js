// The page: sliders to the worker, its numbers to the pictures.

import { Chart, element, exported, roundedUp } from './chart.js';
import { Inside } from './inside.js';
import { fromLink, initial, toLink } from './link.js';
import { allOf, answered, cardOf, fromCard, lines, modelOf, models, particle, positionOf, questions, starting, valueAt } from './materials.js';
import { typed, words } from './quantity.js';

const $ = (id) => document.getElementById(id);
const largestFile = 20e6;

let state = initial();
let cards = [];
let last = null; // the worker's last answer
let measured = null; // { name, points: [delta, force, …] }
const colour = (name) => `var(--${name})`;

function say(sentence) {
  $('sentence').textContent = sentence ?? '';
  $('sentence').hidden = !sentence;
}

// --- the worker: one question at a time, of those that wait the newest of each kind -------------------------------------------

let worker = null, busy = null, serial = 0;
const waiting = new Map();

function ask(kind, data, then) {
  waiting.set(kind, { kind, data, then });
  next();
}
function next() {
  if (busy || !worker || waiting.size === 0) return;
  const [kind, question] = waiting.entries().next().value;
  waiting.delete(kind);
  busy = { ...question, id: ++serial };
  worker.postMessage({ id: serial, kind, ...question.data });
}

function startWorker() {
  if (typeof WebAssembly !== 'object' || typeof Worker !== 'function' || typeof DecompressionStream !== 'function') {
    broken('This page computes with WebAssembly, which this browser does not have or has switched off. The command platen predict gives the same laws.');
    return;
  }
  worker = new Worker('worker.js');
  worker.onerror = () => broken('The part of this page that computes could not be started. The command platen predict gives the same laws.');
  worker.onmessage = ({ data }) => {
    if (data.broken) return broken(`The part of this page that computes could not be started (${data.broken}).`);
    if (data.cards) return begin(data.cards);
    if (data.ready) { document.documentElement.dataset.ready = ''; return; }
    const { then } = busy;
    busy = null;
    then(data);
    next();
  };
}
function broken(sentence) {
  say(sentence);
  $('verdict-word').textContent = 'No computation';
  document.documentElement.dataset.broken = '';
}

// --- the state as the worker reads it --------------------------------------------------------------------------------------------

const materialText = () => [`name=${state.name}`, `model=${cardOf(state.model)}`, ...lines(state.model, state.values)].join('\n');
const curvesText = () => `radius_m=${state.radius_m}\ndensity=${state.density}\nagainst=${state.against}\nbeside=${state.beside.join(',')}`;

function changed({ byHand = true } = {}) {
  if (byHand) $('note').textContent = '';
  ask('update', { material: materialText(), curves: curvesText(), top: state.top, at: state.at }, (answer) => {
    draw(answer);
    if (!marked) marked = performance.mark('first curve');
    later();
  });
}
let marked = null;

let laterTimer = 0;
function later() {
  clearTimeout(laterTimer);
  laterTimer = setTimeout(() => { verdict(); lookInside(); history.replaceState(null, '', toLink(state)); }, 250);
}

// --- sliders -----------------------------------------------------------------------------------------------------------------------

const fields = new Map(); // key → { p, slider, text, error }

function field(p, host, get, set) {
  const box = element_('div', 'field', host);
  const id = `f-${p.key}`;
  box.innerHTML = `<label for="${id}"><span class="symbol">${subscripts(p.symbol)}</span> ${p.name}</label>
    <input type="range" id="${id}-slider" min="0" max="1000" step="1" aria-label="${p.name}, slider">
    <input type="text" id="${id}" inputmode="text" autocomplete="off" spellcheck="false" aria-describedby="${id}-error">
    <p class="error" id="${id}-error" role="alert"></p>`;
  const [slider, text] = [box.querySelector('[type=range]'), box.querySelector('[type=text]')];
  const error = box.querySelector('.error');
  const show = () => {
    const value = get();
    slider.value = positionOf(p, value);
    slider.setAttribute('aria-valuetext', words(value, p.unit, 4));
    if (document.activeElement !== text) text.value = words(value, p.unit, 6);
    error.textContent = '';
    text.removeAttribute('aria-invalid');
  };
  slider.addEventListener('input', () => {
    set(valueAt(p, Number(slider.value)));
    text.value = words(get(), p.unit, 6);
    slider.setAttribute('aria-valuetext', text.value);
    error.textContent = '';
    text.removeAttribute('aria-invalid');
    changed();
  });
  const read = () => {
    try {
      const value = typed(text.value, p.unit);
      if (!(value >= p.low && value <= p.high))
        throw new Error(`${p.name} must be from ${words(p.low, p.unit, 3)} to ${words(p.high, p.unit, 3)}.`);
      error.textContent = '';
      text.removeAttribute('aria-invalid');
      if (value === get() || words(get(), p.unit, 6) === text.value) return true;
      set(value);
      slider.value = positionOf(p, value);
      slider.setAttribute('aria-valuetext', words(value, p.unit, 4));
      changed();
      return true;
    } catch (problem) {
      error.textContent = problem.message;
      text.setAttribute('aria-invalid', 'true');
      return false;
    }
  };
  text.addEventListener('change', read);
  text.addEventListener('keydown', (event) => { if (event.key === 'Enter') read(); });
  text.addEventListener('blur', () => { if (!text.hasAttribute('aria-invalid')) text.value = words(get(), p.unit, 6); });
  fields.set(p.key, { show });
  show();
}
function element_(name, className, host) {
  const e = document.createElement(name);
  e.className = className;
  host.append(e);
  return e;
}
const subscripts = (symbol) => symbol.replace(/_(\w+)/g, '<sub>$1</sub>');

function build() {
  for (const p of particle) field(p, $('particle'), () => state[p.key], (v) => { state[p.key] = v; });
  for (const [key, model] of Object.entries(models)) {
    const label = element_('label', '', $('models'));
    label.innerHTML = `<input type="radio" name="model" value="${key}"> <span>${model.title}<small>${model.says}</small></span>`;
    label.firstChild.addEventListener('change', () => {
      state.model = key;
      state.name = 'my material';
      state.values = starting(allOf(key));
      state.beside = [...model.beside];
      buildMaterial();
      changed();
    });
  }
  for (const input of document.querySelectorAll('[name=against]'))
    input.addEventListener('change', () => { state.against = input.value; changed(); });
  $('card').addEventListener('change', () => {
    const card = cards.find((one) => one.id === $('card').value);
    if (card) useCard(card);
  });
}

function buildMaterial() {
  for (const p of Object.keys(models).flatMap(allOf)) fields.delete(p.key);
  $('sliders').textContent = $('more-sliders').textContent = '';
  const model = models[state.model];
  const get = (p) => () => state.values[p.key];
  const set = (p) => (value) => { state.values[p.key] = value; ownNow(); };
  for (const p of model.parameters) field(p, $('sliders'), get(p), set(p));
  for (const p of model.more ?? []) field(p, $('more-sliders'), get(p), set(p));
  $('more').hidden = !model.more;
  for (const input of document.querySelectorAll('[name=model]')) input.checked = input.value === state.model;
  $('card').value = cards.find((card) => card.name === state.name)?.id ?? '';
}
function ownNow() {
  if (!$('card').value && state.name === 'my material') return;
  $('card').value = '';
  state.name = 'my material';
}
function showAll() {
  for (const { show } of fields.values()) show();
  for (const input of document.querySelectorAll('[name=against]')) input.checked = input.value === state.against;
}
function useCard(card) {
  state.model = card.model;
  state.values = fromCard(card);
  state.name = card.name;
  state.beside = state.beside.some((law) => models[card.model].beside.includes(law)) ? state.beside : [...models[card.model].beside];
  buildMaterial();
  $('note').textContent = card.source ? `From: ${card.source}.` : '';
  changed({ byHand: false });
}

// --- three questions -----------------------------------------------------------------------------------------------------------------

function buildQuestions() {
  const given = {};
  for (const question of questions) {
    const set = document.createElement('fieldset');
    set.innerHTML = `<legend>${question.text}</legend>`;
    for (const [value, title, says] of question.answers) {
      const button = element_('button', 'answer', set);
      button.type = 'button';
      button.setAttribute('aria-pressed', 'false');
      button.innerHTML = `${title}${says ? `<small>${says}</small>` : ''}`;
      button.addEventListener('click', () => {
        for (const other of set.querySelectorAll('button')) other.setAttribute('aria-pressed', String(other === button));
        given[question.key] = value;
        if (questions.every((q) => q.key in given)) {
          const start = answered(given, cards);
          Object.assign(state, { model: start.model, values: start.values, radius_m: start.radius_m, density: start.density,
            name: start.note.includes('times') ? 'my material' : start.name, beside: [...models[start.model].beside] });
          buildMaterial();
          showAll();
          closeQuestions();
          $('note').textContent = start.note;
          changed({ byHand: false });
        }
      });
    }
    $('question-list').append(set);
  }
}
function openQuestions() {
  $('question-list').textContent = '';
  buildQuestions();
  $('questions').hidden = false;
}
function closeQuestions() {
  const had = $('questions').contains(document.activeElement);
  $('questions').hidden = true;
  try { localStorage.setItem('platen-asked', '1'); } catch { /* private windows */ }
  if (had) $('picture').focus({ preventScroll: true });
}

// --- pictures ------------------------------------------------------------------------------------------------------------------------

const overlap = { title: 'overlap  γ', unit: 'm' };
const force = new Chart($('force'), { role: 'group', x: overlap, y: { title: 'force  F', unit: 'N' }, height: 430, right: 130, label: 'Force over overlap: loading, unloading loops, error band, other laws' });
const radius = new Chart($('radius'), { x: overlap, y: { title: 'contact radius  a', unit: 'm' }, height: 230, label: 'Contact radius over overlap' });
const pressure = new Chart($('pressure'), { x: overlap, y: { title: 'mean pressure  p', unit: 'Pa' }, height: 230, label: 'Mean pressure over overlap' });
const restitution = new Chart($('restitution'), { x: { title: 'velocity  v', unit: 'm/s', log: true }, y: { title: 'restitution  e', unit: '' }, height: 230, label: 'Coefficient of restitution over velocity' });

const dashes = { hertz: '7 4', similarity: '2 4', 'edmans-sinka': '9 3 2 3', 'jackson-green': '5 3', mdr: '12 4', wang: '10 3', agarwal: '3 3', 'thornton-ning': '8 3 3 3', 'kogut-etsion': '1 4' };

// The contact that is dragged: a dot that is a slider to the keyboard.
const trace = element('path', { fill: 'none', stroke: colour('contact'), 'stroke-width': 2.2, 'stroke-linecap': 'round', 'stroke-linejoin': 'round' }, force.marks);
const dot = element('g', { tabindex: 0, role: 'slider', 'aria-label': 'Overlap of the contact', 'aria-valuemin': 0, 'aria-valuemax': 100, class: 'dot' }, force.svg);
element('circle', { r: 22, fill: 'transparent', class: 'screen' }, dot);
element('circle', { r: 12, class: 'halo screen' }, dot);
element('circle', { r: 6.5, fill: colour('paper'), stroke: colour('contact'), 'stroke-width': 3 }, dot);

function fitWidths() {
  let different = false;
  for (const chart of [force, radius, pressure, restitution]) {
    const width = Math.max(240, Math.floor(chart.host.clientWidth));
    if (chart === force) chart.right = width < 560 ? 14 : 130, chart.height = width < 560 ? 330 : 430;
    different = chart.resize(width) || different;
  }
  return different;
}

function draw(answer) {
  if (answer.sentence) {
    document.documentElement.dataset.revision = String(1 + Number(document.documentElement.dataset.revision ?? 0));
    last = { sentence: answer.sentence };
    $('answer').classList.add('stale');
    for (const chart of [force, radius, pressure, restitution]) { chart.only(new Set()); chart.unlabelled(); }
    trace.setAttribute('d', '');
    dot.setAttribute('visibility', 'hidden');
    $('readout').hidden = true;
    return;
  }
  $('answer').classList.remove('stale');
  dot.removeAttribute('visibility');
  $('readout').hidden = false;
  last = answer;
  const { curves: c, numbers: n } = answer;
  if (!force.width) fitWidths();
  const N = c.points, at = (i, k) => n[5 * i + k];
  const band = 5 * N, loops = band + 3 * c.knots, rest = loops + 3 * c.loops * c.of_loop, beside = rest + 2 * c.restitution;
  const top = { F: 0, a: 0, p: 0 };
  for (let i = 0; i < N; ++i) top.F = Math.max(top.F, at(i, 1)), top.a = Math.max(top.a, at(i, 2)), top.p = Math.max(top.p, at(i, 3));
  for (let k = 0; k < c.knots; ++k) top.F = Math.max(top.F, n[band + 3 * k + 2]);
  const names = new Set(['band', 'loading', 'measured']);
  force.range(0, c.end_m * 1.02, roundedUp(top.F * 1.02));
  radius.range(0, c.end_m * 1.02, roundedUp(top.a * 1.02));
  pressure.range(0, c.end_m * 1.02, roundedUp(top.p * 1.02));
  let d = c.knots ? '' : 'M0 0'; // rock has no band
  for (let k = 0; k < c.knots; ++k) d += (k ? 'L' : 'M') + force.px(n[band + 3 * k]).toFixed(1) + ' ' + force.py(n[band + 3 * k + 2]).toFixed(1);
  for (let k = c.knots; k-- > 0;) d += 'L' + force.px(n[band + 3 * k]).toFixed(1) + ' ' + force.py(n[band + 3 * k + 1]).toFixed(1);
  force.path('band', { fill: colour('band'), 'fill-opacity': 0.2 }, d + 'Z');
  for (let l = 0; l < c.loops; ++l) {
    const o = loops + 3 * l * c.of_loop;
    const gray = { stroke: colour('unloading'), 'stroke-width': 1.6 };
    force.line(`loop${l}`, gray, { count: c.of_loop, x: (i) => n[o + 3 * i], y: (i) => n[o + 3 * i + 1] });
    radius.line(`loop${l}`, gray, { count: c.of_loop, x: (i) => n[o + 3 * i], y: (i) => n[o + 3 * i + 2] });
    names.add(`loop${l}`);
  }
  const labels = [];
  let block = beside;
  c.laws.forEach((one) => {
    if (one.missing) return;
    const o = block, look = { stroke: colour(one.law), 'stroke-width': 1.8, 'stroke-dasharray': dashes[one.law] ?? '' };
    block += 2 * N;
    force.line(`law ${one.law}`, look, { count: N, x: (i) => at(i, 0), y: (i) => n[o + 2 * i], keep: (i) => n[o + 2 * i + 1] });
    force.line(`out ${one.law}`, { ...look, 'stroke-width': 1.1, opacity: 0.55 }, { count: N, x: (i) => at(i, 0), y: (i) => n[o + 2 * i], keep: (i) => !n[o + 2 * i + 1] || (i + 1 < N && !n[o + 2 * i + 3]) });
    names.add(`law ${one.law}`).add(`out ${one.law}`);
    labels.push({ text: one.law, y: n[o + 2 * N - 2], colour: colour(one.law), dash: dashes[one.law] });
  });
  const line = { stroke: colour('press'), 'stroke-width': 2.8 };
  force.line('loading', line, { count: N, x: (i) => at(i, 0), y: (i) => at(i, 1) });
  radius.line('loading', line, { count: N, x: (i) => at(i, 0), y: (i) => at(i, 2) });
  pressure.line('loading', line, { count: N, x: (i) => at(i, 0), y: (i) => (i ? at(i, 3) : NaN) });
  labels.push({ text: 'predicted', y: at(N - 1, 1), colour: colour('press'), width: 3, strong: true });
  const vHigh = roundedUp(n[rest + 2 * c.restitution - 2]), vLow = Math.min(Math.max(n[rest], vHigh * 1e-5), vHigh / 10);
  restitution.range(vLow, vHigh, 1.05);
  restitution.line('loading', line, { count: c.restitution, x: (i) => (n[rest + 2 * i] >= vLow ? n[rest + 2 * i] : NaN), y: (i) => n[rest + 2 * i + 1] });
  if (measured) {
    const per = state.against === 'plane' ? 1 : 2; // delta of one side
    let dots = '';
    for (let i = 0; i < measured.points.length; i += 2) {
      const x = measured.points[i] * per;
      if (x <= c.end_m) dots += `M${force.px(x).toFixed(1)} ${force.py(measured.points[i + 1]).toFixed(1)}h0`;
    }
    force.path('measured', { stroke: colour('measured'), 'stroke-width': 4.5 }, dots);
    labels.push({ text: 'measured', y: measured.points.at(-1), colour: colour('measured'), dash: '1 4', width: 4 });
  } else names.delete('measured');
  force.only(names);
  radius.only(names);
  if (force.right > 100) force.beside(labels); else force.unlabelled();
  force.marks.append(trace);
  contact(answer.contact, true);
  document.documentElement.dataset.revision = String(1 + Number(document.documentElement.dataset.revision ?? 0));
}

const branches = ['separated', 'loading', 'unloading', 'reloading'];
let visited = [];

/// The contact's numbers: overlap, F, a, p, stiffness, branch, lost work, largest overlap.
function contact(numbers, anew) {
  const [gamma, F, a, p, k, branch, lost, most] = numbers;
  const end = last.curves.end_m;
  state.at = gamma / end;
  state.top = most / end;
  if (anew) { // along the loading curve to the largest overlap, and from there
    const n = last.numbers;
    visited = [[0, 0]];
    for (let i = 1; i < last.curves.points && n[5 * i] < most; ++i) visited.push([n[5 * i], n[5 * i + 1]]);
    for (let i = 0; i < (last.way?.length ?? 0); i += 2) visited.push([last.way[i], last.way[i + 1]]);
    last.way = null;
  }
  visited.push([gamma, F]);
  if (visited.length > 3000) visited.splice(0, 1000);
  let d = '';
  visited.forEach(([x, y], i) => { d += (i ? 'L' : 'M') + force.px(x).toFixed(1) + ' ' + Math.max(-4000, force.py(y)).toFixed(1); });
  trace.setAttribute('d', d);
  dot.setAttribute('transform', `translate(${force.px(gamma).toFixed(1)} ${force.py(F).toFixed(1)})`);
  dot.setAttribute('aria-valuenow', (100 * state.at).toFixed(1));
  dot.setAttribute('aria-valuetext', `overlap ${words(gamma, 'm', 3)}, force ${words(F, 'N', 3)}, ${branches[branch]}`);
  const apart = branch === 0; // the law's numbers fade out there, below any that mean something
  const rows = [['overlap', words(gamma, 'm', 6, true)], ['force', words(F, 'N', 6, true)], ['contact radius', words(apart ? 0 : a, 'm', 6, true)],
    ['mean pressure', words(p, 'Pa', 6, true)], ['stiffness', words(apart ? 0 : k, 'N/m', 6, true)], ['lost work', words(Math.max(0, lost), 'J', 6, true)], ['branch', branches[branch]]];
  if ($('readout').children.length !== rows.length)
    $('readout').innerHTML = rows.map(([name]) => `<div><dt>${name}</dt><dd data-of="${name}"></dd></div>`).join('');
  rows.forEach(([, value], i) => { const dd = $('readout').children[i].lastChild; if (dd.textContent !== value) dd.textContent = value; });
}

// --- inside ---------------------------------------------------------------------------------------------------------------------------

const inside = new Inside({ host: $('section'), words: $('inside-words'), keys: $('zones') });
let near = null; // the pressed material that is shown, and of which material it is the nearest

/// Asks for the nearest pressed material where it may be another one, and shows it.
function lookInside() {
  if (!$('inside').open || !inside.data || !last) return;
  const of = last.sentence ?? materialText();
  if (near?.of === of) return showInside();
  ask('near', { runs: inside.runs.join('\n') }, (answer) => { near = { of, ...answer }; showInside(); });
}
function showInside() {
  const none = near?.sentence ?? last?.sentence;
  $('inside-shown').hidden = Boolean(none);
  if (none) setText('inside-words', state.model === 'rock' ? 'Grains of rock were pressed at their contact alone, so there is no picture of the whole. platen derive material.toml --radius_m R -o out draws the zones of yours.' : 'There is no pressed material near this one.');
  else inside.show(near.near, state.top * last.prediction.end, state.at < state.top - 1e-9);
}
$('inside').addEventListener('toggle', async () => {
  if (!$('inside').open) return;
  try {
    if (!inside.data) {
      $('inside-words').textContent = 'Loading pictures …';
      await (inside.loading ??= inside.load());
    }
    lookInside();
  } catch {
    inside.loading = null;
    $('inside-words').textContent = 'The pictures could not be loaded. Close this and open it again to try once more.';
  }
});

function moveTo(overlap) {
  if (!last?.curves) return;
  const to = Math.min(last.curves.end_m, Math.max(0, overlap));
  ask('step', { overlap: to }, (answer) => { contact(answer.contact, false); if (near?.near && $('inside').open) showInside(); later(); });
}

let dragging = null;
force.svg.addEventListener('pointerdown', (event) => {
  if (!last?.curves || event.button !== 0) return;
  if (event.pointerType !== 'mouse' && !dot.contains(event.target)) return; // a finger elsewhere scrolls
  dragging = event.pointerId;
  force.svg.setPointerCapture(dragging);
  dot.focus({ preventScroll: true });
  event.preventDefault();
  follow(event);
});
const follow = (event) => moveTo(force.overlapAt(event.clientX - force.svg.getBoundingClientRect().left));
force.svg.addEventListener('pointermove', (event) => { if (event.pointerId === dragging) follow(event); });
for (const end of ['pointerup', 'pointercancel']) force.svg.addEventListener(end, (event) => { if (event.pointerId === dragging) dragging = null; });
dot.addEventListener('keydown', (event) => {
  const steps = { ArrowRight: 0.01, ArrowUp: 0.01, ArrowLeft: -0.01, ArrowDown: -0.01, PageUp: 0.1, PageDown: -0.1 };
  const end = last?.curves?.end_m;
  if (!end) return;
  if (event.key in steps) moveTo((state.at + steps[event.key] * (event.shiftKey ? 0.2 : 1)) * end);
  else if (event.key === 'Home') moveTo(0);
  else if (event.key === 'End') moveTo(end);
  else return;
  event.preventDefault();
});
$('again').addEventListener('click', () => { state.at = state.top = 0; ask('forget', {}, (answer) => { contact(answer.contact, true); dot.focus(); later(); }); });

// --- words ----------------------------------------------------------------------------------------------------------------------------

const marks = { inside: ['●', 'Inside what was pressed'], 'near the edge': ['◐', 'Near the edge of what was pressed'], outside: ['○', 'Outside what was pressed: a guess'] };
const percent = (x) => `${Number((100 * x).toPrecision(2))} %`;

function verdict() {
  const box = $('verdict');
  if (last?.sentence) {
    box.dataset.verdict = 'outside';
    $('badge').textContent = '○';
    setText('verdict-word', 'No law');
    setText('why', sentenceOf(last.sentence));
    return;
  }
  const p = last.prediction;
  box.dataset.verdict = p.verdict;
  const [mark, title] = marks[p.verdict];
  setText('badge', mark);
  setText('verdict-word', title);
  const why = p.reasons.length ? sentenceOf(p.reasons.join('; ')) + ' ' : '';
  setText('why', why + (state.model === 'rock' ? trustInRock(p) : trust(p, why)));
  $('near').innerHTML = p.near.map((text) => { const [name, rest] = text.split(': '); return `<li><strong>${name}</strong> ${rest ?? ''}</li>`; }).join('');
  setText('origin', `Interpolated between ${p.runs} materials of pool ${p.pool}, pressed by finite elements (engine ${p.engine}, Platen ${p.version}); the law reaches to δ/R = ${Number(p.end.toPrecision(3))}.`);
  lawChips(p.laws);
}
function trust(p, why) {
  const measuredBy = p.verdict === 'inside' ? '' : ` To know better, press it: platen predict material.toml presses it on few elements, platen derive material.toml -o out on many.`;
  const expected = why.includes('expected to be') ? '' : `The curve is expected to be ${percent(p.expected)} off. `;
  return `${expected}Nine tenths of the points of such curves lie in the blue band.${measuredBy}`;
}
const trustInRock = (p) => `Grains that were left out of the pool came out ${percent(p.left_out_median)} off in force, one in twenty more than ${percent(p.left_out_p95)}; there is no band.` +
  (p.verdict === 'inside' ? '' : ' To know better, press it: platen derive material.toml --radius_m R -o out.');
function setText(id, text) { if ($(id).textContent !== text) $(id).textContent = text; }
const sentenceOf = (text) => text.charAt(0).toUpperCase() + text.slice(1) + (text.endsWith('.') ? '' : '.');

const lawNotes = { similarity: 'similarity without hardening', 'thornton-ning': 'thornton-ning with a contact pressure of at most 1.6 σ_y', 'edmans-sinka': 'edmans-sinka by the regressions of its paper, two misprints mended', wang: 'wang by the regression of its paper, Table 2' };

function lawChips(laws) {
  const key = laws.join() + '|' + state.beside.join() + '|' + last.curves.laws.map((one) => one.missing ?? '').join();
  if ($('laws').dataset.key === key) return;
  const focused = $('laws').contains(document.activeElement) ? document.activeElement.value : null;
  $('laws').dataset.key = key;
  $('laws').innerHTML = laws.map((law) => {
    const own = last.curves.laws.find((one) => one.law === law);
    const off = own?.missing ? ` title="${own.missing.replace(/"/g, "'")}"` : own?.valid ? ` title="valid: ${own.valid.replace(/"/g, "'")}"` : '';
    return `<label${off}><input type="checkbox" value="${law}"${state.beside.includes(law) ? ' checked' : ''}>
      <svg width="26" height="10" aria-hidden="true"><path d="M1 5h24" stroke="var(--${law})" stroke-width="2.4" stroke-dasharray="${dashes[law] ?? ''}"/></svg>${law}${own?.missing ? ' <small>(does not reach)</small>' : ''}</label>`;
  }).join('');
  const notes = state.beside.filter((law) => laws.includes(law)).map((law) => lawNotes[law]).filter(Boolean);
  if (state.model === 'vmdc' && state.beside.some((law) => ['similarity', 'jackson-green', 'mdr', 'agarwal'].includes(law))) notes.push('laws of metals take Γ for the yield stress');
  if (state.model === 'ludwik' && state.beside.some((law) => law !== 'hertz')) notes.push('laws of metals take the yield stress where it begins');
  setText('laws-note', ['Thin lines: beyond what a law was made for', ...notes].join('; ') + '.');
  for (const input of $('laws').querySelectorAll('input')) {
    if (input.value === focused) input.focus();
    input.addEventListener('change', () => {
      state.beside = state.beside.filter((law) => law !== input.value);
      if (input.checked) state.beside.push(input.value);
      changed({ byHand: false });
    });
  }
}

// --- a measured curve -----------------------------------------------------------------------------------------------------------------

$('csv').addEventListener('change', async () => {
  const file = $('csv').files[0];
  if (!file) return;
  const no = (sentence) => { $('measured').textContent = sentence; $('measured').dataset.bad = ''; };
  delete $('measured').dataset.bad;
  if (file.size > largestFile) {
    $('csv').value = '';
    return no(`${file.name} is ${(file.size / 1e6).toFixed(1)} MB; this page reads up to ${largestFile / 1e6} MB. The command platen fit reads it, or keep fewer rows.`);
  }
  $('measured').textContent = `Reading ${file.name} …`;
  const bytes = await file.arrayBuffer();
  $('csv').value = '';
  ask('measured', { name: file.name, bytes }, ({ sentence, found, numbers }) => {
    if (sentence) return no(sentenceOf(sentence));
    measured = { name: file.name, points: numbers };
    if (found.radius_m >= 1e-7 && found.radius_m <= 0.1) { state.radius_m = found.radius_m; fields.get('radius_m').show(); }
    $('measured').textContent = `${file.name}: ${found.points} points of loading${found.particles > 1 ? `, the first of ${found.particles} particles` : ''} (${found.read_as}${found.stages ? '; ' + found.stages : ''}). ` +
      (found.radius_m ? `Radius ${words(found.radius_m, 'm', 4)} from the file.` : 'The file says no diameter: set the radius of the particle.');
    $('fit').disabled = false;
    $('drop').hidden = false;
    changed({ byHand: false });
  });
});
$('fit').addEventListener('click', () => {
  $('fit').disabled = true;
  $('measured').textContent = 'Fitting …';
  ask('fit', { asked: materialText() + `\nradius_m=${state.radius_m}` }, ({ sentence, fitted: f }) => {
    $('fit').disabled = false;
    if (sentence) { $('measured').textContent = sentenceOf(sentence); return; }
    const own = Number(f.value.toPrecision(4)), by = own / f.was;
    if (['von-mises', 'elastic', 'rock'].includes(state.model)) state.values[f.key] = own;
    else if (state.model === 'ludwik') Object.assign(state.values, { sigma_y_Pa: own, K_Pa: Number((state.values.K_Pa * by).toPrecision(6)) });
    else { state.values.sigma_y_Pa = own; state.values.E_bar = Number((state.values.E_bar / by).toPrecision(6)); }
    ownNow();
    showAll();
    $('measured').textContent = `Strength ${words(own, 'Pa', 4)} brings the law nearest: ${percent(f.relative_l2)} off over ${f.points} points, E and ratios of strengths as they were.` +
      (f.at_end ? ' That is the end of what was tried: are radius and stiffness right?' : '');
    changed({ byHand: false });
  });
});
$('drop').addEventListener('click', () => { measured = null; $('drop').hidden = true; $('fit').disabled = true; $('measured').textContent = ''; changed({ byHand: false }); });

// --- downloads ------------------------------------------------------------------------------------------------------------------------

function save(name, blob) {
  const a = document.createElement('a');
  a.href = URL.createObjectURL(blob);
  a.download = name;
  a.click();
  setTimeout(() => URL.revokeObjectURL(a.href), 10000);
  $('taken').textContent = `${name} is in your downloads.`;
}
const slug = () => state.name.toLowerCase().replace(/[^a-z0-9]+/g, '-').replace(/^-|-$/g, '') || 'material';
const picture = () => exported([force, radius, pressure, restitution], `${state.name}, R = ${words(state.radius_m, 'm', 4)}, ${state.against === 'plane' ? 'against a rigid plane' : 'two equal spheres'}`);

for (const button of document.querySelectorAll('[data-file]'))
  button.addEventListener('click', () => {
    if (!last?.curves) { $('taken').textContent = 'There is no law to take: the material lies outside of what the page knows.'; return; }
    const file = button.dataset.file;
    if (file === 'svg') return save(`${slug()}.svg`, new Blob([picture().text], { type: 'image/svg+xml' }));
    if (file === 'png') return savePng();
    ask('file', { asked: `file=${file}\nradius_m=${state.radius_m}\ndensity=${state.density}\nagainst=${state.against}` }, ({ sentence, file: text }) => {
      if (sentence) $('taken').textContent = sentenceOf(sentence);
      else save(file === 'material.toml' || file === 'law.toml' ? `${slug()}-${file}` : file, new Blob([text], { type: 'text/plain' }));
    });
  });
function savePng() {
  const { text, width, height } = picture();
  const image = new Image();
  image.onload = () => {
    const canvas = document.createElement('canvas');
    canvas.width = 2 * width;
    canvas.height = 2 * height;
    canvas.getContext('2d').drawImage(image, 0, 0, canvas.width, canvas.height);
    canvas.toBlob((blob) => save(`${slug()}.png`, blob), 'image/png');
  };
  image.onerror = () => { $('taken').textContent = 'This browser could not make the PNG; the SVG holds the same picture.'; };
  image.src = 'data:image/svg+xml;charset=utf-8,' + encodeURIComponent(text);
}
$('share').addEventListener('click', async () => {
  const link = location.href.replace(/#.*$/, '') + toLink(state);
  history.replaceState(null, '', toLink(state));
  try {
    await navigator.clipboard.writeText(link);
    $('taken').textContent = 'The link is copied.';
  } catch {
    $('taken').textContent = 'The link stands in the address bar.';
  }
});

// --- beginning ------------------------------------------------------------------------------------------------------------------------

function readLink() {
  try {
    state = fromLink(location.hash);
    return true;
  } catch (problem) {
    say(problem.message);
    return false;
  }
}

function begin(list) {
  cards = list.map((card) => ({ ...card, model: modelOf(card) }));
  $('card').innerHTML = '<option value="">own numbers</option>' + cards.map((card) => `<option value="${card.id}">${card.name}</option>`).join('');
  buildMaterial();
  showAll();
  changed();
}

$('skip').addEventListener('click', closeQuestions);
$('ask').addEventListener('click', () => { openQuestions(); $('questions').querySelector('button').focus(); });
$('theme').addEventListener('click', () => theme(document.documentElement.dataset.theme !== 'dark'));
function theme(dark) {
  document.documentElement.dataset.theme = dark ? 'dark' : 'light';
  $('theme').setAttribute('aria-pressed', String(dark));
}
theme(matchMedia('(prefers-color-scheme: dark)').matches);
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', (event) => theme(event.matches));

const linked = location.hash.length > 1 && readLink();
let before = false;
try { before = localStorage.getItem('platen-asked') !== null; } catch { /* private windows */ }
build();
buildMaterial();
showAll();
startWorker();
if (!linked && !before && worker) openQuestions();
addEventListener('hashchange', () => { if (readLink()) { say(''); buildMaterial(); showAll(); changed(); } });
new ResizeObserver(() => { if (last?.curves && fitWidths()) draw(last); }).observe($('answer'));
if ('serviceWorker' in navigator) navigator.serviceWorker.register('service-worker.js').catch(() => {});
