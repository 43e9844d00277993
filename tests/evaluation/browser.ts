import { chromium, type Page } from '@playwright/test';
import { preview } from 'vite';

/** How Chromium is started here. */
export const browserOptions = {
  executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
  args: ['--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-sync'],
};

/** Serves the built page and lends a browser page on it. */
export async function withPage(
  look: { viewport: { width: number; height: number }; colorScheme: 'light' | 'dark' },
  work: (page: Page) => Promise<void>,
): Promise<void> {
  const server = await preview({ configFile: 'web/vite.config.ts', preview: { port: 0 }, logLevel: 'error' });
  const browser = await chromium.launch(browserOptions);
  try {
    await work(await browser.newPage({ ...look, baseURL: server.resolvedUrls?.local[0] }));
  } finally {
    await browser.close();
    await server.close();
  }
}

/** Waits until the page stands still, and returns its picture. */
export async function stillPicture(page: Page, shot: Parameters<Page['screenshot']>[0]): Promise<Buffer> {
  let last = await page.screenshot(shot);
  for (;;) {
    await page.waitForTimeout(200);
    const picture = await page.screenshot(shot);
    if (picture.equals(last)) return picture;
    last = picture;
  }
}
