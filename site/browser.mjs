// The built site in Chromium. node site/browser.mjs FOLDER BASE
// Widths of a phone, a small window and a large one; no console error, no request to elsewhere, no sideways scroll, nothing
// serious for axe, search, dark mode, copy buttons, and a site that can be read without JavaScript.
import { createReadStream, existsSync, readFileSync, readdirSync, statSync } from 'node:fs'
import { createServer } from 'node:http'
import { createRequire } from 'node:module'
import { extname, join, normalize } from 'node:path'
import { chromium } from 'playwright-core'

const [site, base] = process.argv.slice(2)
const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8')
const searches = JSON.parse(readFileSync(new URL('./searches.json', import.meta.url), 'utf8'))
const faults = []
const fault = text => { if (!faults.includes(text)) faults.push(text) }

// A plain static server, below a path of its own.
const kinds = { '.html': 'text/html', '.js': 'text/javascript', '.css': 'text/css', '.svg': 'image/svg+xml', '.json': 'application/json', '.png': 'image/png', '.csv': 'text/csv', '.wasm': 'application/wasm' }
const server = createServer((request, response) => {
  const path = decodeURIComponent(new URL(request.url, 'http://here').pathname)
  let file = path.startsWith(base) ? join(site, normalize(path.slice(base.length))) : ''
  if (file && existsSync(file) && statSync(file).isDirectory()) file = join(file, 'index.html')
  if (!file || !existsSync(file)) return response.writeHead(404, { 'content-type': 'text/html' }).end(readFileSync(join(site, '404.html')))
  response.writeHead(200, { 'content-type': kinds[extname(file)] ?? 'application/octet-stream' })
  createReadStream(file).pipe(response)
}).listen(0, '127.0.0.1')
await new Promise(ready => server.on('listening', ready))
const home = `http://127.0.0.1:${server.address().port}`
const at = path => home + base + path

const walk = folder => readdirSync(join(site, folder), { withFileTypes: true }).flatMap(entry =>
  entry.isDirectory() ? walk(folder + entry.name + '/') : [folder + entry.name])
const pages = walk('').filter(path => path.endsWith('.html') && !path.startsWith('explorer/') && path !== '404.html')
const types = ['index', 'tutorials/first-law', 'how-to/lammps', 'explanation/what-was-measured', 'laws/shahin', 'laws/which-law',
  'reference/commands/study', 'reference/material-card', 'reference/cpp', 'notation', 'questions', 'contents', 'papers', 'papers/index', 'gallery',
  'source/examples/study.toml'].map(name => name + '.html')

process.on('uncaughtException', error => { for (const one of faults.slice(0, 50)) console.error(`site: ${one}`); console.error(error); process.exit(2) })
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', args: ['--no-sandbox'] })
const open = async options => {
  const context = await browser.newContext(options)
  const page = await context.newPage()
  page.on('console', message => { if (message.type() === 'error') fault(`${page.url()}: console: ${message.text()}`) })
  page.on('pageerror', error => fault(`${page.url()}: ${error}`))
  page.on('request', request => { if (!/^(data|blob):/.test(request.url()) && !request.url().startsWith(home + base)) fault(`${page.url()} asks for ${request.url()}`) })
  page.on('response', response => { if (response.status() >= 400) fault(`${page.url()}: ${response.status()} for ${response.url()}`) })
  return page
}
const go = (page, path) => page.goto(at(path), { waitUntil: 'load' })
let loads = 0

// A phone sees every page, the others each type of page; axe looks by day on the phone and by night on the large screen.
const looks = [[390, 'light', pages.filter((_, i) => i % 2)], [390, 'light', pages.filter((_, i) => !(i % 2))], [1024, 'light', types], [1920, 'dark', types]]
const look = async (width, colorScheme, paths) => {
  const page = await open({ viewport: { width, height: 900 }, colorScheme })
  for (const path of paths) {
    await go(page, path)
    ++loads
    if (!(await page.locator('h1, h2').first().isVisible())) fault(`${path}: no heading`)
    const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)
    if (wide > 0) fault(`${path}: ${wide} pixels wider than a window of ${width}`)
    if (!types.includes(path) || width === 1024) continue
    await page.evaluate(axe)
    const { violations } = await page.evaluate(() => globalThis.axe.run(document, { resultTypes: ['violations'] }))
    for (const one of violations) if (['serious', 'critical'].includes(one.impact))
      fault(`${path} (${width}, ${colorScheme}): axe: ${one.help}: ${one.nodes.slice(0, 3).map(node => node.html.slice(0, 160)).join(' | ')}`)
  }
  await page.context().close()
}
await Promise.all(looks.map(one => look(...one)))

const page = await open({ viewport: { width: 1600, height: 900 }, permissions: ['clipboard-read', 'clipboard-write'] })
await go(page, 'index.html')
for (const [words, wanted] of searches) {
  for (let tries = 0; tries < 20 && !(await page.locator('.search-input').count()); ++tries) { // until the page listens
    await page.keyboard.press('Control+k')
    await page.waitForTimeout(200)
  }
  await page.locator('.search-input').fill(words)
  await page.waitForTimeout(150)
  await page.locator('.results .result').first().waitFor({ timeout: 5000 }).catch(() => {})
  await page.waitForTimeout(250)
  const found = await page.locator('.results .result').evaluateAll(all => all.map(one => new URL(one.href).pathname))
  const first = [...found].slice(0, 3).map(path => path.slice(base.length))
  if (!first.some(path => path === wanted)) fault(`search: "${words}" finds ${first.join(', ') || 'nothing'}, not ${wanted}`)
  await page.keyboard.press('Escape')
}
await go(page, 'tutorials/first-law.html')
await page.locator('.vp-doc button.copy').first().click()
if (!(await page.evaluate(() => navigator.clipboard.readText())).includes('./run build')) fault('the copy button copies something else')
await page.locator('.VPNavBarAppearance button').click()
if (!(await page.evaluate(() => document.documentElement.classList.contains('dark')))) fault('the switch does not darken')
if (!(await page.locator('.pager-link.next').getAttribute('href'))) fault('no next page')
await page.context().close()

const plain = await open({ viewport: { width: 390, height: 900 }, javaScriptEnabled: false })
for (const path of types) {
  await go(plain, path)
  if ((await plain.locator('main').innerText()).length < 200) fault(`${path}: not readable without JavaScript`)
  if (!path.startsWith('papers/') && !(await plain.locator('a[href$="contents.html"]').count())) fault(`${path}: without JavaScript there is no way to the other pages`)
}
await browser.close()
server.close()
for (const one of faults.slice(0, 50)) console.error(`site: ${one}`)
console.log(`site: ${loads} pages loaded, ${searches.length} searches; ${faults.length} faults`)
process.exit(faults.length ? 2 : 0)
