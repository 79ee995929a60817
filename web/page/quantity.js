// Numbers with units, as people type them and as they are shown.

const prefixes = { Pa: ['GPa', 'MPa', 'kPa', 'Pa'], m: ['m', 'mm', 'µm', 'nm'], N: ['MN', 'kN', 'N', 'mN', 'µN', 'nN', 'pN'],
  J: ['kJ', 'J', 'mJ', 'µJ', 'nJ', 'pJ', 'fJ'], 'm/s': ['km/s', 'm/s', 'mm/s', 'µm/s'],
  'N/m': ['GN/m', 'MN/m', 'kN/m', 'N/m', 'mN/m'] };
const factor = { G: 1e9, M: 1e6, k: 1e3, '': 1, m: 1e-3, µ: 1e-6, n: 1e-9, p: 1e-12, f: 1e-15 };
const ofPrefix = (name, unit) => factor[name.slice(0, name.length - unit.length)];
const others = { Pa: { psi: 6894.757293168, ksi: 6894757.293168, bar: 1e5, 'N/mm2': 1e6, 'N/mm²': 1e6 }, m: { cm: 1e-2, inch: 0.0254, in: 0.0254 }, '°': { deg: 1, degree: 1, degrees: 1 },
  'kg/m³': { 'g/cm³': 1000, 'g/cm3': 1000, 'kg/m3': 1, 'kg/m^3': 1, 'g/cc': 1000, 'kg/l': 1000 } };

/// The unit in which a value is shown: [name, its size in SI].
export function unitFor(value, unit) {
  const list = prefixes[unit];
  if (!list) return [unit, 1];
  const size = Math.abs(value);
  for (const name of list) if (size >= ofPrefix(name, unit) * (1 - 1e-9)) return [name, ofPrefix(name, unit)];
  const last = size > 0 ? list.at(-1) : unit;
  return [last, ofPrefix(last, unit)];
}

/// 1.2e9, Pa → "1.2 GPa"; digits: significant ones, none of them cut off where `whole`.
export function words(value, unit, digits = 4, whole = false) {
  if (!Number.isFinite(value)) return '–';
  if (value === 0) return unit ? `0 ${unit}` : '0';
  const [name, size] = unitFor(value, unit);
  const cut = (value / size).toPrecision(digits);
  const number = whole ? cut : String(Number(cut));
  return (number.includes('e') ? String(Number(number)) : number) + (name ? ' ' + name : '');
}

/// What is typed, in SI: "1.2 GPa", "1,2e9", "35 um". An Error says what is wrong.
export function typed(text, unit) {
  const clean = text.trim().replace(/\u2212/g, '-').replace(/\u00d7\s*10\^?/g, 'e').replace(/μ/g, 'µ');
  const found = /^([+-]?(?:\d+[.,]?\d*|[.,]\d+)(?:e[+-]?\d+)?)\s*(.*)$/i.exec(clean);
  const example = unit ? `a number and its unit, such as ${exampleOf(unit)}` : 'a number, such as 0.3';
  if (!found) throw new Error(`“${shortened(text)}” is not ${example}.`);
  const number = Number(found[1].replace(',', '.')), name = found[2].trim();
  if (!Number.isFinite(number)) throw new Error(`“${shortened(text)}” is not ${example}.`);
  if (!name) return number;
  if (!unit) throw new Error(`“${shortened(name)}” is a unit, but this is a plain number, such as 0.3.`);
  if (name === unit) return number;
  const known = prefixes[unit] ?? [];
  const wanted = name.replace(/^u/, 'µ');
  const exact = known.find((one) => one === wanted) ?? // case matters only between m and M
    (known.filter((one) => one.toLowerCase() === wanted.toLowerCase()).length === 1 ? known.find((one) => one.toLowerCase() === wanted.toLowerCase()) : undefined);
  if (exact) return number * ofPrefix(exact, unit);
  const foreign = others[unit]?.[name];
  if (foreign) return number * foreign;
  throw new Error(`“${shortened(name)}” is no unit of this quantity; write ${exampleOf(unit)}.`);
}

const exampleOf = (unit) => ({ Pa: '1.2 GPa', m: '0.5 mm', 'kg/m³': '1500 kg/m³', '°': '30°' })[unit] ?? `1 ${unit}`;
export const shortened = (text) => (text.length > 24 ? text.slice(0, 23) + '…' : text);
