// Pictures in SVG: axes with units, lines, areas, labels beside their lines. Colours are var(--name); a picture that
// leaves the page gets those of the light theme (exported).

import { unitFor } from './quantity.js';

const ns = 'http://www.w3.org/2000/svg';
export function element(name, attributes = {}, parent = null) {
  const e = document.createElementNS(ns, name);
  for (const [key, value] of Object.entries(attributes)) e.setAttribute(key, value);
  parent?.append(e);
  return e;
}

/// Round numbers from 0 (or between two powers of ten) to the end, about `count` of them.
function ticksTo(end, count) {
  const rough = end / count, power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((m) => m * power).find((s) => s >= rough * 0.999) ?? 10 * power;
  const list = [];
  for (let i = 0; i * step <= end * (1 + 1e-9); ++i) list.push(Number((i * step).toPrecision(12)));
  return list;
}
function decades(low, high) {
  const list = [];
  for (let k = Math.ceil(Math.log10(low)); 10 ** k <= high * 1.0001; ++k) list.push(10 ** k);
  return list;
}
const superscript = (k) => String(k).replace(/./g, (c) => '⁰¹²³⁴⁵⁶⁷⁸⁹'[c] ?? '⁻');

/// The next of steps of an eighth or so: an end that stays while a curve moves a little.
export function roundedUp(end) {
  const power = 10 ** Math.floor(Math.log10(end));
  return power * [1, 1.1, 1.25, 1.4, 1.6, 1.8, 2, 2.25, 2.5, 2.8, 3.2, 3.6, 4, 4.5, 5, 5.6, 6.3, 7, 8, 9, 10].find((step) => step * power >= end * (1 - 1e-9));
}

export class Chart {
  /// x, y: { title, unit, log }; right: room for labels.
  constructor(host, { x, y, height, right = 12, label, role = 'img' }) {
    Object.assign(this, { x, y, height, right, host });
    this.width = 0;
    this.svg = element('svg', { role, 'aria-label': label, 'font-family': 'Helvetica, Arial, sans-serif', 'font-size': 12 });
    this.label = label;
    host.append(this.svg);
    const id = `clip-${Chart.count = (Chart.count ?? 0) + 1}`;
    this.clip = element('rect', {}, element('clipPath', { id }, element('defs', {}, this.svg)));
    this.axes = element('g', {}, this.svg);
    this.marks = element('g', { 'clip-path': `url(#${id})` }, this.svg);
    this.labels = element('g', {}, this.svg);
    this.lines = new Map();
    this.left = 58, this.top = 12, this.bottom = 44;
  }

  resize(width) {
    if (width === this.width) return false;
    this.width = width;
    this.svg.setAttribute('viewBox', `0 0 ${width} ${this.height}`);
    this.svg.setAttribute('width', width);
    this.svg.setAttribute('height', this.height);
    this.drawn = '';
    return true;
  }

  /// In SI; what is beyond is cut off.
  range(xLow, xHigh, yHigh) {
    [this.xUnit, this.xSize] = this.x.log ? [this.x.unit, 1] : unitFor(xHigh / 2, this.x.unit);
    [this.yUnit, this.ySize] = unitFor(yHigh / 2, this.y.unit);
    Object.assign(this, { xLow, xHigh, yHigh });
    const w = this.width - this.left - this.right, h = this.height - this.top - this.bottom;
    this.kx = this.x.log ? w / Math.log(xHigh / xLow) : w / (xHigh - xLow);
    this.ky = h / yHigh;
    this.floor = this.height - this.bottom;
    this.#drawAxes(w, h);
  }
  px(x) { return this.left + (this.x.log ? Math.log(x / this.xLow) : x - this.xLow) * this.kx; }
  py(y) { return this.floor - y * this.ky; }
  overlapAt(px) { return this.xLow + (px - this.left) / this.kx; }

