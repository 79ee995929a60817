// web/zones.json: sections through pressed particles, for the explorer. Kept in the repository; made anew by
//   rm web/zones.json; node web/zones.mjs PLATEN_PROGRAM [JOBS]
// What is in the file already is not pressed again.
// Materials near those of the catalogue, and others spread over each pool, are pressed again on a mesh coarser than the
// pool's, and of each picture zones.svg that the program draws a quarter is kept, in fewer points: the other quarters
// are its mirror images.
import { execFile } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';

const here = dirname(fileURLToPath(import.meta.url));
const pools = join(here, '../catalogue/pools');
const elements = 1200, delta_bar = [0.01, 0.03, 0.06, 0.1, 0.2, 0.3, 0.4, 0.5];
const wanted = { elastic: 2, 'von-mises': 12, metals: 24, 'edmans-sinka': 32, powders: 70 };
export const zones = ['elastic', 'shear', 'compaction', 'tension'];
const fills = ['#3b6fb5', '#f6c945', '#b5283b', '#7cc07a'], plane = '#52606d';
const unit = 500; // of R0, in the paths
const tolerance = 0.004; // of R0

// --- which materials ------------------------------------------------------------------------------------------------

/// Of the runs that a surrogate is made of the numbers of their materials, and where they lie: two are so far from each
/// other as `platen predict` counts when it names the nearest.
function surrogateOf(pool) {
  const lines = readFileSync(join(pools, pool, 'surrogate.txt'), 'utf8').split('\n');
  const words = (name) => lines.find((line) => line.startsWith(name + ' ')).split(' ').slice(1);
  const listed = (name) => lines.slice(1 + lines.findIndex((line) => line.startsWith(name + ' '))).slice(0, words(name)[0]).map((line) => line.split(' '));
  const w = words('w').map(Number), inputs = words('inputs').map(Number), keys = listed('ranges').map(([key]) => key);
  return listed('runs').map(([name, ...numbers], i) => ({ pool, name, keys, numbers: numbers.map(Number), at: w.map((one, k) => one * inputs[i * w.length + k]) }));
}

/// `count` runs, each the farthest from all before.
export function spread(pool, count) {
  const runs = surrogateOf(pool), chosen = [];
  const apart = (a, b) => a.at.reduce((sum, x, k) => sum + (x - b.at[k]) ** 2, 0);
  let far = runs.map(() => Infinity);
  const choose = (run) => { chosen.push(run); far = runs.map((one, i) => Math.min(far[i], apart(one, run))); };
  while (chosen.length < Math.min(count, runs.length)) choose(runs[far.indexOf(Math.max(...far))]);
  return chosen;
}

/// Names of the two runs nearest to each material of the catalogue that is predicted of a pool: with these the page begins.
async function nearTheCatalogue(program) {
  const names = new Set();
  for (const file of readdirSync(join(pools, '../materials'))) {
    const card = join(pools, '../materials', file);
    if (!/^model = "(elastic|von-mises|vmdc)"/m.test(readFileSync(card, 'utf8'))) continue;
    const { stdout } = await promisify(execFile)(program, ['predict', card, '--quick', '--extrapolate', '--json', '-o', join(tmpdir(), 'zones-law.toml')]);
    for (const name of JSON.parse(stdout).nearest_runs.slice(0, 2)) names.add(name);
  }
  return names;
}

