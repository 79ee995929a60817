// The explorer in a real browser, beside the program.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { chromium } from 'playwright-core';
import { fromLink, initial, toLink } from '../page/link.js';
import { allOf, cardOf, lines, models, particle, valueAt } from '../page/materials.js';
import { typed, words } from '../page/quantity.js';
import { pressed, spread, zones } from '../zones.mjs';
import { serve } from './server.mjs';

const folder = process.env.PLATEN_PAGE, platen = process.env.PLATEN;
const work = mkdtempSync(join(tmpdir(), 'platen-explorer-'));
let server, browser;

before(async () => {
  server = await serve(folder);
  browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', args: ['--no-sandbox'] });
});
after(async () => { await browser?.close(); server?.close(); });

/// A page that counts what must not be: errors, and requests to elsewhere.
async function opened({ hash = '', width = 1200, height = 900, ...more } = {}) {
  const context = await browser.newContext({ viewport: { width, height }, acceptDownloads: true, ...more });
  const page = await context.newPage();
  page.bad = [];
  page.on('console', (m) => { if (['error', 'warning'].includes(m.type())) page.bad.push(m.text()); });
  page.on('pageerror', (error) => page.bad.push(String(error)));
  page.on('request', (request) => { if (!/^(data|blob):/.test(request.url()) && !request.url().startsWith(server.url)) page.bad.push('asked ' + request.url()); });
  await page.goto(server.url + hash);
  return page;
}
const drawn = (page) => page.waitForSelector('[data-revision]', { state: 'attached' });
const closed = async (page) => { assert.deepEqual(page.bad, []); await page.context().close(); };

// Numbers that anyone can make again (Lehmer).
let seed = 20240229;
const random = () => (seed = (seed * 48271) % 2147483647) / 2147483647;

const scales = { G: 1e9, M: 1e6, k: 1e3, m: 1e-3, µ: 1e-6, n: 1e-9, p: 1e-12, f: 1e-15 };
function si(text) {
  const [number, unit] = text.split(' ');
  const long = unit.length > 1 && unit !== 'Pa' && unit !== 'N/m' && unit !== 'm/s';
  return Number(number) * (long ? scales[unit[0]] : 1);
}

function randomState() {
  const s = initial();
  s.model = ['von-mises', 'ludwik', 'vmdc', 'vmdc', 'elastic', 'rock'][Math.floor(6 * random())];
  s.name = 'random';
  s.values = {};
  for (const p of allOf(s.model)) s.values[p.key] = valueAt(p, 300 + Math.round(400 * random()));
  if (s.model === 'von-mises') s.values.sigma_y_Pa = Number((s.values.E_Pa / (5 * 200 ** random())).toPrecision(3)), s.values.nu = 0.3;
  if (s.model === 'ludwik') {
    const round = (x) => Number(x.toPrecision(3));
    s.values.sigma_y_Pa = round(s.values.E_Pa / (40 * 50 ** random())), s.values.nu = round(0.22 + 0.16 * random());
    s.values.K_Pa = round(s.values.sigma_y_Pa * 0.2 * 50 ** random()), s.values.inverse_n = round(0.2 + 0.7 * random());
  }
  if (s.model === 'vmdc') { // about the published powders, or about the base case
    const near = random() < 0.5 ? { rho_r0: 0.4, E_bar: 80, nu: 0.15, Gamma_bar: 1.1, Lambda_bar: 0.03, epsilon: 0.25, eta: 8, xi: 7.5, zeta: 8, omega: 8, xi_1: 0.4, xi_2: 2 }
      : { rho_r0: 0.7, E_bar: 60, nu: 0.3, Gamma_bar: 0.7, Lambda_bar: 0.05, epsilon: 0.7, eta: 10, xi: 7.5, zeta: 10, omega: 10, xi_1: 0.4, xi_2: 1.5 };
    const fixed = near.rho_r0 === 0.7 ? ['E_bar', 'Gamma_bar', 'Lambda_bar'] : Object.keys(near);
    for (const key of Object.keys(near)) s.values[key] = fixed.includes(key) ? Number((near[key] * (0.9 + 0.2 * random())).toPrecision(3)) : near[key];
  }
  if (s.model === 'rock') { // about the grains of its pool, some beyond
    const round = (x) => Number(x.toPrecision(3));
    s.values = { E_Pa: round(8e9 * 4 ** random()), nu: round(0.09 + 0.22 * random()), phi_deg: round(19 + 22 * random()), sigma_c_Pa: round(4e6 * 15 ** random()) };
  }
  s.radius_m = valueAt(particle[0], Math.round(1000 * random()));
  s.against = random() < 0.3 ? 'plane' : 'sphere';
  s.top = Number((0.05 + 0.95 * random()).toFixed(3));
  s.at = random() < 0.5 ? s.top : Number((s.top * (0.9 + 0.1 * random())).toFixed(4));
  return s;
}

