// What prediction and the three questions need of the catalogue, in one compressed file; the zones in another.
// node catalogue.mjs CATALOGUE OUT_FOLDER
import { existsSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';

const [catalogue, out] = process.argv.slice(2);
const pools = join(catalogue, 'pools');
const surrogates = readdirSync(pools).sort() // in the order in which the program asks them
  .map((pool) => join(pools, pool, 'surrogate.txt')).filter(existsSync)
  .map((file) => {
    const text = readFileSync(file, 'utf8'), guide = text.indexOf('\nguide ');
    return guide < 0 ? text : text.slice(0, guide + 1); // a page presses nothing first
  });
surrogates.push(readFileSync(join(pools, 'wang/grains.csv'), 'utf8')); // rock
const known = /^model = "(elastic|von-mises|vmdc|drucker-prager)"/m;
const cards = readdirSync(join(catalogue, 'materials')).sort()
  .map((file) => ({ id: file.replace(/\.toml$/, ''), text: readFileSync(join(catalogue, 'materials', file), 'utf8') }))
  .filter(({ text }) => known.test(text) && !/^hardening/m.test(text)).map(({ id, text }) => card(id, text));

/// These cards are flat: a key, and a number or a text.
function card(id, text) {
  const sections = { '': {} };
  let now = '';
  for (const line of text.split('\n')) {
    const head = /^\[(\w+)\]/.exec(line), entry = /^(\w+) = (?:"(.*)"|([\d.e+-]+))\s*(?:#.*)?$/.exec(line);
    if (head) sections[now = head[1]] = {};
    else if (entry) sections[now][entry[1]] = entry[2] ?? Number(entry[3]);
    else if (line.trim() && !line.startsWith('#')) throw new Error(`${id}: not understood: ${line}`);
  }
  return { id, name: sections[''].name, model: sections[''].model, parameters: sections.parameters, source: sections.source?.default };
}
const pack = (name, text) => writeFileSync(join(out, name), gzipSync(text, { level: 9 }));
pack('catalogue.gz', JSON.stringify({ surrogates, cards }));
pack('zones.gz', readFileSync(new URL('zones.json', import.meta.url)));