/// The material of a run, as a table of a case card.
function materialOf({ pool, name, keys, numbers }) {
  const of = Object.fromEntries(keys.map((key, k) => [key, numbers[k]]));
  const card = (model, parameters) => `[material]\nplaten = 1\nname = "${name}"\nmodel = "${model}"\n[material.parameters]\n` +
    Object.entries(parameters).map((line) => line.join(' = ')).join('\n') + '\n';
  if (pool === 'elastic') return card('elastic', { E_Pa: 1e9, ...of });
  if (pool === 'von-mises') return card('von-mises', { sigma_y_Pa: 1e8, ...of });
  if (pool !== 'metals') return card('vmdc', { sigma_y_Pa: 1e8, ...of });
  const [, from, number] = /^(.*)-(\d+)$/.exec(name);
  const [head, ...rows] = readFileSync(join(pools, from, 'runs.csv'), 'utf8').split('\n').filter((line) => line && !line.startsWith('#')).map((line) => line.split(','));
  const row = rows.find((cells) => cells[0] === number), cell = (key) => row[head.indexOf(`material.${key}`)];
  return card('von-mises', { sigma_y_Pa: cell('sigma_y_Pa'), E_bar: cell('E_bar'), nu: cell('nu') }) +
    `[material.parameters.hardening]\nkind = "ludwik"\nK_Pa = ${cell('hardening.K_Pa')}\ninverse_n = ${cell('hardening.inverse_n')}\n`;
}

// --- the pictures ---------------------------------------------------------------------------------------------------

/// A path of relative lines, as src/plot/scene.cpp writes it.
function pointsOf(d) {
  const numbers = d.match(/-?\d*\.?\d+/g).map(Number), points = [];
  let x = 0, y = 0;
  for (let i = 0; i < numbers.length; i += 2) points.push([x += numbers[i], y += numbers[i + 1]]);
  return points;
}

/// What of a ring lies where the coordinate is not negative (Sutherland and Hodgman).
function cut(ring, axis) {
  const out = [];
  ring.forEach((b, i) => {
    const a = ring[(i + ring.length - 1) % ring.length];
    if (a[axis] < 0 !== b[axis] < 0) {
      const t = a[axis] / (a[axis] - b[axis]), at = [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])];
      at[axis] = 0;
      out.push(at);
    }
    if (b[axis] >= 0) out.push(b);
  });
  return out;
}

