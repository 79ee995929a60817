import { nextTick } from 'vue'
import Theme from 'vitepress/theme-without-fonts'
import './style.css'

// The head of a group in the sidebar is a button, and its arrow another one within it, which a screen reader cannot use.
const calmArrows = () => document.querySelectorAll('.VPSidebarItem .caret').forEach(arrow => {
  arrow.removeAttribute('role')
  arrow.removeAttribute('tabindex')
  arrow.setAttribute('aria-hidden', 'true')
})

export default {
  extends: Theme,
  enhanceApp({ router }) {
    if (import.meta.env.SSR) return
    router.onAfterRouteChanged = () => nextTick(calmArrows)
    addEventListener('DOMContentLoaded', () => setTimeout(calmArrows))
    setTimeout(calmArrows)
  },
}