  #drawAxes(w, h) {
    const xs = this.x.log ? decades(this.xLow, this.xHigh) : ticksTo(this.xHigh / this.xSize, w / 75);
    const ys = ticksTo(this.yHigh / this.ySize, h / 48);
    const key = [w, h, this.xUnit, this.yUnit, xs.join(), ys.join(), this.kx.toPrecision(4), this.ky.toPrecision(4)].join('|');
    if (key === this.drawn) return;
    this.drawn = key;
    for (const [name, value] of [['x', this.left], ['y', this.top], ['width', w], ['height', h]]) this.clip.setAttribute(name, value);
    let s = '';
    const right = this.width - this.right, floor = this.floor;
    for (const t of ys) {
      const y = this.py(t * this.ySize).toFixed(1);
      s += `<path d="M${this.left} ${y}H${right}" stroke="var(--grid)"/><text x="${this.left - 7}" y="${y}" dy=".35em" text-anchor="end" fill="var(--ink)">${t}</text>`;
    }
    for (const t of xs) {
      const x = this.px(t * this.xSize).toFixed(1);
      const word = this.x.log ? (t >= 0.01 && t <= 1000 ? t : '10' + superscript(Math.log10(t))) : t;
      s += `<path d="M${x} ${this.top}V${floor}" stroke="var(--grid)"/><text x="${x}" y="${floor + 17}" text-anchor="middle" fill="var(--ink)">${word}</text>`;
    }
    s += `<path d="M${this.left} ${this.top}V${floor}H${right}" fill="none" stroke="var(--axis)"/>`;
    s += `<text x="${(this.left + right) / 2}" y="${this.height - 8}" text-anchor="middle" fill="var(--ink)">${this.x.title}${this.xUnit ? ` [${this.xUnit}]` : ''}</text>`;
    s += `<text transform="translate(14 ${(this.top + floor) / 2}) rotate(-90)" text-anchor="middle" fill="var(--ink)">${this.y.title}${this.yUnit ? ` [${this.yUnit}]` : ''}</text>`;
    this.axes.innerHTML = s;
  }

  /// A line through numbers[at + i stride], i < count; a gap where a number is none, or `keep(i)` is false.
  line(name, look, { count, x, y, keep }) {
    let d = '', pen = 'M';
    for (let i = 0; i < count; ++i) {
      const vx = x(i), vy = y(i);
      if (!(Number.isFinite(vx) && Number.isFinite(vy)) || (keep && !keep(i)) || (this.x.log && !(vx > 0))) { pen = 'M'; continue; }
      d += pen + this.px(vx).toFixed(1) + ' ' + Math.max(-4000, this.py(vy)).toFixed(1);
      pen = 'L';
    }
    this.path(name, look, d);
  }
  path(name, look, d) {
    let path = this.lines.get(name);
    if (!path) {
      path = element('path', { fill: 'none', 'stroke-linejoin': 'round', 'stroke-linecap': 'round', ...look }, this.marks);
      this.lines.set(name, path);
    }
    path.setAttribute('d', d);
  }
  /// Lines that are not among `names` go.
  only(names) {
    for (const [name, path] of this.lines) if (!names.has(name)) path.remove(), this.lines.delete(name);
  }
  /// Words beside the ends of lines: { text, y (SI), colour, dash }; kept apart.
  beside(list) {
    const x = this.width - this.right + 8, gap = 15;
    const places = list.map((one) => ({ ...one, at: Math.round(Math.max(this.top + 5, Math.min(this.floor - 4, this.py(one.y)))), above: this.py(one.y) < this.top }))
      .sort((a, b) => a.at - b.at || b.y - a.y);
    for (let i = 1; i < places.length; ++i) places[i].at = Math.max(places[i].at, places[i - 1].at + gap);
    const labels = places.map((p) =>
      `<path d="M${x} ${p.at}h14" stroke="${p.colour}" stroke-width="${p.width ?? 2}" ${p.dash ? `stroke-dasharray="${p.dash}"` : ''}/>` +
      `<text x="${x + 19}" y="${p.at}" dy=".35em" fill="var(--ink)"${p.strong ? ' font-weight="700"' : ''}>${p.text}${p.above ? ' ↑' : ''}</text>`).join('');
    if (labels !== this.labelled) this.labels.innerHTML = this.labelled = labels;
  }
  unlabelled() {
    this.labels.textContent = this.labelled = '';
  }
}

export const light = { ink: '#222b34', axis: '#5b6670', grid: '#e3e7eb', press: '#0072b2', band: '#0072b2', unloading: '#9aa8b5', contact: '#222b34',
  measured: '#222b34', paper: '#ffffff', hertz: '#5b6670', 'edmans-sinka': '#d55e00', similarity: '#b87900', 'jackson-green': '#009e73',
  mdr: '#cc79a7', wang: '#7a5fb0', agarwal: '#56b4e9', 'thornton-ning': '#7f6a3f', 'kogut-etsion': '#a0522d' };

/// Pictures one beside the other as one SVG that stands alone.
export function exported(charts, title) {
  const gap = 12, columns = [charts[0], charts.slice(1)];
  const width = charts[0].width, small = columns[1];
  const rowHeight = Math.max(0, ...small.map((c) => c.height));
  const scale = small.length ? Math.min(1, (width - gap * (small.length - 1)) / small.reduce((sum, c) => sum + c.width, 0)) : 1;
  const height = 34 + charts[0].height + (small.length ? gap + rowHeight * scale : 0);
  const place = (c, x, y, k) => {
    const copy = c.svg.cloneNode(true);
    for (const part of copy.querySelectorAll('.screen')) part.remove();
    return `<g transform="translate(${x} ${y}) scale(${k})">${new XMLSerializer().serializeToString(copy).replace(/^<svg[^>]*>|<\/svg>$/g, '')}</g>`;
  };
  let body = place(charts[0], 0, 34, 1), x = 0;
  for (const c of small) body += place(c, x, 34 + charts[0].height + gap, scale), x += c.width * scale + gap;
  const escape = (s) => s.replace(/&/g, '&amp;').replace(/</g, '&lt;');
  const text = `<svg xmlns="${ns}" width="${width}" height="${Math.ceil(height)}" viewBox="0 0 ${width} ${Math.ceil(height)}" font-family="Helvetica, Arial, sans-serif" font-size="12">` +
    `<rect width="100%" height="100%" fill="#ffffff"/><text x="16" y="22" font-size="15" font-weight="700" fill="#222b34">${escape(title)}</text>${body}</svg>`;
  return { text: text.replace(/var\(--([a-z-]+)\)/g, (_, name) => light[name] ?? '#222b34').replaceAll('&nbsp;', ' '), width, height: Math.ceil(height) };
}