test('values on screen are those of the program, 50 random materials', { timeout: 400000 }, async () => {
  const page = await opened();
  await drawn(page);
  let compared = 0, refused = 0;
  const kinds = {};
  for (let tries = 0; compared < 50; ++tries) {
    assert.ok(tries < 300, `only ${compared} of ${tries} random materials have a law`);
    const s = randomState();
    const before = await page.evaluate(() => document.documentElement.dataset.revision);
    await page.evaluate((hash) => { location.hash = hash; }, toLink(s));
    await page.waitForFunction((r) => document.documentElement.dataset.revision !== r, before);
    const quoted = (line) => line.replace(/=([a-z]+)$/, '="$1"');
    writeFileSync(join(work, 'material.toml'), `platen = 1\nname = "random"\nmodel = "${cardOf(s.model)}"\n[parameters]\n` +
      lines(s.model, s.values).map(quoted).join('\n'));
    let card = null;
    try {
      execFileSync(platen, ['predict', 'material.toml', '--quick', '--extrapolate', '-o', 'law.toml'], { cwd: work, stdio: 'pipe' });
      card = readFileSync(join(work, 'law.toml'), 'utf8');
    } catch (error) { // the page must then say so too
      assert.equal(error.status, 2, String(error.stderr));
      await page.waitForFunction(() => document.getElementById('verdict-word').textContent === 'No law');
      ++refused;
      continue;
    }
    const shown = await page.evaluate(() => Object.fromEntries([...document.querySelectorAll('#readout dd')].map((dd) => [dd.dataset.of, dd.textContent])));
    const end = Number(/\[validity\]\ndelta_bar = \[0, ([\d.e-]+)\]/.exec(card)[1]) * s.radius_m * (s.against === 'plane' ? 1 : 2);
    writeFileSync(join(work, 'path.csv'), `overlap_m\n${s.top * end}\n${s.at * end}\n`);
    const rows = execFileSync(platen, ['eval', 'law.toml', '-p', `radius_m=${s.radius_m}`, '--against', s.against, '--path', 'path.csv'], { cwd: work, stdio: ['ignore', 'pipe', 'ignore'] })
      .toString().trim().split('\n').map((line) => line.split(','));
    const row = Object.fromEntries(rows[0].map((key, i) => [key, rows[2][i]]));
    for (const [name, key] of [['overlap', 'overlap_m'], ['force', 'force_N'], ['contact radius', 'contact_radius_m'], ['mean pressure', 'mean_pressure_Pa'], ['stiffness', 'stiffness_N_per_m']]) {
      const value = Number(row[key]), off = Math.abs(si(shown[name]) - value);
      assert.ok(off <= 0.5000001e-5 * 10 ** Math.ceil(Math.log10(Math.abs(value) || 1)) || // apart, the law's numbers fade out
        (row.branch === 'separated' && si(shown[name]) === 0 && Math.abs(value) < 1e-9 * Number(rows[1][rows[0].indexOf(key)])), `${name}: ${shown[name]} for ${value}, ${toLink(s)}`);
    }
    ++compared;
    kinds[s.model] = 1 + (kinds[s.model] ?? 0);
  }
  assert.ok(Object.keys(models).every((model) => kinds[model] > 0), JSON.stringify(kinds));
  console.log(`    50 compared; of ${refused} more, program and page both said that there is no law`);
  await closed(page);
});

const download = async (page, selector) => {
  const [file] = await Promise.all([page.waitForEvent('download'), page.click(selector)]);
  return readFileSync(await file.path(), 'utf8');
};

