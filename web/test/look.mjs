// Screenshots: node look.mjs PAGE_FOLDER OUT_DIR
import { chromium } from 'playwright-core';
import { serve } from './server.mjs';
const [folder, out] = process.argv.slice(2);
const server = await serve(folder);
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', args: ['--no-sandbox'] });
for (const [width, height] of [[1440, 900], [1024, 900], [390, 844]])
  for (const scheme of ['light', 'dark']) {
    const page = await browser.newPage({ viewport: { width, height }, colorScheme: scheme });
    page.on('console', (m) => { if (m.type() === 'error') console.log(m.text()); });
    page.on('pageerror', (e) => console.log(String(e)));
    await page.goto(server.url);
    await page.waitForSelector('[data-revision]');
    if (width === 1440 && scheme === 'light') await page.screenshot({ path: `${out}/questions.png` });
    await page.click('#skip');
    await page.click('#inside summary');
    await page.waitForSelector('#section rect', { state: 'attached' });
    await page.waitForTimeout(700);
    await page.screenshot({ path: `${out}/${width}-${scheme}.png`, fullPage: true });
    if (width === 1440) {
      const dot = await page.locator('.dot').boundingBox();
      await page.mouse.move(dot.x + dot.width / 2, dot.y + dot.height / 2);
      await page.mouse.down();
      for (let i = 0; i < 10; ++i) await page.mouse.move(dot.x + dot.width / 2 + 15 * i, dot.y), await page.waitForTimeout(20);
      for (let i = 0; i < 12; ++i) await page.mouse.move(dot.x + dot.width / 2 + 150 - 2 * i, dot.y), await page.waitForTimeout(20);
      await page.screenshot({ path: `${out}/drag-${scheme}.png` });
      await page.mouse.up();
      await page.click('[name=model][value=rock]');
      await page.waitForTimeout(700);
      await page.screenshot({ path: `${out}/rock-${scheme}.png`, fullPage: true });
    }
    await page.close();
  }
await browser.close();
server.close();
