import { expect, test } from '@playwright/test';
import { chooseFile, counts, openPage, sentence, settled, sharePage, typePercent } from './open-page.ts';
import { sheet } from './surfaces.ts';

test('begins with a sample, reduced within the first bounds', async ({ page }) => {
  const hosts = new Set<string>();
  page.on('request', (request) => hosts.add(new URL(request.url()).origin));
  const faults: string[] = [];
  page.on('pageerror', ({ message }) => faults.push(message));
  // What the content security policy refuses is said here.
  page.on('console', (message) => message.type() === 'error' && faults.push(message.text()));
  await openPage(page);
  const { after, before } = await counts(page);
  expect(after).toBeGreaterThan(0);
  expect(after).toBeLessThan(before);
  await expect(sentence(page)).toContainText(/Every point within 1.% in space, 3.% in .*: proved; most used: .+, .+%/);
  expect([...hosts].filter((origin) => origin !== 'null')).toEqual([new URL(page.url()).origin]);
  expect(faults).toEqual([]);
  // So that a running reduction can be cancelled in place.
  expect(await page.evaluate(() => crossOriginIsolated)).toBe(true);
  await expect(page.getByRole('status').filter({ hasText: 'triangles' })).toHaveText(await sentence(page).innerText());
});

/** The number in a text like "bounded by 0.481 m". */
function numberIn(text: string): number {
  const plain = text.replace(/\u202f/g, '').replaceAll('−', '-');
  return Number(/\d[\d.]*(e-?\d+)?/.exec(plain)?.[0]);
}

