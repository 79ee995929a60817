// The state that a link carries: whatever a link says, it is refused in a sentence, or every value of the state is one
// that the page can set. Links are made here, cut, joined and changed by characters.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { fromLink, initial, toLink } from '../page/link.js';
import { allOf, models, particle, valueAt } from '../page/materials.js';

const seed = Number(process.env.SEED ?? 1 + Math.floor(Math.random() * 2147483645));
let lehmer = seed;
const random = () => (lehmer = (lehmer * 48271) % 2147483647) / 2147483647;
const below = (n) => Math.floor(n * random());
const of = (list) => list[below(list.length)];

function randomState() {
  const s = initial();
  s.model = of(Object.keys(models));
  s.name = of(['Base case', '', 'µ–σ', '<b>&"\'', 'x'.repeat(200), '\ud800', '%', '💎'.repeat(50)]);
  s.values = Object.fromEntries(allOf(s.model).map((p) => [p.key, valueAt(p, below(1001))]));
  for (const p of particle) s[p.key] = valueAt(p, below(1001));
  s.against = of(['sphere', 'plane']);
  s.beside = models[s.model].beside.filter(() => random() < 0.5);
  s.top = random(), s.at = s.top * random();
  return s;
}

const words = ['', 'NaN', 'Infinity', '-1', '0', '1e999', '1e-999', '-0', '0x10', ' ', '1,5', '__proto__', 'constructor', 'toString', 'v', 'model',
  'null', '[]', '%', '%00', '%ff', '%u0041', '&', '=', '#', '+', ';', '💎', '\ud800', '\0', '\n', 'a'.repeat(5000), '9'.repeat(400), 'hertz,'.repeat(100)];

function mutated(link) {
  const parts = link.slice(1).split('&');
  for (let n = below(4); n >= 0; --n) {
    const k = below(parts.length), [key] = (parts[k] ?? '').split('=');
    const at = below((parts[k] ?? '').length + 1);
    [() => { parts[k] = `${key}=${of(words)}`; }, () => { parts[k] = `${key}=${encodeURIComponent(String(10 ** (40 * random() - 20) * of([1, -1])))}`; },
      () => parts.splice(k, 1), () => parts.push(parts[k]), () => parts.push(`${of(words)}=${of(words)}`),
      () => { parts[k] = (parts[k] ?? '').slice(0, at) + String.fromCharCode(below(of([128, 65536]))) + (parts[k] ?? '').slice(at + below(3)); },
      () => { parts[k] = (parts[k] ?? '').slice(0, at); }][below(7)]();
  }
  return '#' + parts.join('&');
}

const noise = () => '#' + Array.from({ length: below(60) }, () => String.fromCharCode(below(of([128, 65536])))).join('');

/// What the page promises itself of a state.
function check(s, link) {
  const inside = (p, value) => assert.ok(typeof value === 'number' && value >= p.low && value <= p.high, `${p.key} = ${value} of ${link}`);
  assert.ok(Object.hasOwn(models, s.model), link);
  assert.deepEqual(Object.keys(s.values), allOf(s.model).map((p) => p.key));
  for (const p of allOf(s.model)) inside(p, s.values[p.key]);
  for (const p of particle) inside(p, s[p.key]);
  inside({ key: 'top', low: 0, high: 1 }, s.top);
  inside({ key: 'at', low: 0, high: s.top }, s.at);
  assert.ok(['sphere', 'plane'].includes(s.against), link);
  assert.ok(typeof s.name === 'string' && s.name.length <= 80, link);
  assert.ok(s.beside.length <= 8 && s.beside.every((name) => /^[a-z-]{1,30}$/.test(name)), link);
  assert.deepEqual(Object.keys(s).sort(), Object.keys(initial()).sort());
}

test('a link that was made is read back', () => {
  for (let n = 0; n < 2000; ++n) {
    const s = randomState(), back = fromLink(toLink(s));
    check(back, toLink(s));
    assert.deepEqual(back.values, s.values);
    assert.equal(toLink(back), toLink({ ...s, name: s.name.toWellFormed().slice(0, 80) }), `seed ${seed}`);
  }
});

test('100,000 links that nobody made', () => {
  let read = 0, refused = 0;
  for (let n = 0; n < 1e5; ++n) {
    const link = n % 10 === 0 ? noise() : mutated(toLink(randomState()));
    let s;
    try {
      s = fromLink(link);
    } catch (error) {
      assert.ok(error.constructor === Error && /^This link [^]*\.$/.test(error.message), `${error.stack}\nof ${JSON.stringify(link)}, seed ${seed}`);
      assert.ok(error.message.length < 250, error.message);
      ++refused;
      continue;
    }
    check(s, JSON.stringify(link));
    check(fromLink(toLink(s)), JSON.stringify(link)); // what the page then shows can be shared
    ++read;
  }
  console.log(`    seed ${seed}: ${read} read, ${refused} refused`);
  assert.ok(read > 1000 && refused > 1000);
});