test('what is downloaded is what the program writes', async () => {
  const page = await opened();
  await drawn(page);
  await page.click('#skip');
  for (const card of ['mcc-ph-200', 'base-case', 'von-mises-100', 'wang-type-1', 'elastic']) {
    const before = await page.evaluate(() => document.documentElement.dataset.revision);
    await page.selectOption('#card', card === 'mcc-ph-200' ? 'base-case' : 'mcc-ph-200');
    await page.waitForFunction((r) => document.documentElement.dataset.revision !== r, before);
    const middle = await page.evaluate(() => document.documentElement.dataset.revision);
    await page.selectOption('#card', card);
    await page.waitForFunction((r) => document.documentElement.dataset.revision !== r, middle);
    const law = await download(page, '[data-file="law.toml"]');
    execFileSync(platen, ['predict', card, '--quick', '-o', join(work, 'card.toml')], { stdio: 'pipe' });
    assert.equal(law, readFileSync(join(work, 'card.toml'), 'utf8'));
  }
  writeFileSync(join(work, 'law.toml'), await download(page, '[data-file="law.toml"]'));
  const lines = await download(page, '[data-file="law.lmp"]');
  const expected = execFileSync(platen, ['export', 'lammps', 'law.toml', '--radius', '0.0005', '--density', '1500'], { cwd: work }).toString();
  assert.equal(lines, expected.replace(/(pair_coeff 1 1 ).*law.toml/, '$1law.toml'));
  const table = await download(page, '[data-file="table.csv"]');
  const ours = execFileSync(platen, ['export', 'table', 'law.toml', '-p', 'radius_m=0.0005', '--overlap', '1e-6:5e-4:500'], { cwd: work }).toString();
  assert.equal(table.trim().split('\n').length, ours.trim().split('\n').length);
  assert.match(await download(page, '[data-file="svg"]'), /^<svg[^]*overlap  γ \[(µm|mm)\][^]*<\/svg>$/);
  const png = await download(page, '[data-file="png"]');
  assert.ok(png.length > 10000);
  await closed(page);
});

test('axe finds nothing serious, in light and dark, at three widths, nothing scrolls sideways', { timeout: 300000 }, async () => {
  const axe = readFileSync(new URL('node_modules/axe-core/axe.min.js', import.meta.url), 'utf8');
  for (const width of [390, 1024, 1920])
    for (const colorScheme of ['light', 'dark']) {
      const page = await opened({ width, colorScheme });
      await drawn(page);
      await page.waitForTimeout(500);
      for (const questions of [true, false]) {
        if (!questions) {
          await page.click('#skip');
          await page.click('#inside summary');
          await page.waitForSelector('#section rect', { state: 'attached' });
        }
        await page.evaluate(axe);
        const found = await page.evaluate(() => axe.run(document, { runOnly: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa', 'best-practice'] }));
        const serious = found.violations.filter((v) => ['serious', 'critical'].includes(v.impact)).map((v) => `${v.id}: ${v.nodes.map((n) => n.target).join(' ')}`);
        assert.deepEqual(serious, [], `${width} ${colorScheme}`);
        assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), `scrolls sideways at ${width}`);
      }
      await closed(page);
    }
});

test('keyboard: the dot loads and unloads', async () => {
  const page = await opened();
  await drawn(page);
  await page.click('#skip');
  await page.focus('.dot');
  const branch = () => page.locator('#readout dd').last().textContent();
  const overlapOf = async () => si(await page.locator('#readout dd').first().textContent());
  const at = await overlapOf();
  await page.keyboard.press('End');
  await page.waitForFunction((from) => document.querySelector('.dot').getAttribute('aria-valuenow') === '100.0', at);
  assert.equal(await branch(), 'loading');
  await page.keyboard.press('ArrowLeft');
  await page.waitForFunction(() => document.querySelector('.dot').getAttribute('aria-valuenow') === '99.0');
  assert.equal(await branch(), 'unloading');
  await page.keyboard.press('Home');
  await page.waitForFunction(() => document.querySelector('.dot').getAttribute('aria-valuenow') === '0.0');
  assert.equal(await branch(), 'separated');
  await closed(page);
});

test('dragging loads and unloads', async () => {
  const page = await opened();
  await drawn(page);
  await page.click('#skip');
  const box = await page.locator('.dot').boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 60, y, { steps: 6 });
  // The page leaves out places of the pointer that it has no time for; the farthest must be drawn.
  await page.waitForFunction((there) => document.querySelector('.dot').getBoundingClientRect().x > there - 1, box.x + 60);
  await page.mouse.move(x + 58, y, { steps: 2 });
  await page.waitForFunction(() => [...document.querySelectorAll('#readout dd')].at(-1).textContent === 'unloading');
  await page.mouse.up();
  await closed(page);
});

