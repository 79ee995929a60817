// What depends on where the site is published: links to its source, and to other versions beside it.
import { existsSync, readdirSync } from 'node:fs'
import { join } from 'node:path'

/// Of VitePress: the page in the repository, https://…; nothing where that is not known. VitePress carries the text of the
/// function into the page, so that it must know the repository without what stands around it.
export const editLink = repository => repository && { text: 'Edit this page', pattern: Function('page',
  `return ${JSON.stringify(repository)} + (page.frontmatter.from ? '/edit/main/' + page.frontmatter.from : '/tree/main/site')`) }

/// Other versions: folders with a site beside the one in which this site will lie, the newest first.
export const versionsIn = (folder, own) => (folder ? readdirSync(folder) : [])
  .filter(name => /^\d+(\.\d+)+$/.test(name) && name !== own && existsSync(join(folder, name, 'index.html')))
  .sort((a, b) => b.localeCompare(a, 'en', { numeric: true }))