/// Without points nearer than the tolerance to the line between those that stay (Douglas and Peucker).
function simplified(line) {
  if (line.length < 3) return line;
  const [a, b] = [line[0], line.at(-1)], length = Math.hypot(b[0] - a[0], b[1] - a[1]);
  const off = ([x, y]) => (length > 1e-9 ? Math.abs((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) / length : Math.hypot(x - a[0], y - a[1]));
  let worst = 0, at = 0;
  for (let i = 1; i < line.length - 1; ++i) if (off(line[i]) > worst) worst = off(line[i]), at = i;
  return worst < tolerance ? [a, b] : [...simplified(line.slice(0, at + 1)).slice(0, -1), ...simplified(line.slice(at))];
}

/// A ring in R0, as a path of whole units; empty where nothing of it is left.
function pathOf(ring) {
  const quarter = cut(cut(ring, 0), 1);
  if (quarter.length < 3) return '';
  const whole = simplified([...quarter, quarter[0]]).map((point) => point.map((x) => Math.round(unit * x))).slice(0, -1);
  const area = whole.reduce((sum, [x, y], i) => sum + whole.at(i - 1)[0] * y - x * whole.at(i - 1)[1], 0) / 2;
  if (Math.abs(area) < 8) return '';
  let d = `M${whole[0][0]} ${whole[0][1]}l`, [x, y] = whole[0];
  for (const [to_x, to_y] of whole.slice(1)) {
    const [dx, dy] = [to_x - x, to_y - y];
    if (dx || dy) d += `${dx < 0 || d.endsWith('l') ? '' : ' '}${dx}${dy < 0 ? '' : ' '}${dy}`;
    [x, y] = [to_x, to_y];
  }
  return d + 'z';
}

/// Of each panel of a zones.svg its overlap and its rings: the number of the zone before the path.
export function panelsOf(svg) {
  const panels = [];
  let faces = [], rings = [];
  for (const line of svg.split('\n')) {
    const path = /^<path d="([^"]*)" fill="([^"]*)"/.exec(line), caption = /^<text x="([\d.]+)"[^>]*>δ̄ = ([\d.]+)</.exec(line);
    if (path?.[2] === plane) faces.push(pointsOf(path[1])[0][1]);
    else if (path && fills.includes(path[2])) rings.push([fills.indexOf(path[2]), pointsOf(path[1])]);
    if (!caption) continue;
    const [cx, delta] = caption.slice(1).map(Number), cy = (faces[0] + faces[1]) / 2, radius = (faces[1] - faces[0]) / 2 / (1 - delta);
    const paths = rings.map(([zone, ring]) => [zone, pathOf(ring.map(([x, y]) => [(x - cx) / radius, (cy - y) / radius]))]);
    panels.push({ delta, paths: paths.filter(([, d]) => d).map(([zone, d]) => zone + d) });
    faces = [], rings = [];
  }
  return panels;
}

/// { run, moments: [[delta/R0, shares of the volume in per cent, paths]] } of a run, pressed again.
export async function pressed(program, run) {
  const work = mkdtempSync(join(tmpdir(), 'zones-'));
  try {
    writeFileSync(join(work, 'case.toml'), `platen = 1\nexperiment = "simple"\nradius_m = 1e-3\n[mesh]\nelements = ${elements}\n[output]\nfields_at = [${delta_bar}]\n` + materialOf(run));
    await promisify(execFile)(program, ['press', join(work, 'case.toml'), '-o', join(work, 'out')], { env: { ...process.env, OPENBLAS_NUM_THREADS: '1' } });
    const [head, ...rows] = readFileSync(join(work, 'out/curve.csv'), 'utf8').split('\n').filter((line) => line && !line.startsWith('#')).map((line) => line.split(','));
    const cell = (row, key) => row[head.indexOf(key)];
    const moments = panelsOf(readFileSync(join(work, 'out/zones.svg'), 'utf8')).map(({ delta, paths }) => {
      const row = rows.find((cells) => cell(cells, 'branch') === 'loading' && Math.abs(cell(cells, 'delta_bar') - delta) < 1e-6);
      return [delta, zones.map((zone) => Number((100 * cell(row, `zone_${zone}`)).toFixed(1))), paths];
    });
    return { run: run.name, moments };
  } finally {
    rmSync(work, { recursive: true });
  }
}

async function main(program, jobs = 1) {
  const near = await nearTheCatalogue(program), file = join(here, 'zones.json');
  const kept = existsSync(file) ? JSON.parse(readFileSync(file)) : { pressed: {} };
  const runs = Object.entries(wanted).flatMap(([pool, count]) => {
    const all = spread(pool, Infinity);
    return all.filter(({ name }, i) => i < count || near.has(name));
  });
  const done = runs.filter(({ name }) => kept.elements === elements && kept.pressed[name]).map(({ name }) => ({ run: name, moments: kept.pressed[name] }));
  const waiting = runs.filter(({ name }) => !done.some(({ run }) => run === name));
  const work = async () => {
    for (let run = waiting.shift(); run; run = waiting.shift())
      try {
        done.push(await pressed(program, run));
        console.log(`${run.name} (${done.length} of ${runs.length})`);
      } catch (error) {
        console.log(`${run.name}: left out: ${String(error.stderr ?? error).trim().split('\n').at(-1)}`);
      }
  };
  await Promise.all(Array.from({ length: jobs }, work));
  done.sort((a, b) => runs.findIndex(({ name }) => name === a.run) - runs.findIndex(({ name }) => name === b.run));
  const lines = done.map(({ run, moments }) => `${JSON.stringify(run)}: [\n${moments.map((moment) => JSON.stringify(moment)).join(',\n')}]`);
  writeFileSync(file, `{"elements": ${elements}, "unit": ${unit}, "pressed": {\n${lines.join(',\n')}}}\n`);
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  if (!process.argv[2]) throw new Error('usage: node web/zones.mjs PLATEN_PROGRAM [JOBS]');
  await main(process.argv[2], Number(process.argv[3] ?? 1));
}