// --- inside -------------------------------------------------------------------------------------------------------------

const pictures = JSON.parse(readFileSync(new URL('../zones.json', import.meta.url)));
const runOf = (pool, name) => spread(pool, 1000).find((run) => run.name === name);
const insideOf = async (page) => {
  if (!await page.evaluate(() => document.getElementById('inside').open)) await page.click('#inside summary');
  await page.waitForSelector('#section rect', { state: 'attached' });
  return page.evaluate(() => ({ words: document.getElementById('inside-words').textContent, label: document.querySelector('#section svg').getAttribute('aria-label'),
    shares: Object.fromEntries([...document.querySelectorAll('#zones li')].map((li) => [li.childNodes[1].textContent.trim(), li.lastChild.textContent])),
    fills: [...new Set([...document.querySelectorAll('#section path')].map((path) => path.getAttribute('fill')))] }));
};

test('pictures of the inside are what the program presses', { timeout: 300000 }, async () => {
  assert.ok(statSync(join(folder, 'zones.gz')).size < 0.7e6);
  for (const [pool, name] of [['edmans-sinka', 'edmans-sinka-100'], ['metals', Object.keys(pictures.pressed).find((name) => name.startsWith('metals'))]]) {
    const { moments } = await pressed(platen, runOf(pool, name)), kept = pictures.pressed[name];
    assert.deepEqual(moments.map(([at]) => at), kept.map(([at]) => at));
    moments.forEach(([at, shares, paths], i) => { // processors round differently: a point at an edge may flow or not
      shares.forEach((share, k) => assert.ok(Math.abs(share - kept[i][1][k]) <= 1, `${name} at ${at}: ${zones[k]} ${share} %, kept ${kept[i][1][k]} %`));
      const wide = (list) => Math.max(...list[0].slice(2).split('l')[1].match(/-?\d+/g).reduce(([x, widest], step, j) => (j % 2 ? [x, widest] : [x + Number(step), [...widest, x + Number(step)]]), [Number(list[0].slice(2).split(' ')[0]), []])[1]);
      assert.ok(Math.abs(wide(paths) - wide(kept[i][2])) <= 3, `${name} at ${at}: another outline`);
    });
  }
});

// As those see them who lack one kind of cone (Machado et al. 2009, complete), in CIE L*a*b*: a difference of 2 can just be seen.
test('zones keep apart for the colour-blind', async () => {
  const colours = Object.values(await import('../page/inside.js').then((m) => m.zones)).map(([, hex]) => hex);
  const times = (m, v) => [0, 1, 2].map((r) => m[3 * r] * v[0] + m[3 * r + 1] * v[1] + m[3 * r + 2] * v[2]);
  const linear = (hex) => [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16) / 255).map((c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4));
  const lab = (rgb) => {
    const [x, y, z] = times([0.4124, 0.3576, 0.1805, 0.2126, 0.7152, 0.0722, 0.0193, 0.1192, 0.9505], rgb.map((c) => Math.min(1, Math.max(0, c))))
      .map((c, i) => c / [0.9505, 1, 1.089][i]).map((t) => (t > 0.008856 ? Math.cbrt(t) : 7.787 * t + 16 / 116));
    return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
  };
  for (const eye of [[1, 0, 0, 0, 1, 0, 0, 0, 1], [0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998],
    [0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.01182, 0.04294, 0.968881], [1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367, 0.3039]])
    colours.forEach((a, i) => colours.slice(i + 1).forEach((b) => {
      const [one, other] = [a, b].map((hex) => lab(times(eye, linear(hex))));
      assert.ok(Math.hypot(...one.map((x, k) => x - other[k])) > 20, `${a} and ${b}`);
    }));
});

