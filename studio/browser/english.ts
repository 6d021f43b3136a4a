import type { Page } from 'playwright-core';

const kEnglish =
  /.{0,40}\b(the|and|with|from|of|to|is|are|was|has|have|must|not|did|you|save|undo|drawing|table|world|none|required|wire|input|takes|answers|nothing|lost|over|reached)\b.{0,40}/gi;

/** What of all that is shown or said to screen readers looks English. */
export async function englishIn(page: Page, within = 'body'): Promise<string[]> {
  const words = await page.evaluate((selector) => {
    const parts = [...document.querySelectorAll<HTMLElement>(selector)];
    const labels = parts
      .flatMap((part) => [...part.querySelectorAll('[aria-label],[title],[placeholder]')])
      .map((one) => ['aria-label', 'title', 'placeholder'].map((name) => one.getAttribute(name) ?? '').join(' '));
    return `${parts.map((part) => part.innerText).join(' ')} ${labels.join(' ')}`;
  }, within);
  return words.match(kEnglish) ?? [];
}
