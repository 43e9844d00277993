// Every English word that element and page show stands in web/words, and nothing there is left over.
import { readdirSync, readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { english } from '../../web/words/english.ts';
import { pageEnglish } from '../../web/words/page-english.ts';

const sources = ['web/element', 'web/page'].flatMap((folder) =>
  readdirSync(folder, { recursive: true, encoding: 'utf8' })
    .filter((name) => name.endsWith('.ts'))
    .map((name) => ({ name: `${folder}/${name}`, text: readFileSync(`${folder}/${name}`, 'utf8') })),
);

/** What stands in the templates of a source; what is put into them is left out, but for templates within. */
function templatesOf(source: string): string[] {
  const found: string[] = [];
  const starts = source.matchAll(/\b(?:html|svg)`/g);
  for (const { index, 0: tag } of starts) found.push(plainText(source, index + tag.length));
  return found;
}

/** From a place in a template to its end; every `${…}` becomes one sign. */
function plainText(source: string, from: number): string {
  let [text, at] = ['', from];
  while (source[at] !== '`') {
    if (source.startsWith('${', at)) {
      at = endOfExpression(source, at + 2);
      text += '•';
    } else {
      text += source[at++];
    }
  }
  return text;
}

/** Behind the brace that ends what is put into a template. */
function endOfExpression(source: string, from: number): number {
  let at = from;
  for (let depth = 1; depth > 0; at++) {
    if (source[at] === '{') depth++;
    else if (source[at] === '}') depth--;
    else if (source[at] === '`') at = endOfTemplate(source, at + 1);
    else if (source[at] === "'") at = source.indexOf("'", at + 1);
  }
  return at;
}

function endOfTemplate(source: string, from: number): number {
  let at = from;
  while (source[at] !== '`') at = source.startsWith('${', at) ? endOfExpression(source, at + 2) : at + 1;
  return at;
}

/** Attributes that are shown or spoken. */
const shownAttributes = /\s(?:aria-label|aria-valuetext|title|placeholder|label|spoken|alt)="([^"]*)"/g;
/** Marks of the mathematics of a cut, and of units of measure, are the same in any language. */
const noWords = /^(?:x < 0\.5|%|&nbsp;|&[a-z]+;)$/;

function wordsOf(template: string): string[] {
  const attributes = Array.from(template.matchAll(shownAttributes), ([, value]) => value);
  const between = template.replace(/<!--.*?-->/gs, '').replace(/<[^>]*>/g, '\n');
  return [...attributes, ...between.split('\n')]
    .map((each) => each.trim())
    .filter((each) => /[A-Za-z]/.test(each) && !noWords.test(each));
}

test('templates hold no words of their own', () => {
  const put = '$'.concat('{any.thing}');
  const [example] = templatesOf(`html\`<p title="A hint">Some text ${put} <b class="x">${put}</b></p>\``);
  expect(wordsOf(example)).toEqual(['A hint', 'Some text •']);
  const found = sources.flatMap(({ name, text }) =>
    templatesOf(text)
      .flatMap(wordsOf)
      .map((words) => `${name}: ${words}`),
  );
  expect(found).toEqual([]);
});

/** Three words or more: less may be a name of an event, a style, a format. Keys are no words. */
const sentence = /(?:'(?!Ctrl)[A-Z][a-z]*(?: [^\s'`]+){2,}'|(?<!html|css|svg)`[A-Z][a-z]* [^`]*`)/g;

test('what is a sentence in the sources stands among the words', () => {
  const sentences = sources.flatMap(({ name, text }) => {
    const code = text.replace(/css`[^`]*`/g, '').replace(/\/\*.*?\*\/|^\s*\/\/.*$/gms, '');
    return Array.from(code.matchAll(sentence), ([found]) => `${name}: ${found}`);
  });
  expect(sentences).toEqual([]);
});

test('every word is in use', () => {
  const all = sources.map(({ text }) => text).join('\n');
  const unused = [...Object.entries(english), ...Object.entries(pageEnglish)].flatMap(([part, words]) =>
    typeof words === 'function'
      ? []
      : Object.keys(words)
          .filter((key) => !new RegExp(`\\b${key}\\b`).test(all))
          .map((key) => `${part}.${key}`),
  );
  expect(unused).toEqual([]);
});
