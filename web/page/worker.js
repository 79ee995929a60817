// Platen in WebAssembly, away from the page: texts in, texts and numbers out.

let module; // its exports
let surrogates = 0;
let lastMaterial = null, lastPrediction = null;

// What the C library wants of a system: nothing to read, nothing to write, a clock.
const system = new Proxy({}, {
  get: (_, name) => (...args) => {
    const view = () => new DataView(module.memory.buffer);
    if (name === 'proc_exit') throw new Error('the module ended itself');
    if (name === 'clock_time_get') view().setBigUint64(args[2], BigInt(Math.round(performance.now() * 1e6)), true);
    else if (name === 'random_get') crypto.getRandomValues(new Uint8Array(module.memory.buffer, args[0], args[1]));
    else if (name.endsWith('_sizes_get')) view().setUint32(args[0], 0, true), view().setUint32(args[1], 0, true);
    else if (name === 'fd_write') {
      let size = 0;
      for (let i = 0; i < args[2]; ++i) size += view().getUint32(args[1] + 8 * i + 4, true);
      view().setUint32(args[3], size, true);
    } else if (!name.endsWith('_get')) return 8; // EBADF: there are no files
    return 0;
  },
});

// Encodings: the browser knows them.
function decode(name, nameSize, bytes, size, out, room) {
  const memory = new Uint8Array(module.memory.buffer);
  const label = { 'UTF-16LE': 'utf-16le', 'UTF-16BE': 'utf-16be', CP932: 'shift_jis', 'WINDOWS-1252': 'windows-1252' }[
    decoder.decode(memory.slice(name, name + nameSize))] ?? 'windows-1252';
  try {
    const text = encoder.encode(new TextDecoder(label, { fatal: true, ignoreBOM: true }).decode(memory.slice(bytes, bytes + size)));
    if (text.length > room) return -1;
    memory.set(text, out);
    return text.length;
  } catch {
    return -1;
  }
}

const encoder = new TextEncoder(), decoder = new TextDecoder();

function give(bytes) {
  const at = module.buffer(bytes.length);
  new Uint8Array(module.memory.buffer, at, bytes.length).set(bytes);
}
const text = () => decoder.decode(new Uint8Array(module.memory.buffer, module.text(), module.text_size()));
const numbers = () => new Float64Array(module.memory.buffer, module.values(), module.values_size()).slice();

/// The text that a call gives for what it is given; its sentence as an Error.
function call(name, given) {
  give(typeof given === 'string' ? encoder.encode(given) : given);
  if (module[name]() !== 0) throw new Error(text());
  return text();
}

async function unpacked(url) {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url} could not be loaded`);
  return new Uint8Array(await new Response(response.body.pipeThrough(new DecompressionStream('gzip'))).arrayBuffer());
}

async function start() {
  const [instance, data] = await Promise.all([
    WebAssembly.instantiateStreaming(fetch('explorer.wasm'), { wasi_snapshot_preview1: system, page: { decode } }),
    unpacked('catalogue.gz')]);
  module = instance.instance.exports;
  module._initialize();
  const { surrogates: files, cards } = JSON.parse(decoder.decode(data));
  for (const file of files) call('load', file), ++surrogates;
  return cards.map((card) => ({ ...card, parameters: JSON.parse(call('card',
    Object.entries({ name: card.name, model: card.model, ...card.parameters }).map((line) => line.join('=')).join('\n'))) }));
}

// Between questions: what makes the next answers come sooner.
let resting = 0;
function rest() {
  clearTimeout(resting);
  resting = setTimeout(() => { if (module.prepare()) rest(); else postMessage({ ready: true }); }, 0);
}

function update({ material, curves, top, at }) {
  const reply = {};
  if (material !== lastMaterial) {
    lastMaterial = material;
    lastPrediction = JSON.parse(call('predict', material));
  }
  reply.prediction = lastPrediction;
  reply.curves = JSON.parse(call('curves', curves));
  reply.numbers = numbers();
  const end = reply.curves.end_m;
  module.forget();
  module.step(top * end);
  reply.way = []; // of unloading, to be drawn
  for (let i = 0; at < top && i < 24; ++i) {
    const u = i / 24;
    module.step((top + (at - top) * u) * end);
    const [overlap, force] = numbers();
    reply.way.push(overlap, force);
  }
  if (at < top) module.step(at * end);
  reply.contact = numbers();
  return reply;
}

const answers = {
  update,
  step: ({ overlap }) => { module.step(overlap); return { contact: numbers() }; },
  forget: () => { module.forget(); module.step(0); return { contact: numbers() }; },
  near: ({ runs }) => ({ near: JSON.parse(call('nearest_of', runs)) }),
  file: ({ asked }) => ({ file: call('file', asked) }),
  measured: ({ name, bytes }) => {
    const head = encoder.encode(name.replaceAll('\n', ' ') + '\n');
    const all = new Uint8Array(head.length + bytes.byteLength);
    all.set(head);
    all.set(new Uint8Array(bytes), head.length);
    const found = JSON.parse(call('measured', all));
    return { found, numbers: numbers() };
  },
  fit: ({ asked }) => ({ fitted: JSON.parse(call('fit', asked)) }),
};

const started = start();
started.then((cards) => postMessage({ cards }), (error) => postMessage({ broken: String(error.message || error) }));

onmessage = async ({ data }) => {
  await started;
  let reply;
  try {
    reply = answers[data.kind](data);
  } catch (error) {
    if (data.kind === 'update') lastMaterial = null;
    reply = { sentence: error.message };
  }
  const moved = [reply.numbers, reply.contact].filter(Boolean).map((list) => list.buffer);
  postMessage({ id: data.id, ...reply }, moved);
  rest();
};
