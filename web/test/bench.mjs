// What the module itself takes: node bench.mjs PAGE_FOLDER
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { gunzipSync } from 'node:zlib';
import { allOf, models, starting } from '../page/materials.js';

const folder = process.argv[2];
const system = new Proxy({}, { get: () => () => 0 });
const { instance } = await WebAssembly.instantiate(readFileSync(join(folder, 'explorer.wasm')), { wasi_snapshot_preview1: system, page: { decode: () => -1 } });
const module = instance.exports;
module._initialize();
const call = (name, text) => {
  const bytes = new TextEncoder().encode(text), at = module.buffer(bytes.length);
  new Uint8Array(module.memory.buffer, at, bytes.length).set(bytes);
  const failed = module[name]();
  const out = new TextDecoder().decode(new Uint8Array(module.memory.buffer, module.text(), module.text_size()));
  if (failed) throw new Error(out);
  return out;
};
const now = () => performance.now();
let start = now();
for (const text of JSON.parse(gunzipSync(readFileSync(join(folder, 'catalogue.gz')))).surrogates) call('load', text);
console.log(`load ${(now() - start).toFixed(1)} ms`);
const measure = (what, work, times = 100) => {
  const list = [];
  for (let i = 0; i < times; ++i) { const from = now(); work(i); list.push(now() - from); }
  list.sort((a, b) => a - b);
  console.log(`${what}: ${list[times >> 1].toFixed(2)} ms median, ${list[Math.floor(0.95 * times)].toFixed(2)} ms at 95 %`);
};
const cases = { elastic: 'elastic', metal: 'von-mises', granule: 'vmdc' };
const text = (model, i) => {
  const values = starting(allOf(model));
  values[model === 'elastic' ? 'E_Pa' : 'sigma_y_Pa'] *= 1 + 0.001 * i;
  return [`name=x`, `model=${model}`, ...Object.entries(values).map((line) => line.join('='))].join('\n');
};
for (const round of ['before', 'prepared']) {
  for (const [what, model] of Object.entries(cases)) {
    measure(`${round} ${what} predict`, (i) => call('predict', text(model, i)));
    measure(`${round} ${what} curves alone`, () => call('curves', 'radius_m=1e-3\ndensity=1500\nagainst=sphere\nbeside='));
    for (const law of models[model].beside) measure(`${round} ${what} curves, ${law}`, () => call('curves', `radius_m=1e-3\ndensity=1500\nagainst=sphere\nbeside=${law}`));
  }
  start = now();
  let parts = 1, longest = 0;
  for (let from = now(); module.prepare(); from = now()) longest = Math.max(longest, now() - from), ++parts;
  console.log(`prepare ${(now() - start).toFixed(0)} ms in ${parts} parts, longest ${longest.toFixed(1)} ms`);
}
