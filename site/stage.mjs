// Assembles what the site is made of: docs/ as it is, and the pages that the program prints.
// node site/stage.mjs PLATEN_PROGRAM FOLDER
import { execFile, execFileSync } from 'node:child_process'
import { promisify } from 'node:util'
import { cpSync, existsSync, mkdirSync, readFileSync, readdirSync, rmSync, statSync, symlinkSync, writeFileSync } from 'node:fs'
import { basename, dirname, extname, join, posix, resolve } from 'node:path'
import { fileURLToPath } from 'node:url'
import { gallery } from './gallery.mjs'
import { sections } from './.vitepress/sidebar.mjs'

const run = promisify(execFile)
const root = resolve(dirname(fileURLToPath(import.meta.url)), '..')
const program = resolve(process.argv[2])
const out = resolve(process.argv[3])
const picture = /\.(svg|png|webp|mp4)$/
const language = { '.hpp': 'cpp', '.h': 'c', '.lmp': 'text', '.sh': 'sh', '.csv': 'text', '.py': 'python', '.toml': 'toml', '.c': 'c', '.cpp': 'cpp' }

export const print = (...words) =>
  execFileSync(program, words, { encoding: 'utf8', maxBuffer: 1 << 26, stdio: ['ignore', 'pipe', 'ignore'],
                                 env: { ...process.env, PLATEN_CATALOGUE: join(root, 'catalogue'), COLUMNS: '100' } })
const write = (path, text) => {
  mkdirSync(dirname(join(out, path)), { recursive: true })
  writeFileSync(join(out, path), text)
}
const read = path => readFileSync(join(root, path), 'utf8')
const block = (text, kind = 'text') => '````' + kind + '\n' + text.trimEnd() + '\n````\n'

// --- files of the repository, and where they stand in the site ---

const ours = path => path.startsWith('docs/') && (path.endsWith('.md') || picture.test(path)) // a page; else a file that a page shows
const staged = path => {
  if (path === 'README.md' || path === 'site/start.md') return 'index.md'
  if (['CHANGELOG.md', 'CONTRIBUTING.md'].includes(path)) return path.toLowerCase()
  const name = ours(path) ? path.slice(5) : 'source/' + path
  if (picture.test(name)) return name
  if (!name.endsWith('.md')) return name + '.md'
  return name.replace(/(^|\/)README\.md$/, '$1index.md')
}

const waiting = [] // files that a page links to: they become pages too
const known = new Set()
const want = path => { if (!known.has(path)) known.add(path), waiting.push(path) }

