// σ_y, F_max and e^(−x) of the pages' running text as subscripts and superscripts; code and headings stay as they are.
const mark = /(?<![A-Za-z_])(\p{L}[\u0304\u0305]?)_(\p{L}{1,6}|\d)(?![\p{L}_])|\^\(([^()]{1,24})\)|(?<=[\p{L}\d)])\^([\p{L}\d]{1,3})(?![\p{L}\d])/gu

export const scripts = md => md.core.ruler.push('scripts', state => {
  state.tokens.forEach((token, at) => {
    if (token.type !== 'inline' || state.tokens[at - 1]?.type === 'heading_open') return
    token.children = token.children.flatMap(child => {
      if (child.type !== 'text' || !/[_^]/.test(child.content)) return [child]
      const made = []
      const add = (type, content) => { if (content) { const one = new state.Token(type, '', 0); one.content = content; one.level = child.level; made.push(one) } }
      let from = 0
      for (const found of child.content.matchAll(mark)) {
        const [all, base, below, above, high] = found
        add('text', child.content.slice(from, found.index) + (base ?? ''))
        add('html_inline', below ? `<sub>${below}</sub>` : `<sup>${above ?? high}</sup>`)
        from = found.index + all.length
      }
      add('text', child.content.slice(from))
      return made
    })
  })
})
