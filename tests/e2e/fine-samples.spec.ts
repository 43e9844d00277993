import { expect, test } from '@playwright/test';
import { openPage, settled } from './open-page.ts';
import { coverage, hasBrokenBound, pictureOf } from './picture.ts';

// Every sample, every level, every way between two: the fine ones too.

for (const sample of ['impact', 'impact-fine', 'fireballs-fine']) {
  test(`${sample}: probes and morphs`, async ({ page }) => {
    await openPage(page);
    await page.getByLabel('Sample').selectOption(sample);
    await expect(page.locator('.sentence')).toContainText('proved');
    await settled(page);
    await page.getByLabel('Levels of detail').selectOption('3');
    const slider = page.getByLabel('Position among levels');
    await expect(slider).toBeEnabled();
    const whole = coverage(await pictureOf(page, 'original'));
    for (const position of [0, 0.5, 1, 1.5, 2, 2.5, 3]) {
      await slider.fill(String(position));
      // A hole or a spike would show in how much of the picture the surface covers.
      const covered = async () => coverage(await pictureOf(page, 'reduced')) / whole;
      await expect.poll(covered).toBeGreaterThan(0.85);
      expect(await covered()).toBeLessThan(1.15);
      expect(hasBrokenBound(await pictureOf(page, 'reduced'))).toBe(false);
    }
    for (const pane of ['original', 'reduced']) {
      const box = await page.locator(`#${pane}`).boundingBox();
      await page.mouse.move((box?.x ?? 0) + (box?.width ?? 0) / 2, (box?.y ?? 0) + (box?.height ?? 0) / 2);
      await expect(page.locator('meshbound-probe-card')).toContainText('pressure');
    }
    // No fault was shown anywhere on the way: a map that its own check refuses would be one.
    await expect(page.getByRole('alert')).toHaveCount(0);
  });
}
