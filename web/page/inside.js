// What a pressed particle looks like inside: sections of presses of the pool, zones.gz (web/zones.mjs).
import { element } from './chart.js';

/// As in zones.svg of the program: their lightness differs too.
export const zones = [['elastic', '#3b6fb5'], ['shear', '#f6c945'], ['compaction', '#b5283b'], ['tension', '#7cc07a']];
const shown = [2, 1, 3, 0];
const reach = 1.55, thickness = 0.05; // of R0

const percent = (x) => (x > 0 && x < 1 ? 'less than 1 %' : `${Math.round(x)} %`);

export class Inside {
  /// host: an element for the section; words: one for what it shows; keys: a list of zones and their shares.
  constructor({ host, words, keys }) {
    Object.assign(this, { words, keys });
    this.svg = element('svg', { role: 'img', 'aria-label': 'Section through a pressed particle' });
    host.append(this.svg);
    keys.innerHTML = shown.map((zone) => `<li><svg width="16" height="16" aria-hidden="true"><rect width="16" height="16" rx="2" fill="${zones[zone][1]}"/></svg> ${zones[zone][0]} <span></span></li>`).join('');
  }

  async load() {
    const response = await fetch('zones.gz');
    if (!response.ok) throw new Error('zones.gz');
    this.data = await new Response(response.body.pipeThrough(new DecompressionStream('gzip'))).json();
    const { unit } = this.data, wide = reach * unit, high = (1 + thickness) * unit;
    this.svg.setAttribute('viewBox', `${-wide} ${-high} ${2 * wide} ${2 * high}`);
  }
  get runs() { return Object.keys(this.data.pressed); }

  /// The run { run, words, apart } that is nearest to the material, at the overlap delta/R0.
  show(near, delta, unloads) {
    const moments = this.data.pressed[near.run];
    const moment = moments.reduce((best, one) => (Math.abs(one[0] - delta) < Math.abs(best[0] - delta) ? one : best));
    const [at, shares, paths] = moment;
    const key = `${near.run} ${at}`;
    if (key !== this.drawn) this.#draw(at, paths), this.drawn = key;
    shown.forEach((zone, i) => { this.keys.children[i].lastChild.textContent = percent(shares[zone]); });
    const [name, numbers] = near.words.split(': ');
    const far = near.apart < 0.0005 ? 'whose force is that of yours' : `whose force differs from that of yours by ${Number((100 * near.apart).toPrecision(2))} %`;
    const text = `${name}, ${far}, pressed to δ/R = ${at}: the nearest of ${this.runs.length} pressed materials that have a picture${numbers ? ` (${numbers})` : ''}. ` +
      (unloads ? 'The contact unloads; this is how it flowed at its largest overlap. ' : '') +
      `Shares are of its volume. ${this.data.elements.toLocaleString('en')} elements: edges are rough.`;
    if (this.words.textContent !== text) this.words.textContent = text; // said once
    this.svg.setAttribute('aria-label', `Section through ${name} pressed to δ/R = ${at}: ${shown.map((zone) => `${zones[zone][0]} ${percent(shares[zone])}`).join(', ')} of its volume`);
  }

  #draw(at, paths) {
    const { unit } = this.data, face = (1 - at) * unit, wide = reach * unit;
    // The first path is the whole, under the others; their edges close what lies between two.
    const quarter = paths.map((path, i) => { const [, colour] = zones[path[0]]; return `<path d="${path.slice(1)}" fill="${colour}"${i ? ` stroke="${colour}" stroke-width="4"` : ''}/>`; }).join('');
    const quarters = [[1, 1], [-1, 1], [1, -1], [-1, -1]].map(([x, y]) => `<g transform="scale(${x} ${y})">${quarter}</g>`).join('');
    const plane = (y) => `<rect x="${-wide}" y="${y}" width="${2 * wide}" height="${thickness * unit}" fill="var(--axis)"/>`;
    this.svg.innerHTML = quarters + plane(-face - thickness * unit) + plane(face);
  }
}
