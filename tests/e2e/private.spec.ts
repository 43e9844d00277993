import { expect, type Page, test } from '@playwright/test';
import { chooseFile, openPage, sentence, settled } from './open-page.ts';
import { sheet } from './surfaces.ts';

/** Where the page has asked for anything, and what its content security policy refused. */
async function watch(page: Page): Promise<{ origins: Set<string>; refused: () => Promise<string[]> }> {
  const origins = new Set<string>();
  page.context().on('request', (request) => origins.add(new URL(request.url()).origin));
  await page.addInitScript(() => {
    const refused: string[] = [];
    Object.assign(window, { refused });
    addEventListener('securitypolicyviolation', ({ violatedDirective, blockedURI }) =>
      refused.push(`${violatedDirective} ${blockedURI}`),
    );
  });
  return { origins, refused: () => page.evaluate(() => (window as unknown as { refused: string[] }).refused) };
}

async function save(page: Page, item: string): Promise<void> {
  const started = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Save…' }).click();
  await page.getByRole('button', { name: item, exact: true }).click();
  await (await started).path();
}

test('nothing of a file of the user’s goes anywhere, whatever is done with it', async ({ page }) => {
  const { origins, refused } = await watch(page);
  const bodies: string[] = [];
  page.context().on('request', (request) => request.postData() !== null && bodies.push(request.url()));
  await openPage(page);
  await chooseFile(page, 'secret.ply', sheet(30));
  await expect(sentence(page)).toContainText(/of 1.682 triangles/);
  await settled(page);
  await page.getByLabel('Show').selectOption({ label: 'error / bound' });
  for (const item of ['PLY', 'VTP', 'Legacy VTK', 'GLB', 'OBJ', 'STL', 'Report (JSON)', 'Picture (PNG)']) {
    await save(page, item);
  }
  // What the page itself makes, a picture or a file to save, has no origin or its own.
  const own = new URL(page.url()).origin;
  expect([...origins].filter((origin) => origin !== 'null' && origin !== own)).toEqual([]);
  expect(bodies).toEqual([]);
  expect(await refused()).toEqual([]);
});

test('the policy lets no text become code, and nothing else in than the page’s own', async ({ page }) => {
  await openPage(page);
  const policies = await page
    .locator('meta[http-equiv=Content-Security-Policy]')
    .evaluateAll((all) => all.map((meta) => meta.getAttribute('content') ?? ''));
  expect(policies).toHaveLength(1);
  expect(policies[0]).toContain("script-src 'self' 'wasm-unsafe-eval'");
  expect(policies[0].replace("'wasm-unsafe-eval'", '')).not.toContain('unsafe');
  // Later: while the test's own text is evaluated, the policy is not asked.
  const evaluated = await page.evaluate(
    () =>
      new Promise((resolve) =>
        setTimeout(() => {
          try {
            resolve(new Function('return "ran"')());
          } catch (error) {
            resolve((error as Error).name);
          }
        }),
      ),
  );
  expect(evaluated).toBe('EvalError');
  const inline = await page.evaluate(() => {
    const script = document.createElement('script');
    script.textContent = 'document.title = "ran"';
    document.body.append(script);
    document.body.insertAdjacentHTML('beforeend', '<img src="x" onerror="document.title = `ran`">');
    return new Promise((resolve) => setTimeout(() => resolve(document.title), 500));
  });
  expect(inline).toBe('Meshbound');
  const elsewhere = await page.evaluate(() =>
    fetch('http://example.org/').then(
      () => 'sent',
      ({ name }) => name,
    ),
  );
  expect(elsewhere).toBe('TypeError');
});
