import { chromium } from 'playwright-core';
import { serve } from './server.mjs';
const server = await serve('/tmp/w-web-tools/pg');
const browser = await chromium.launch({ executablePath: '/usr/bin/chromium', args: ['--no-sandbox'] });
const page = await browser.newPage();
await page.goto(server.url);
await page.waitForSelector('[data-ready]', { state: 'attached' });
const r = await page.evaluate(async () => {
  const slider = document.getElementById('f-sigma_y_Pa-slider'), root = document.documentElement, times = [];
  const from = Number(slider.value); globalThis.T=[];
  for (let i = 0; i < 150; ++i) {
    const seen = root.dataset.revision;
    const done = new Promise((resolve) => { const o = new MutationObserver(() => { if (root.dataset.revision !== seen) o.disconnect(), resolve(performance.now()); }); o.observe(root, { attributes: true }); });
    slider.value = from + ((i * 7) % 40) - 20;
    const start = performance.now();
    slider.dispatchEvent(new Event('input', { bubbles: true }));
    times.push(await done - start);
    await new Promise((resolve) => setTimeout(resolve, 17));
  }
  const q=(l)=>{l=[...l].sort((a,b)=>a-b); return [l[75],l[142]].map(x=>x.toFixed(1)).join(' ')};
  return 'all '+q(times)+' worker '+q(T.map(t=>t[0]))+' draw '+q(T.map(t=>t[1]));
});
console.log(r);
await browser.close(); server.close();