test('inside: the nearest pressed material at the overlap of the dot, asked for when it is opened', { timeout: 60000 }, async () => {
  const page = await opened();
  const asked = [];
  page.on('request', (request) => { if (request.url().endsWith('zones.gz')) asked.push(request.url()); });
  await drawn(page);
  await page.click('#skip');
  await page.waitForTimeout(300);
  assert.deepEqual(asked, []);
  const first = await insideOf(page);
  assert.equal(asked.length, 1);
  // the page opens with the base case at 0.7 of 0.5; it is among those that have a picture
  assert.match(first.words, /^edmans-sinka-100, whose force is that of yours, pressed to δ\/R = 0\.[34]: the nearest of \d+ pressed materials/);
  const [at, shares] = pictures.pressed['edmans-sinka-100'].find(([one]) => first.words.includes(`= ${one}:`));
  for (const [k, zone] of zones.entries()) {
    assert.equal(first.shares[zone], shares[k] > 0 && shares[k] < 1 ? 'less than 1 %' : `${Math.round(shares[k])} %`);
    assert.ok(first.label.includes(`${zone} ${first.shares[zone]}`));
  }
  assert.ok(first.label.includes(`δ/R = ${at}`));
  execFileSync(platen, ['press', 'case.toml', '-o', 'inside'], { cwd: (writeFileSync(join(work, 'case.toml'), 'platen = 1\nexperiment = "simple"\nmaterial = "base-case"\nradius_m = 1e-3\n[mesh]\nelements = 100\n[path]\ndelta_bar_max = 0.1\n[output]\nfields_at = [0.1]\n'), work), stdio: 'ignore' });
  const picture = readFileSync(join(work, 'inside/zones.svg'), 'utf8');
  for (const fill of first.fills) assert.ok(picture.includes(`fill="${fill}"`), `${fill} is no colour of the program's pictures`);
  await page.focus('.dot');
  await page.keyboard.press('End');
  await page.waitForFunction(() => /δ\/R = 0\.5:/.test(document.getElementById('inside-words').textContent));
  await page.keyboard.press('ArrowLeft');
  await page.waitForFunction(() => /The contact unloads/.test(document.getElementById('inside-words').textContent));
  await page.click('#again');
  await page.waitForFunction(() => /δ\/R = 0\.01:/.test(document.getElementById('inside-words').textContent));
  await closed(page);
});

test('inside: nearest as the program says it; none of rock; a sentence where pictures are missing', { timeout: 60000 }, async () => {
  let compared = 0;
  for (const name of Object.keys(pictures.pressed).filter((run, i) => /^powders|^edmans/.test(run) && i % 9 === 0)) {
    const run = runOf(name.startsWith('edmans') ? 'edmans-sinka' : 'powders', name);
    if (!run) continue; // of a surrogate no more
    const values = Object.fromEntries(run.keys.map((key, k) => [key, run.numbers[k] * (key !== 'E_bar' ? 1 : run.numbers[k] > 100 ? 0.99 : 1.01)]));
    if (allOf('vmdc').some((p) => values[p.key] < p.low || values[p.key] > p.high)) continue; // beyond a slider
    ++compared;
    writeFileSync(join(work, 'near.toml'), 'platen = 1\nname = "near"\nmodel = "vmdc"\n[parameters]\nsigma_y_Pa = 1e8\n' + Object.entries(values).map((line) => line.join(' = ')).join('\n'));
    const near = JSON.parse(execFileSync(platen, ['predict', 'near.toml', '--quick', '--extrapolate', '--json', '-o', 'near-law.toml'], { cwd: work, stdio: ['ignore', 'pipe', 'ignore'] })).nearest_runs[0];
    const page = await opened({ hash: toLink({ ...initial(), name: 'near', values: { sigma_y_Pa: 1e8, ...values } }) });
    await drawn(page);
    const { words } = await insideOf(page);
    assert.ok(words.startsWith(near + ','), `${words} for ${near}`);
    const off = Number(/differs from that of yours by ([\d.]+) %/.exec(words)?.[1] ?? 0); // a hundredth of E
    assert.ok(off < 2, words);
    await closed(page);
  }
  assert.ok(compared >= 8, `${compared} compared`);
  const page = await opened({ hash: toLink({ ...initial(), model: 'rock', values: Object.fromEntries(allOf('rock').map((p) => [p.key, p.start])) }) });
  await drawn(page);
  await page.click('#inside summary');
  await page.waitForFunction(() => /pressed at their contact alone/.test(document.getElementById('inside-words').textContent));
  assert.equal(await page.isVisible('#section'), false);
  await closed(page);
  const without = await opened({ serviceWorkers: 'block' });
  await without.route('**/zones.gz', (route) => route.abort());
  await drawn(without);
  await without.click('#skip');
  await without.click('#inside summary');
  await without.waitForFunction(() => /could not be loaded/.test(document.getElementById('inside-words').textContent));
  await without.context().close();
});

