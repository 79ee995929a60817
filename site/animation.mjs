// docs/pictures/press.webp: a granule being pressed, its zones beside its curve. Kept in the repository; made anew by
// node site/animation.mjs PLATEN_PROGRAM docs/pictures/press.webp      (img2webp: Debian's package webp; Chromium)
import { execFileSync } from 'node:child_process'
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { chromium } from 'playwright-core'

const [program, target] = process.argv.slice(2)
const work = mkdtempSync(join(tmpdir(), 'press-'))
const frames = 40, at = Array.from({ length: frames }, (_, i) => 0.5 * (i + 1) / frames)
writeFileSync(join(work, 'case.toml'), `platen = 1\nexperiment = "simple"\nmaterial = "base-case"\nradius_m = 1e-3\n[output]\nfields_at = [${at.map(x => x.toFixed(4))}]\n`)
execFileSync(program, ['press', join(work, 'case.toml'), '-o', join(work, 'out')], { stdio: 'ignore' })

const zones = readFileSync(join(work, 'out/zones.svg'), 'utf8')
const captions = [...zones.matchAll(/<text x="([\d.]+)" y="([\d.]+)"[^>]*>δ̄ = ([\d.]+)/g)].map(m => m.slice(1).map(Number))
if (captions.length !== frames) throw new Error(`zones.svg has ${captions.length} panels, not ${frames}`)
const columns = {}
const rows = readFileSync(join(work, 'out/curve.csv'), 'utf8').split('\n').filter(line => line && !line.startsWith('#')).map(line => line.split(','))
rows.shift().forEach((name, i) => { columns[name] = i })
const curve = [[0, 0], ...rows.map(row => [Number(row[columns.delta_bar]), Number(row[columns.F_bar])])]

const x = d => 540 + 380 * d / 0.5, y = F => 340 - 250 * F / 1.75
const path = points => 'M' + points.map(([d, F]) => `${x(d).toFixed(1)} ${y(F).toFixed(1)}`).join('L')
const ink = '#1f2933', grey = '#52606d'
const text = (px, py, words, size = 15, anchor = 'start', fill = ink) => `<text x="${px}" y="${py}" font-size="${size}" text-anchor="${anchor}" fill="${fill}">${words}</text>`
const legend = [['compaction', '#b5283b'], ['shear', '#f6c945'], ['tension', '#7cc07a'], ['elastic', '#3b6fb5']]
const frame = i => {
  const [cx, cy, d] = captions[i]
  const so_far = curve.filter(point => point[0] <= d + 1e-9)
  const here = so_far.at(-1)
  return `<svg xmlns="http://www.w3.org/2000/svg" width="960" height="420" font-family="Helvetica, Arial, 'DejaVu Sans', sans-serif">
    <rect width="960" height="420" fill="#fff"/>
    <svg x="28" y="10" width="402" height="350" viewBox="${cx - 93} ${cy - 178} 186 162">${zones.replace(/^<svg[^>]*>/, '').replace('</svg>', '')}</svg>
    ${legend.map(([name, fill], k) => `<rect x="${[30, 150, 230, 328][k]}" y="376" width="14" height="14" fill="${fill}"/>` + text([30, 150, 230, 328][k] + 20, 388, name)).join('')}
    <path d="M540 80V340H925" fill="none" stroke="${ink}" stroke-width="1.5"/>
    ${[0.1, 0.2, 0.3, 0.4, 0.5].map(v => `<path d="M${x(v)} 340v6" stroke="${ink}"/>` + text(x(v), 362, v, 14, 'middle')).join('')}
    ${[0.5, 1, 1.5].map(v => `<path d="M540 ${y(v)}h-6" stroke="${ink}"/>` + text(528, y(v) + 5, v, 14, 'end')).join('')}
    ${text(732, 390, 'overlap δ/R₀', 15, 'middle', grey)}${text(545, 72, 'force F̄ = F/(πR₀²σ)', 15, 'start', grey)}
    <path d="${path(curve)}" fill="none" stroke="#e3e7eb" stroke-width="2"/>
    <path d="${path(so_far)}" fill="none" stroke="#0072b2" stroke-width="3"/>
    <circle cx="${x(here[0])}" cy="${y(here[1])}" r="6" fill="#0072b2"/></svg>`
}

const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', args: ['--no-sandbox'] })
const page = await browser.newPage({ viewport: { width: 960, height: 420 } })
const files = []
for (let i = 0; i < frames; ++i) {
  await page.setContent(`<body style="margin:0">${frame(i)}</body>`)
  files.push(join(work, `${String(i).padStart(2, '0')}.png`))
  await page.screenshot({ path: files.at(-1) })
}
await browser.close()
execFileSync('img2webp', ['-loop', '0', '-lossy', '-q', '80', '-m', '6', ...files.flatMap((file, i) => ['-d', i === frames - 1 ? '2000' : '100', file]), '-o', target], { stdio: 'ignore' })
rmSync(work, { recursive: true })
