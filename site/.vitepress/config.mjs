import { existsSync, readFileSync } from 'node:fs'
import { defineConfig } from 'vitepress'
import { sections } from './sidebar.mjs'
import { editLink, versionsIn } from '../publish.mjs'
import { scripts } from '../scripts.mjs'
import { slugify } from '../slug.mjs'

const root = new URL('../../', import.meta.url)
const text = name => readFileSync(new URL(name, root), 'utf8')
const version = text('CMakeLists.txt').match(/project\(platen VERSION ([0-9.]+)/)[1]
const repository = process.env.PLATEN_REPOSITORY ?? text('CITATION.cff').match(/^repository-code: *"?([^"\n]+)/m)?.[1]
const source = new URL('build/site/src/', root).pathname
const explorer = existsSync(source + 'public/explorer/index.html')
const base = process.env.PLATEN_SITE_BASE ?? '/'
const versions = versionsIn(process.env.PLATEN_SITE_VERSIONS, version)
const page = path => path === 'index' ? '/' : '/' + path.replace(/(^|\/)index$/, '$1')
const first = name => page(sections().find(section => section.text === name).items[0][1])

export default defineConfig({
  title: 'Platen',
  description: 'Force laws of plastic particles for discrete-element simulations, with their error.',
  lang: 'en',
  base,
  srcDir: source,
  outDir: new URL('out/docs/', root).pathname,
  cacheDir: new URL('build/site/cache/', root).pathname,
  head: [['link', { rel: 'icon', type: 'image/svg+xml', href: base + 'icon.svg' }]],
  markdown: { math: true, config: scripts, theme: { light: 'github-light-high-contrast', dark: 'github-dark-high-contrast' }, anchor: { slugify }, headers: { slugify }, toc: { slugify } },
  ignoreDeadLinks: [/papers\/index\.html/, /explorer\//],
  vite: { build: { chunkSizeWarningLimit: 4000 } },
  themeConfig: {
    nav: [
      ...['Tutorials', 'How-to', 'Explanation', 'Laws', 'Reference'].map(name =>
        ({ text: name, link: first(name), activeMatch: `^/${name.toLowerCase()}/` })),
      { text: 'Gallery', link: '/gallery' },
      ...(explorer ? [{ text: 'Explorer', link: '/explorer/index.html', target: '_self' }] : []),
      { text: version, items: [{ text: 'The papers', link: '/papers' }, { text: 'What changed', link: '/changelog' }, { text: 'All pages', link: '/contents' },
        ...(versions.length ? [{ text: 'Other versions', items: versions.map(name => ({ text: name, link: `/../${name}/`, target: '_self' })) }] : [])] },
    ],
    sidebar: sections().map(({ text, items }, at) => ({ text, collapsed: at > 1,
      items: items.map(([text, path]) => ({ text, link: page(path) })) })),
    outline: [2, 3],
    search: { provider: 'local', options: { detailedView: false,
      _render: (markdown, env, md) => {
        const html = md.render(markdown, env)
        return env.frontmatter?.search === false ? '' : html
      },
      miniSearch: { searchOptions: { fuzzy: 0.2, prefix: true, boost: { title: 6, titles: 2, text: 1 },
        // whoever searches wants to do something first
        boostDocument: id => /\/(contents|changelog|contributing|questions)/.test(id) ? 0.3 : /\/(how-to|tutorials)\//.test(id) ? 2 : 1 } } } },
    editLink: editLink(repository),
    externalLinkIcon: true,
    footer: { message: '<a href="' + base + 'contents.html">All pages</a> · BSD-3-Clause' },
  },
})