test('rock: verdict, grains that are near, and what a left-out grain says of the error', async () => {
  const values = { E_Pa: 15e9, sigma_c_Pa: 20e6, phi_deg: 30, nu: 0.2 };
  const page = await opened({ hash: toLink({ ...initial(), model: 'rock', values }) });
  await drawn(page);
  writeFileSync(join(work, 'rock.toml'), 'platen = 1\nname = "rock"\nmodel = "drucker-prager"\n[parameters]\n' + Object.entries(values).map((line) => line.join(' = ')).join('\n'));
  const said = JSON.parse(execFileSync(platen, ['predict', 'rock.toml', '--json', '-o', 'rock-law.toml'], { cwd: work, stdio: ['ignore', 'pipe', 'ignore'] }));
  await page.waitForFunction(() => document.querySelectorAll('#near li').length === 3);
  assert.equal(await page.getAttribute('#verdict', 'data-verdict'), said.verdict);
  assert.deepEqual((await page.locator('#near li').allTextContents()).map((text) => text.split(' ')[0]), said.nearest_runs.map((text) => text.split(':')[0]));
  const grains = readFileSync(new URL('../../catalogue/pools/wang/grains.csv', import.meta.url), 'utf8');
  const percent = (key) => `${Number((100 * Number(new RegExp(`left_out.force.${key} = (\\S+)`).exec(grains)[1])).toPrecision(2))} %`;
  assert.match(await page.textContent('#why'), new RegExp(`came out ${percent('median')} off in force, one in twenty more than ${percent('p95')}`));
  await page.fill('#f-phi_deg', '45 degrees');
  await page.press('#f-phi_deg', 'Enter');
  await page.waitForFunction(() => /phi = 45 degrees is not in 20 to 40/.test(document.getElementById('why').textContent));
  await closed(page);
});

test('three questions start from a card', async () => {
  const page = await opened();
  await drawn(page);
  await page.click('text=A granule or tablet of powder');
  await page.click('text=A fingernail marks it');
  await page.click('text=Like salt');
  await page.waitForFunction(() => /card/.test(document.getElementById('note').textContent));
  assert.match(await page.inputValue('#f-radius_m'), /150 µm/);
  assert.ok(await page.inputValue('#card'));
  await closed(page);
});

test('nonsense in fields: a sentence, and the curve stays', async () => {
  const page = await opened();
  await drawn(page);
  await page.click('#skip');
  const before = await page.inputValue('#f-sigma_y_Pa');
  for (const [text, sentence] of [['hard', /is not a number and its unit/], ['3 potatoes', /no unit/], ['-1 MPa', /must be from/], ['1e99 GPa', /must be from/], ['', /is not a number/], ['NaN', /is not/]]) {
    await page.fill('#f-sigma_y_Pa', text);
    await page.press('#f-sigma_y_Pa', 'Enter');
    assert.match(await page.textContent('#f-sigma_y_Pa-error'), sentence, text);
    assert.equal(await page.getAttribute('#f-sigma_y_Pa', 'aria-invalid'), 'true');
  }
  const revision = await page.evaluate(() => document.documentElement.dataset.revision);
  await page.fill('#f-sigma_y_Pa', '12.5 MPa');
  await page.press('#f-sigma_y_Pa', 'Enter');
  await page.waitForFunction((r) => document.documentElement.dataset.revision !== r, revision);
  assert.equal(await page.textContent('#f-sigma_y_Pa-error'), '');
  assert.notEqual(before, '12.5 MPa');
  await closed(page);
});

