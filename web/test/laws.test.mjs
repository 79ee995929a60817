// Random materials of every law on random paths, in WebAssembly: what the headers say. The C libraries round powers and
// exponentials differently, so that bits cannot be asked: 98.6 % of 42,000 laws agree to 1e-12 of the largest value, 99.99 %
// to 1e-10. Of the others a last bit decided whether a cell of their table was halved: both are within its accuracy.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { test } from 'node:test';

const folder = mkdtempSync(join(tmpdir(), 'platen-laws-'));
const wasm = await WebAssembly.instantiate(readFileSync(process.env.PLATEN_LAWS), { wasi_snapshot_preview1: new Proxy({}, { get: () => () => 8 }) });
const module = wasm.instance.exports;
module._initialize();

function text(words) {
  const bytes = new TextEncoder().encode(words + '\0'), at = module.malloc(bytes.length);
  new Uint8Array(module.memory.buffer, at, bytes.length).set(bytes);
  return at;
}
const message = module.malloc(300), state = module.malloc(16), answer = module.malloc(48);
const quantities = ['force_N', 'stiffness_N_per_m', 'contact_radius_m', 'mean_pressure_Pa', 'dissipated_work_J'];

test('random laws in WebAssembly are those of the headers', () => {
  console.log(execFileSync(join(dirname(process.env.PLATEN), 'random_laws'), ['280', folder], { encoding: 'utf8' }));
  const far = []; // of each law its largest difference, over the largest value; of work, over force times overlap
  for (const one of JSON.parse(readFileSync(join(folder, 'laws.json')))) {
    const law = module.platen_law_new(text(one.law), text(one.variant), text(one.parameters), message, 300);
    assert.notEqual(law, 0, one.card);
    new Uint8Array(module.memory.buffer, state, 16).fill(0);
    const scale = quantities.map((quantity) => Math.max(...one[quantity]));
    scale[4] = scale[0] * Math.max(...one.overlap_m);
    let difference = 0;
    one.overlap_m.forEach((overlap, i) => {
      module.platen_law_evaluate(answer, law, state, overlap);
      const numbers = new Float64Array(module.memory.buffer, answer, 5);
      quantities.forEach((quantity, k) => { difference = Math.max(difference, Math.abs(numbers[k] - one[quantity][i]) / scale[k]); });
    });
    far.push({ difference, ...one });
    module.platen_law_free(law);
  }
  const same = far.filter(({ difference }) => difference <= 1e-12).length;
  const worst = far.reduce((a, b) => (a.difference >= b.difference ? a : b));
  console.log(`${same} of ${far.length} laws to 1e-12, the worst to ${worst.difference}: ${worst.law} ${worst.card}`);
  assert.ok(same >= 0.95 * far.length);
  assert.ok(worst.difference <= 5e-5);
});
