// The built site without a browser: every link and anchor, and every command that the pages name.
// node site/check.mjs FOLDER BASE PLATEN_PROGRAM
import { execFileSync } from 'node:child_process'
import { existsSync, readFileSync, readdirSync, statSync } from 'node:fs'
import { dirname, join, posix, resolve } from 'node:path'
import { fileURLToPath } from 'node:url'
import { sections } from './.vitepress/sidebar.mjs'
import { editLink, versionsIn } from './publish.mjs'
import { slugify } from './slug.mjs'

const root = resolve(dirname(fileURLToPath(import.meta.url)), '..')
const [site, base, program] = process.argv.slice(2)
const faults = []
const listed = () => new Set(sections().flatMap(section => section.items.map(([, path]) => path + '.html')))
const walk = folder => readdirSync(folder, { withFileTypes: true }).flatMap(entry =>
  entry.isDirectory() ? walk(join(folder, entry.name)) : [join(folder, entry.name)])
const unescape = text => text.replaceAll('&amp;', '&').replaceAll('&#39;', "'").replaceAll('&quot;', '"')

// --- links and anchors ---

const files = walk(site).map(file => posix.relative(site, file))
const pages = files.filter(file => file.endsWith('.html'))
const html = new Map(pages.map(page => [page, readFileSync(join(site, page), 'utf8')]))
const ids = new Map([...html].map(([page, text]) => [page, new Set([...text.matchAll(/\s(?:id|name)="([^"]*)"/g)].map(m => unescape(m[1])))]))
const version = readFileSync(join(root, 'CMakeLists.txt'), 'utf8').match(/project\(platen VERSION ([0-9.]+)/)[1]
const versions = versionsIn(process.env.PLATEN_SITE_VERSIONS, version), repository = process.env.PLATEN_REPOSITORY
const seen = new Set() // other versions, by page
let links = 0, edits = 0
for (const [page, text] of html) {
  const body = text.replace(/<script[\s\S]*?<\/script>/g, script => script.match(/^<script[^>]*>/)[0]).replace(/<style[\s\S]*?<\/style>/g, '')
  for (const [, tag, attributes] of body.matchAll(/<([a-z]+)((?:\s+[\w:@-]+(?:="[^"]*")?)*)\s*\/?>/g))
    for (const [, name, raw] of attributes.matchAll(/\s(href|src|srcset)="([^"]*)"/g)) {
      const target = unescape(raw)
      if (/^(data:|mailto:)/.test(target)) continue
      if (/^(https?:)?\/\//.test(target)) {
        if (tag !== 'a') faults.push(`${page}: <${tag}> asks for ${target}`)
        const source = repository && target.startsWith(repository + '/edit/main/') ? target.slice(repository.length + 11) : ''
        if (source && !existsSync(join(root, source))) faults.push(`${page}: ${source}, to be edited, is not there`)
        if (source) ++edits
        continue
      }
      ++links
      const [path, anchor] = target.split('#')
      const other = path.match(/\/\.\.\/([^/]+)\/$/)?.[1]
      if (other && versions.includes(other)) { seen.add(`${page} ${other}`); continue }
      let to = path === '' ? page : path.startsWith('/') ? path : posix.join('/', base, posix.dirname(page), path)
      if (path !== '') {
        if (!to.startsWith(base)) { faults.push(`${page}: ${target} leaves ${base}`); continue }
        to = decodeURIComponent(to.slice(base.length)) || 'index.html'
        if (to.endsWith('/')) to += 'index.html'
      }
      if (!existsSync(join(site, to)) || statSync(join(site, to)).isDirectory()) faults.push(`${page}: ${target} is not there`)
      else if (anchor && ids.has(to) && !ids.get(to).has(decodeURIComponent(anchor))) faults.push(`${page}: ${target} has no such anchor`)
    }
}
for (const file of files.filter(file => file.endsWith('.css')))
  for (const [, target] of readFileSync(join(site, file), 'utf8').matchAll(/url\(["']?(https?:[^)"']*)/g)) faults.push(`${file} asks for ${target}`)

// --- version, other versions, and where a page is edited ---

if (!html.get('index.html').includes(`Platen ${version}`)) faults.push('index.html does not say its version')
for (const page of listed()) for (const name of versions) if (!seen.has(`${page} ${name}`)) faults.push(`${page}: no link to version ${name}`)
if (repository ? edits < 50 : [...html.values()].some(text => text.includes('Edit this page'))) faults.push(`${edits} links to edit a page, of repository ${repository}`)
if (editLink(undefined) || versionsIn(undefined).length) faults.push('links where nothing is known')

// --- pages: each is in the list of pages, and each of the list is there ---

for (const page of listed()) if (!html.has(page)) faults.push(`${page} is in the list of pages and was not built`)
for (const page of pages)
  if (!listed().has(page) && !/^(404|contents|papers\/index)\.html$|^(source|explorer)\//.test(page)) faults.push(`${page} is in no list of pages`)

// --- commands ---

const help = new Map()
const ask = words => {
  const key = words.join(' ')
  if (!help.has(key)) {
    try { help.set(key, execFileSync(program, [...words, '--help'], { encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] })) }
    catch { help.set(key, null) }
  }
  return help.get(key)
}
const names = new Set(execFileSync(program, { encoding: 'utf8' }).split('\n').map(line => line.match(/^ {2}platen (\S+) /)?.[1]).filter(Boolean))
let commands = 0
const checkCommand = (line, where) => {
  const words = line.split(/\s+(?:\||>|2>|&&|#|;)/)[0].trim().split(/\s+/)
  const [first, second] = words
  if (!first || /^[A-Z.…<-]/.test(first)) return
  ++commands
  if (!names.has(first)) return void faults.push(`${where}: there is no command platen ${first}`)
  const top = ask([first])
  const inner = top.includes('\nSubcommands:') && second && /^[a-z][a-z-]*$/.test(second) ? [first, second] : [first]
  const text = ask(inner)
  if (!text || (inner.length === 2 && !top.match(new RegExp(`^  ${second} `, 'm')))) return void faults.push(`${where}: there is no command platen ${inner.join(' ')}`)
  for (const word of words.slice(inner.length)) {
    const option = word.replace(/^[["'(]+/, '').match(/^--?[A-Za-z][\w-]*/)?.[0]
    // a value that carries its unit needs none in the name: --E "2 GPa" is --E_Pa
    if (option && !new RegExp(`(^|[\\s,])${option}(_(Pa|m|N|s|m_per_N))?(?![\\w-])`, 'm').test(text.split('\nExample')[0])) faults.push(`${where}: platen ${inner.join(' ')} has no option ${option}`)
  }
}
const runs = new Set([...readFileSync(join(root, 'run'), 'utf8').matchAll(/^([a-z-]+)\) /gm)].map(m => m[1]))
const documents = ['README.md', 'CONTRIBUTING.md', 'examples/README.md', 'catalogue/pools/README.md', 'site/start.md',
  ...walk(join(root, 'docs')).filter(file => file.endsWith('.md')).map(file => posix.relative(root, file))]
for (const document of documents) {
  let fence = null
  readFileSync(join(root, document), 'utf8').replaceAll('\\\n', ' ').split('\n').forEach((line, at) => {
    const where = `${document}:${at + 1}`
    const mark = line.match(/^\s*(```+)(\w*)/)
    if (mark) return void (fence = fence === null ? mark[2] : null)
    const code = fence === null ? [...line.matchAll(/`([^`]+)`/g)].map(m => m[1]) : fence === 'text' ? [] : [line]
    for (const piece of code) {
      const command = piece.match(/(?:^\s*|\|\s*|\$ |-I\{\} |-N0 )(?:\$platen|(?:[\w./]+\/)?platen)\s+([a-z].*)/)
      if (command && !/^\s*(import|include|#include|fix|pair_)/.test(piece) && !/^=|^\w+\s*[:=]/.test(command[1])) checkCommand(command[1], where)
      for (const [, name] of piece.matchAll(/(?:^|\s)\.\/run ([a-z-]+)/g)) { ++commands; if (!runs.has(name)) faults.push(`${where}: ./run has no command ${name}`) }
    }
  })
}

// --- links of the Markdown itself, as a forge follows them ---

const anchors = new Map()
const anchorsOf = file => {
  if (!anchors.has(file)) anchors.set(file, new Set([...readFileSync(join(root, file), 'utf8').matchAll(/^#+ (.*)$/gm)].map(m => slugify(m[1].replace(/`|\[|\]\([^)]*\)|\*/g, '')))))
  return anchors.get(file)
}
let forge = 0
for (const document of [...documents.filter(file => file !== 'site/start.md'), 'CHANGELOG.md', 'plugins/yade/README.md', 'site/README.md', 'src/press/alternatives.md', 'src/surrogate/alternatives.md', 'bench/peers/README.md'])
  for (const [, target] of readFileSync(join(root, document), 'utf8').replace(/^\s*```[\s\S]*?^\s*```/gm, '').matchAll(/\]\(([^)\s]+)\)/g)) {
    if (/^[a-z]+:/.test(target)) continue
    ++forge
    const [path, anchor] = target.split('#')
    const file = path ? posix.normalize(posix.join(posix.dirname(document), path)) : document
    if (!existsSync(join(root, file))) faults.push(`${document}: ${target} is not there`)
    else if (anchor && !anchorsOf(file).has(anchor)) faults.push(`${document}: ${target} has no such heading`)
  }

// --- what the pages promise ---

const questions = readFileSync(join(root, 'docs/questions.md'), 'utf8').match(/^\d+\. .*$/gm)
if (questions.length !== 30) faults.push(`docs/questions.md has ${questions.length} questions, not 30`)
for (const question of questions) if (!/\]\([^)]+\.md[^)]*\)/.test(question)) faults.push(`docs/questions.md: no answer to: ${question}`)
const tests = walk(join(root, 'tests')).filter(file => /_test\.cpp$/.test(file)).map(file => readFileSync(file, 'utf8')).join('\n')
const named = [...readFileSync(join(root, 'docs/explanation/what-was-measured.md'), 'utf8').matchAll(/`([A-Z]\w+)\.(\w+)`/g)]
for (const [, suite, name] of named)
  if (!new RegExp(`TEST(_[FP])?\\(\\s*${suite},\\s*${name}\\)`).test(tests)) faults.push(`what-was-measured.md names the test ${suite}.${name}, which is not there`)

for (const fault of faults.slice(0, 50)) console.error(`site: ${fault}`)
if (!links || !commands || !named.length) console.error('site: nothing was checked'), process.exit(2)
console.log(`site: ${pages.length} pages, ${links} links, ${edits} to edit, ${seen.size} to other versions, ${forge} links of the Markdown, ${commands} commands, ${questions.length} questions, ${named.length} tests named; ${faults.length} faults`)
process.exit(faults.length ? 2 : 0)