test('typed units', () => {
  for (const [text, unit, value] of [['1.2 GPa', 'Pa', 1.2e9], ['1,2e9', 'Pa', 1.2e9], ['35 um', 'm', 35e-6], ['35µm', 'm', 35e-6], ['2 mpa', 'Pa', 2e6], ['1.5 g/cm3', 'kg/m³', 1500], ['.3', '', 0.3]])
    assert.ok(Math.abs(typed(text, unit) / value - 1) < 1e-12, text);
  assert.equal(words(1.2e9, 'Pa'), '1.2 GPa');
  assert.equal(words(3.5e-7, 'm', 6, true), '350.000 nm');
  for (const bad of ['', 'x', '1 2', '1e', '5 %', '1 N']) assert.throws(() => typed(bad, 'Pa'), /./, bad);
});

test('links carry the state, broken ones are told', async () => {
  const s = randomState();
  assert.deepEqual({ ...fromLink(toLink(s)) }, s);
  for (const [hash, sentence] of [['#v=1&model=gold', /no kind of material/], ['#v=9', /another version/], ['#%%%', /does not say/], ['#v=1&model=elastic&E_Pa=abc&nu=0.3', /E_Pa = abc/],
    ['#v=1&model=__proto__', /no kind/], ['#' + 'x'.repeat(5000), /does not say/], [toLink(s).replace(/radius_m=[^&]*/, 'radius_m=-1'), /radius_m/]]) {
    const page = await opened({ hash });
    await drawn(page);
    assert.match(await page.textContent('#sentence'), sentence);
    assert.ok((await page.getAttribute('#force path[stroke-width="2.8"]', 'd')).length > 100, 'nothing is drawn');
    await closed(page);
  }
});

const curveOf = (radius, name) => {
  const card = join(work, 'fit-law.toml');
  execFileSync(platen, ['predict', name, '--quick', '-o', card], { stdio: 'pipe' });
  const rows = execFileSync(platen, ['eval', card, '-p', `radius_m=${radius}`, '--against', 'plane', '--overlap', `0:${0.3 * radius}:101`], { stdio: ['ignore', 'pipe', 'ignore'] }).toString().trim().split('\n').slice(1);
  return 'delta_m,force_N\n' + rows.map((row) => row.split(',').slice(0, 2).join(',')).join('\n') + '\n';
};

test('a measured curve is read, stays here, and gives the strength back', { timeout: 60000 }, async () => {
  const state = { ...initial(), model: 'von-mises', name: 'my material', values: { E_Pa: 10e9, sigma_y_Pa: 30e6, nu: 0.3 }, radius_m: 1e-3, beside: [] };
  const page = await opened({ hash: toLink(state) });
  await drawn(page);
  await page.setInputFiles('#csv', { name: 'own.csv', mimeType: 'text/csv', buffer: Buffer.from(curveOf(1e-3, 'von-mises-100')) });
  await page.waitForFunction(() => /points of loading/.test(document.getElementById('measured').textContent));
  await page.click('#fit');
  await page.waitForFunction(() => /brings the law nearest/.test(document.getElementById('measured').textContent));
  const found = typed(await page.inputValue('#f-sigma_y_Pa'), 'Pa');
  assert.ok(Math.abs(found / 100e6 - 1) < 0.02, `${found} for 100 MPa`);
  await closed(page);
});

test('files that are none', async () => {
  const page = await opened();
  await drawn(page);
  const told = async (name, buffer, sentence) => {
    await page.evaluate(() => { document.getElementById('measured').textContent = ''; });
    await page.setInputFiles('#csv', { name, mimeType: 'text/csv', buffer });
    await page.waitForFunction(() => !['', 'Reading'].includes(document.getElementById('measured').textContent.split(' ')[0]));
    assert.match(await page.textContent('#measured'), sentence);
  };
  writeFileSync(join(work, 'large.csv'), Buffer.alloc(50e6, '1,2\n'));
  await page.setInputFiles('#csv', join(work, 'large.csv'));
  await page.waitForFunction(() => /50\.0 MB; this page reads up to 20 MB/.test(document.getElementById('measured').textContent));
  await told('picture.csv', Buffer.from('\x89PNG\r\n\x1a\n123456', 'latin1'), /a picture/);
  await told('empty.csv', Buffer.from('\n'), /empty/);
  await told('words.csv', Buffer.from('a,b\nc,d\ne,f\n'), /./);
  await told('utf16.csv', Buffer.from('\ufeff' + curveOf(1e-3, 'elastic'), 'utf16le'), /points of loading/);
  await closed(page);
});

