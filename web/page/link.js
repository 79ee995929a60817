// The page's state in its address: #v=1&model=…; the version is raised when keys change their meaning.

import { models, allOf, particle, starting } from './materials.js';
import { shortened } from './quantity.js';

const version = '1';

export function initial() {
  return { model: 'vmdc', name: 'Base case', values: starting(allOf('vmdc')), ...starting(particle), against: 'sphere',
    beside: [...models.vmdc.beside], top: 0.7, at: 0.7 };
}

export function toLink(s) {
  const link = new URLSearchParams({ v: version, model: s.model, name: s.name });
  for (const p of allOf(s.model)) link.set(p.key, s.values[p.key]);
  for (const p of particle) link.set(p.key, s[p.key]);
  link.set('against', s.against);
  link.set('beside', s.beside.join(','));
  link.set('top', Number(s.top.toFixed(4)));
  link.set('at', Number(s.at.toFixed(4)));
  return '#' + link.toString();
}

/// The state of a link. An Error says in a sentence why it has none.
export function fromLink(hash) {
  const link = new URLSearchParams(hash.replace(/^#/, ''));
  const broken = (why) => new Error(`This link is broken: ${why}. The page shows its usual beginning instead.`);
  if (!link.has('v')) throw broken('it does not say which version made it');
  if (link.get('v') !== version) throw new Error(`This link was made by another version of this page (${shortened(link.get('v'))}). It shows its usual beginning instead.`);
  const s = initial();
  s.model = link.get('model');
  if (!Object.hasOwn(models, s.model ?? '')) throw broken(`“${shortened(s.model ?? '')}” is no kind of material`);
  const number = (key, low, high) => {
    const text = link.get(key), value = Number(text);
    if (text === null || text.trim() === '') throw broken(`${key} is missing`);
    if (!Number.isFinite(value) || value < low || value > high) throw broken(`${key} = ${shortened(text)} is not from ${low} to ${high}`);
    return value;
  };
  s.name = (link.get('name') ?? 'my material').slice(0, 80);
  s.values = {};
  for (const p of allOf(s.model)) s.values[p.key] = number(p.key, p.low, p.high);
  for (const p of particle) s[p.key] = number(p.key, p.low, p.high);
  s.against = link.get('against') ?? 'sphere';
  if (!['sphere', 'plane'].includes(s.against)) throw broken(`against = ${shortened(s.against)} is neither sphere nor plane`);
  s.beside = (link.get('beside') ?? '').split(',').filter((name) => /^[a-z-]{1,30}$/.test(name)).slice(0, 8);
  s.top = link.has('top') ? number('top', 0, 1) : 0.7;
  s.at = link.has('at') ? number('at', 0, s.top) : s.top;
  return s;
}
