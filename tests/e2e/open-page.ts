import { expect, type Locator, type Page } from '@playwright/test';

/** The sentence that states the result. */
export function sentence(page: Page): Locator {
  return page.locator('.sentence');
}

/** Opens the page and waits for its first result. */
export async function openPage(page: Page): Promise<void> {
  await page.goto('./');
  await expect(sentence(page)).toContainText('proved');
  await settled(page);
}

/** Waits until nothing is read or reduced any more. */
export async function settled(page: Page): Promise<void> {
  await expect(page.locator('.numbers')).toContainText('removed');
}

export interface Counts {
  after: number;
  before: number;
}

/** The numbers of triangles that the sentence states. */
export async function counts(page: Page): Promise<Counts> {
  const text = (await sentence(page).innerText()).replace(/[\u202f\u00a0]/g, '');
  const [, after, before] = /^(\d+) of (\d+) triangles/.exec(text) ?? [];
  return { after: Number(after), before: Number(before) };
}

/** Chooses a file as the Open button does. */
export async function chooseFile(page: Page, name: string, content: Buffer): Promise<void> {
  const file = { name, mimeType: 'application/octet-stream', buffer: content };
  await page.locator('input[type=file]').setInputFiles(file);
}

/** Drops a file onto the page. */
export async function dropFile(page: Page, name: string, content: Buffer): Promise<void> {
  const transfer = await page.evaluateHandle(
    ({ fileName, base64 }) => {
      const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
      const data = new DataTransfer();
      data.items.add(new File([bytes], fileName));
      return data;
    },
    { fileName: name, base64: content.toString('base64') },
  );
  for (const event of ['dragenter', 'dragover', 'drop']) {
    await page.dispatchEvent('meshbound-app', event, { dataTransfer: transfer });
  }
}