test('without WebAssembly, without JavaScript: a sentence', async () => {
  const context = await browser.newContext();
  await context.addInitScript(() => { delete globalThis.WebAssembly; });
  const page = await context.newPage();
  await page.goto(server.url);
  await page.waitForFunction(() => /WebAssembly/.test(document.getElementById('sentence').textContent));
  await context.close();
  const plain = await opened({ javaScriptEnabled: false });
  assert.match(await plain.textContent('noscript'), /needs JavaScript/);
  await plain.context().close();
});

test('offline after the first visit', async () => {
  const own = await serve(folder);
  const context = await browser.newContext();
  const page = await context.newPage();
  await page.goto(own.url);
  await drawn(page);
  await page.evaluate(() => navigator.serviceWorker.ready);
  await page.waitForFunction(async () => { for (const name of await caches.keys()) if ((await (await caches.open(name)).keys()).length > 8) return true; return false; });
  await page.click('#skip');
  await insideOf(page);
  await page.waitForFunction(async () => { for (const name of await caches.keys()) for (const { url } of await (await caches.open(name)).keys()) if (url.endsWith('zones.gz')) return true; return false; });
  own.close();
  await context.setOffline(true);
  await page.reload();
  await drawn(page);
  await insideOf(page);
  await context.close();
});

test('size', () => {
  const size = statSync(join(folder, 'explorer.wasm')).size;
  console.log(`    explorer.wasm ${(size / 1e6).toFixed(2)} MB, catalogue ${(statSync(join(folder, 'catalogue.gz')).size / 1e6).toFixed(2)} MB`);
  assert.ok(size <= 1e6);
});

// Measured, not asked for here: machines differ. From the slider's event to the curve in the document.
test('speed (printed)', { timeout: 120000 }, async () => {
  const first = await opened();
  await drawn(first);
  const start = await first.evaluate(() => performance.getEntriesByName('first curve')[0].startTime);
  console.log(`    first curve ${start.toFixed(0)} ms after opening`);
  await closed(first);
  for (const [what, model, key] of [['metal', 'von-mises', 'sigma_y_Pa'], ['metal that hardens', 'ludwik', 'sigma_y_Pa'], ['granule', 'vmdc', 'sigma_y_Pa'],
    ['granule, another material each time', 'vmdc', 'E_bar'], ['rock', 'rock', 'sigma_c_Pa']]) {
    const card = { ...initial(), model, name: 'x', values: Object.fromEntries(allOf(model).map((p) => [p.key, p.start])), beside: models[model].beside };
    const page = await opened({ hash: toLink(card) });
    await page.waitForSelector('[data-ready]', { state: 'attached', timeout: 60000 });
    const times = await page.evaluate(async (key) => {
      const slider = document.getElementById(`f-${key}-slider`), root = document.documentElement, times = [];
      const from = Number(slider.value);
      for (let i = 0; i < 150; ++i) {
        const seen = root.dataset.revision;
        const done = new Promise((resolve) => { const o = new MutationObserver(() => { if (root.dataset.revision !== seen) o.disconnect(), resolve(performance.now()); }); o.observe(root, { attributes: true }); });
        slider.value = from + ((i * 7) % 40) - 20;
        const start = performance.now();
        slider.dispatchEvent(new Event('input', { bubbles: true }));
        times.push(await done - start);
        await new Promise((resolve) => setTimeout(resolve, 17));
      }
      return times.sort((a, b) => a - b);
    }, key);
    console.log(`    ${what}: slider to curve ${times[75].toFixed(1)} ms median, ${times[142].toFixed(1)} ms at 95 %`);
    await closed(page);
  }
});
