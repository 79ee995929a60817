// What the module itself takes, processor time: node bench.mjs PAGE_FOLDER
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { gunzipSync } from 'node:zlib';
import { allOf, cardOf, lines, models, starting } from '../page/materials.js';

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
const now = () => { const { user, system: kernel } = process.cpuUsage(); return (user + kernel) / 1000; }; // of all threads; wall time is that of the machine's other work too
let start = now();
for (const text of JSON.parse(gunzipSync(readFileSync(join(folder, 'catalogue.gz')))).surrogates) call('load', text);
console.log(`load ${(now() - start).toFixed(1)} ms`);
const measure = (what, work, times = 100) => {
  for (let i = 0; i < 20; ++i) work(i); // until it is compiled for speed
  const from = now();
  for (let i = 0; i < times; ++i) work(i);
  console.log(`${what}: ${((now() - from) / times).toFixed(2)} ms`);
};
const cases = { elastic: ['elastic', 'nu'], metal: ['von-mises', 'sigma_y_Pa'], granule: ['vmdc', 'E_bar'], rock: ['rock', 'sigma_c_Pa'] };
const text = ([model, key], i) => { // as a slider goes to and fro, 12 % to either side
  const values = starting(allOf(model));
  values[key] *= 1 + 0.006 * (((i * 7) % 40) - 20);
  return ['name=x', `model=${cardOf(model)}`, ...lines(model, values)].join('\n');
};
for (const round of ['before', 'prepared']) {
  for (const [what, kind] of Object.entries(cases)) {
    measure(`${round} ${what} predict`, (i) => call('predict', text(kind, i)));
    measure(`${round} ${what} curves alone`, () => call('curves', 'radius_m=1e-3\ndensity=1500\nagainst=sphere\nbeside='));
    for (const law of models[kind[0]].beside) measure(`${round} ${what} curves, ${law}`, () => call('curves', `radius_m=1e-3\ndensity=1500\nagainst=sphere\nbeside=${law}`));
  }
  start = now();
  let parts = 1, longest = 0;
  for (let from = now(); module.prepare(); from = now()) longest = Math.max(longest, now() - from), ++parts;
  console.log(`prepare ${(now() - start).toFixed(0)} ms in ${parts} parts, longest ${longest.toFixed(1)} ms`);
}