// Links between files become links between pages; what stands in code stays.
const relink = (text, path) => {
  let fenced = false
  return text.split('\n').map(line => {
    if (/^\s*(```|~~~)/.test(line)) fenced = !fenced
    if (fenced) return line
    return line.replace(/\]\(([^)\s]+)\)/g, (all, target) => {
      if (/^([a-z]+:|#|\/)/.test(target)) return all
      const [file, anchor] = target.split('#')
      const from = posix.normalize(posix.join(posix.dirname(path), file))
      if (!existsSync(join(root, from))) throw new Error(`${path} links to ${target}, which is not there`)
      if (statSync(join(root, from)).isDirectory()) throw new Error(`${path} links to ${target}, which is a folder`)
      if (from !== 'README.md') want(from)
      let to = posix.relative(posix.dirname(staged(path)), staged(from))
      if (!to.startsWith('.')) to = './' + to
      return `](${to}${anchor ? '#' + anchor : ''})`
    })
  }).join('\n')
}

const notebook = path => JSON.parse(read(path)).cells.map(cell => {
  const text = [].concat(cell.source).join('')
  return cell.cell_type === 'markdown' ? text : block(text, 'python')
}).join('\n\n')

const stage = path => {
  const to = staged(path)
  if (picture.test(path)) return void (mkdirSync(dirname(join(out, to)), { recursive: true }), cpSync(join(root, path), join(out, to)))
  const outside = !ours(path) && !/^(CHANGELOG|CONTRIBUTING)/.test(path)
  const head = `---\nfrom: ${path}\n${outside ? 'search: false\n' : ''}---\n\n`
  if (path.endsWith('.md')) return write(to, head + relink(read(path), path) + (after[path]?.() ?? ''))
  if (path.endsWith('.ipynb')) return write(to, head + notebook(path))
  write(to, head + `# ${basename(path)}\n\n\`${path}\`\n\n` + block(read(path), language[extname(path)] ?? 'text'))
}

// --- what the program prints ---

const words = text => text.split('\n').filter(Boolean).map(line => line.trim().split(/\s+/)[0])
const lawNames = words(print('laws'))
const pictures = law => gallery.filter(one => one.laws?.includes(law)).map(one =>
  `![${one.title}](../gallery/${one.picture})\n\n*${one.title}*: [how it is made](../gallery.md#${one.name})\n`).join('\n')

const after = Object.fromEntries(lawNames.filter(law => existsSync(join(root, `docs/laws/${law}.md`))).map(law =>
  [`docs/laws/${law}.md`, () => `\n\n## Parameters\n\nPrinted by \`platen laws ${law}\`.\n\n${block(print('laws', law))}\n` +
    (pictures(law) ? `## Pictures\n\n${pictures(law)}` : '')]))

const commands = print().split('\n').map(line => line.match(/^ {2}platen (\S+) {2,}(.*)/)).filter(Boolean)
const inner = help => help.includes('\nSubcommands:') ? words(help.split('\nSubcommands:\n')[1].split('\n\n')[0]) : []

const reference = () => {
  writeFileSync(join(out, '../commands.json'), JSON.stringify(commands.map(([, name]) => name)))
  for (const [name, ...command] of [['material-card', 'materials'], ['case-card', 'press'], ['study-card', 'study', 'design']])
    write(`reference/${name}.md`, `Printed by \`platen ${command.join(' ')} --keys\`.\n\n`.replace(/^/, print(...command, '--keys').split('\n')[0] + '\n\n') +
      print(...command, '--keys').split('\n').slice(1).join('\n').replace(/^# /gm, '## '))
  const list = [`# Commands\n\nPrinted by \`platen\` and \`platen COMMAND --help\`.\n`, '| command | what it does |', '|---|---|']
  for (const [, name, what] of commands) {
    const help = print(name, '--help')
    const page = [`# platen ${name}\n`, what[0].toUpperCase() + what.slice(1) + '.\n', block(help)]
    for (const sub of inner(help)) page.push(`## platen ${name} ${sub}\n`, block(print(name, sub, '--help')))
    write(`reference/commands/${name}.md`, page.join('\n'))
    list.push(`| [\`platen ${name}\`](commands/${name}.md) | ${what} |`)
  }
  write('reference/commands.md', list.join('\n') + '\n')
  write('reference/cpp.md', `# C++\n\nThe laws are headers that need the standard library alone. Ten lines:\n\n` +
    block(read('tests/downstream/law/ten_lines.cpp'), 'cpp') +
    `\nAfter \`cmake --install\`: \`find_package(platen)\` and the target \`platen::law\`, or \`pkg-config platen\`; \`add_subdirectory\` and FetchContent give the same target.\n` +
    `\n## What every law has\n\nThe interface, \`platen/law/contact.hpp\`:\n\n` + block(read('include/platen/law/contact.hpp'), 'cpp') +
    `\n## All headers\n\n| header | first line |\n|---|---|\n` +
    readdirSync(join(root, 'include/platen/law')).map(name => {
      const comment = read('include/platen/law/' + name).match(/^\/\/+ ?(.*)/m)?.[1] ?? ''
      return `| \`platen/law/${name}\` | ${comment.replaceAll('|', '\\|').replaceAll('<', '&lt;').replaceAll('{', '&#123;')} |`
    }).join('\n') + '\n')
  write('reference/c.md', `# C\n\nTen lines:\n\n` + block(read('tests/downstream/law/ten_lines.c'), 'c') +
    `\nLink with \`platen::law_c\` of CMake, or \`pkg-config platen\`.\n\n## The header\n\n` + block(read('include/platen_law.h'), 'c'))
}

const papers = () => {
  print('reproduce', 'all', '-o', join(out, 'public/papers'))
  const page = readFileSync(join(out, 'public/papers/index.html'), 'utf8')
  writeFileSync(join(out, 'public/papers/index.html'), page.replace('<main>', '<main>\n<p><a href="../papers.html">Platen: documentation</a></p>'))
  const table = page.match(/<div class="wide"[^>]*>(<table>.*?<\/table>)<\/div>/s)[1].replaceAll('href="#', 'target="_self" href="./papers/index.html#')
  write('papers.md', `---\nfrom: docs/explanation/papers.md\n---\n\n# The papers, reproduced\n\nEvery figure and table of three papers that holds a result, beside what Platen says: ` +
    `with verdicts computed from the numbers, pictures, and the numbers as CSV.\n\n<p><a class="big" href="./papers/index.html" target="_self">Open the page: all figures and tables</a></p>\n\n` +
    table + `\n\nMade by\n\n\`\`\`sh\nplaten reproduce all -o out/papers\n\`\`\`\n\nHow a verdict comes about, and what does not agree: [about this page](explanation/papers.md).\n`)
}

// Two at a time: each command is run once, however many pictures it makes.
const runGallery = async made => {
  rmSync(made, { recursive: true, force: true })
  const folders = new Map()
  for (const one of gallery) if (!one.file && !folders.has(one.command.join('\n'))) folders.set(one.command.join('\n'), join(made, one.name))
  const left = [...folders]
  const work = async () => {
    for (let next; (next = left.shift());) {
      const [commands, folder] = next
      mkdirSync(folder, { recursive: true })
      await run('bash', ['-euc', 'platen() { "$PLATEN" "$@"; }\n' + commands], { cwd: root, maxBuffer: 1 << 26,
        env: { ...process.env, PLATEN: program, OUT: folder, PLATEN_CATALOGUE: join(root, 'catalogue'), OPENBLAS_NUM_THREADS: '1' } })
    }
  }
  await Promise.all([work(), work()])
  return folders
}

const galleryPage = folders => {
  const page = ['# Gallery\n', 'Each picture is made by the command under it, most of them while this site is built. `platen` is the program of `./run build`; scripts run from the folder of the repository.\n']
  for (const one of gallery) {
    cpSync(one.file ? join(root, one.file) : join(folders.get(one.command.join('\n')), one.made), join(out, 'gallery', one.picture))
    page.push(`## ${one.title} {#${one.name}}\n`, one.words + '\n', `![${one.title}](./gallery/${one.picture})\n`,
      block(one.command.join('\n').replaceAll('"$PLATEN"', 'build/release/bin/platen').replaceAll('$OUT', `out/${one.name}`), 'sh'))
    if (one.laws) page.push('Laws: ' + one.laws.map(law => `[${law}](laws/${law}.md)`).join(', ') + '\n')
  }
  write('gallery.md', page.join('\n'))
}

const contents = () => write('contents.md', ['# All pages\n', ...sections().flatMap(section => [`## ${section.text}\n`,
  section.items.map(([text, path]) => `- [${text}](./${path}.md)`).join('\n') + '\n'])].join('\n'))

// --- all of it ---

rmSync(out, { recursive: true, force: true })
mkdirSync(out, { recursive: true })
rmSync(join(out, '../node_modules'), { force: true })
symlinkSync(join(root, 'site/node_modules'), join(out, '../node_modules')) // pages look for vue upwards from where they lie
const walk = folder => readdirSync(join(root, folder), { withFileTypes: true }).flatMap(entry =>
  entry.isDirectory() ? walk(`${folder}/${entry.name}`) : [`${folder}/${entry.name}`])
for (const path of walk('docs')) if (path.endsWith('.md') || picture.test(path)) want(path)
want('CHANGELOG.md'), want('CONTRIBUTING.md')
const pressed = runGallery(join(out, '../gallery'))
while (waiting.length) stage(waiting.shift())
reference()
papers()
contents()
galleryPage(await pressed)
mkdirSync(join(out, 'public'), { recursive: true })
cpSync(join(root, 'site/icon.svg'), join(out, 'public/icon.svg'))
const explorer = join(out, '../explorer')
const start = relink(read('site/start.md'), 'site/start.md')
  .replace('<!-- version -->', `These pages are of Platen ${read('CMakeLists.txt').match(/project\(platen VERSION ([0-9.]+)/)[1]}.`)
if (existsSync(explorer)) {
  cpSync(explorer, join(out, 'public/explorer'), { recursive: true })
  write('index.md', start.replace('<!-- explorer -->', '<p><a class="big" href="./explorer/index.html" target="_self">Move a slider: the explorer</a></p>'))
} else write('index.md', start.replace('<!-- explorer -->', ''))
