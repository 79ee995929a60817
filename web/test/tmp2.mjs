import { chromium } from 'playwright-core';
import { readFileSync, writeFileSync } from 'node:fs';
import { serve } from './server.mjs';
const out='/tmp/w-web-tools/shots';
const server = await serve('/tmp/w-web/build/web/page');
const browser = await chromium.launch({ executablePath: '/usr/bin/chromium', args: ['--no-sandbox'] });
const page = await browser.newPage({ viewport: { width: 1440, height: 1000 }, acceptDownloads: true });
page.on('pageerror', (e) => console.log(String(e)));
await page.goto(server.url); await page.waitForSelector('[data-revision]'); await page.click('#skip');
await page.waitForTimeout(400);
await page.check('input[value=von-mises]'); await page.waitForTimeout(600);
for (const l of ['thornton-ning','kogut-etsion','jackson-green','mdr','agarwal']) { await page.check(`#laws input[value=${l}]`); await page.waitForTimeout(400); }
let csv='delta_m,force_N\n'; for(let i=0;i<60;++i){const x=i/60*0.3; csv+=`${x*5e-4},${(1.05*0.78*x**1.02*3.2*100).toFixed(4)}\n`;}
await page.setInputFiles('#csv', { name: 'own.csv', mimeType: 'text/csv', buffer: Buffer.from(csv) });
await page.waitForTimeout(800);
await page.screenshot({ path: out+'/metal.png', fullPage: true });
const [svg] = await Promise.all([page.waitForEvent('download'), page.click('[data-file=svg]')]); writeFileSync(out+'/export.svg', readFileSync(await svg.path()));
const [png] = await Promise.all([page.waitForEvent('download'), page.click('[data-file=png]')]); writeFileSync(out+'/export.png', readFileSync(await png.path()));
await page.click('#fit'); await page.waitForTimeout(2500); console.log(await page.textContent('#measured'));
await page.fill('#f-nu','0.1'); await page.press('#f-nu','Enter');
await page.fill('#f-E_Pa','plenty'); await page.press('#f-E_Pa','Enter'); await page.waitForTimeout(600);
await page.screenshot({ path: out+'/edge.png' });
await page.check('input[value=vmdc]'); await page.waitForTimeout(300);
await page.fill('#f-Gamma_bar','1.9'); await page.press('#f-Gamma_bar','Enter'); await page.waitForTimeout(800);
await page.screenshot({ path: out+'/outside.png' }); console.log(await page.textContent('#verdict'));
await page.goto(server.url+'#v=2'); await page.reload(); await page.waitForTimeout(900); await page.screenshot({ path: out+'/broken.png' });
await browser.close(); server.close();