test.describe('on one page', () => {
  const page = sharePage();

  /** A surface whose reduction takes a while. */
  async function openLarge(): Promise<void> {
    const triangles = 2 * 319 * 319;
    if ((await counts(page())).before === triangles) return;
    await chooseFile(page(), 'sheet.ply', sheet(320));
    await expect.poll(async () => (await counts(page())).before).toBe(triangles);
    await settled(page());
  }

  test('a looser bound leaves fewer triangles, a tighter one more, and the way there does not matter', async () => {
    const first = await counts(page());
    await page().getByRole('slider', { name: 'All bounds' }).fill('300');
    await expect.poll(async () => (await counts(page())).after).toBeLessThan(first.after);
    expect((await counts(page())).before).toBe(first.before);
    await typePercent(page(), 'Largest bound', '0.3');
    await expect.poll(async () => (await counts(page())).after).toBeGreaterThan(first.after);
    await typePercent(page(), 'Largest bound', '3');
    await expect.poll(() => counts(page())).toEqual(first);
  });

  test('states for each variable the bound and the error in its unit, and how much of the bound is used', async () => {
    const rows = page().locator('meshbound-bound-row');
    expect(await rows.count()).toBeGreaterThan(5);
    for (const row of await rows.all()) {
      const bound = numberIn(await row.locator('label').innerText());
      const error = numberIn(await row.locator('.error').innerText());
      expect(error).toBeLessThanOrEqual(bound);
      const used = await row
        .locator('input[type=range]')
        .evaluate((slider: HTMLElement) => slider.style.getPropertyValue('--used'));
      expect(Number(used)).toBeLessThanOrEqual(1);
      if (error > 0) expect(Number(used)).toBeGreaterThan(0);
    }
  });

  test('a variable without a bound holds nothing back and nothing is guaranteed of it', async () => {
    const first = await counts(page());
    const toggle = page().getByRole('checkbox', { name: 'temperature bounded' });
    await toggle.uncheck();
    await expect(sentence(page())).toContainText('Free, so nothing guaranteed: temperature');
    expect((await counts(page())).after).toBeLessThan(first.after);
    await expect(page().getByRole('slider', { name: 'Bound of temperature' })).toBeDisabled();
    await toggle.check();
    await expect.poll(() => counts(page())).toEqual(first);
  });

  test('says which variable holds the reduction back: without its bound fewer triangles are left, and another does', async () => {
    const most = page().locator('meshbound-held-back b');
    await page().getByRole('button', { name: 'Presets' }).click();
    await page().getByRole('button', { name: 'Usual' }).click();
    await settled(page());
    const name = await most.innerText();
    const before = await counts(page());
    await expect(page().locator('meshbound-held-back')).toContainText(/\d\s%/);
    await page()
      .getByRole('checkbox', { name: `${name === 'space' ? 'position' : name} bounded` })
      .uncheck();
    await settled(page());
    await expect(most).not.toHaveText(name);
    expect((await counts(page())).after).toBeLessThan(before.after);
    await page()
      .getByRole('checkbox', { name: `${name === 'space' ? 'position' : name} bounded` })
      .check();
    await settled(page());
  });

  test('refuses what cannot be a bound, says why and keeps the bound', async () => {
    const first = await sentence(page()).innerText();
    const field = page().getByLabel('Bound of pressure in percent');
    for (const [typed, reason] of [
      ['-3', 'cannot be negative'],
      ['0', 'cannot be zero'],
      ['three', '“three” is not a number'],
      ['', 'needs a number'],
    ]) {
      await field.fill(typed);
      await field.press('Enter');
      await expect(page().getByRole('alert')).toContainText(reason);
      await expect(field).toHaveAttribute('aria-invalid', 'true');
    }
    await field.press('Escape');
    await expect(page().getByRole('alert')).toHaveCount(0);
    await expect(field).toHaveValue('3');
    expect(await sentence(page()).innerText()).toBe(first);
  });

  test('a newer change cancels the run before it, and the page answers meanwhile', async () => {
    await openLarge();
    const seen = await page().evaluateHandle(() => {
      const app = document.querySelector('meshbound-app') as HTMLElement;
      const bar = app.shadowRoot?.querySelector('meshbound-result-bar') as HTMLElement;
      const texts: string[] = [];
      const read = () => texts.push(bar.shadowRoot?.querySelector('.sentence')?.textContent ?? '');
      new MutationObserver(read).observe(bar.shadowRoot as ShadowRoot, {
        subtree: true,
        characterData: true,
        childList: true,
      });
      return texts;
    });
    const field = page().getByLabel('Bound of heat in percent');
    for (const percent of ['0.02', '7', '0.03', '5']) {
      await field.fill(percent);
      await field.press('Enter');
      // Typing goes through while a reduction runs.
      await expect(field).toHaveValue(percent);
    }
    await expect(sentence(page())).toContainText(/5.% in heat/);
    await settled(page());
    const texts = (await seen.jsonValue()).map((text) => text.replace(/\u00a0/g, ' '));
    expect(texts.filter((text) => text.includes('0.02 % in heat'))).toEqual([]);
    expect(texts.at(-1)).toContain('5 % in heat');
  });

  /** From within the page, where the button may be gone before a click from out here arrives; it shows after 0.4 seconds. */
  function clickCancelWhenItIsThere(): Promise<void> {
    return page().evaluate(
      () =>
        new Promise<void>((done) => {
          const app = document.querySelector('meshbound-app') as HTMLElement;
          const bar = app.shadowRoot?.querySelector('meshbound-result-bar') as HTMLElement;
          const observer = new MutationObserver(() => {
            const button = bar.shadowRoot?.querySelector<HTMLButtonElement>('.cancel');
            if (!button) return;
            observer.disconnect();
            button.click();
            done();
          });
          observer.observe(bar.shadowRoot as ShadowRoot, { subtree: true, childList: true });
        }),
    );
  }

  test('can be cancelled, keeps the result before it, and can be started again', async () => {
    await openLarge();
    const before = await sentence(page()).innerText();
    const field = page().getByLabel('Largest bound in percent');
    await field.fill('2');
    const cancelled = clickCancelWhenItIsThere();
    await field.press('Enter');
    await cancelled;
    await expect(page().locator('.numbers')).toContainText('Cancelled');
    await expect(sentence(page())).toHaveText(
      `Not with what is asked for, which was cancelled, but with the bounds before: ${before}`,
    );
    await page().getByRole('button', { name: 'Reduce', exact: true }).click();
    await settled(page());
    await expect(sentence(page())).not.toHaveText(before);
    await expect(sentence(page())).toContainText(/2.% in/);
  });

  test('opens another sample', async () => {
    await page().getByLabel('Sample').selectOption('impact');
    await expect(page().getByTitle('iron', { exact: true })).toBeVisible();
    await expect(page().getByLabel('Sample')).toHaveValue('impact');
    await settled(page());
    await expect(sentence(page())).toContainText('iron');
  });
});
