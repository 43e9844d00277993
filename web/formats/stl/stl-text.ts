import { GrowingNumbers } from '../bytes/growing-arrays.ts';
import { FormatError } from '../format-error.ts';
import { parseNumber } from '../text/ascii-numbers.ts';
import { numbersFrom, type TextLine, textLines } from '../text/text-lines.ts';
import { counted, grouped, listed, quoted } from '../text/wording.ts';

const comment = /^(#|\/\/|;|!)/;
const keywords = new Set([
  'solid',
  'facet',
  'normal',
  'outer',
  'loop',
  'vertex',
  'endloop',
  'endfacet',
  'endsolid',
  'color',
]);

/** The corners of the facets of a text, three coordinates each; what is passed over is said in `notes`. */
export function readStlText(bytes: Uint8Array, notes: string[]): Float64Array {
  const text = new StlText();
  for (const line of textLines(bytes)) if (!comment.test(line.words[0])) text.readLine(line);
  return text.finish(notes);
}

class StlText {
  private readonly position = new GrowingNumbers();
  /** Corners of the facet that is open. */
  private corners = 0;
  private facets = 0;
  /** Whether a solid has begun and not ended. */
  private open = false;
  private colours = 0;
  private readonly unknown = new Map<string, number>();

  /** A line has any number of words: whole files are written as one. */
  readLine(line: TextLine): void {
    for (let at = 0; at < line.words.length; ) at = this.readWord(line, at);
  }

  finish(notes: string[]): Float64Array {
    const { position, facets, unknown } = this;
    if (this.open || position.length !== 9 * facets) {
      throw new FormatError('truncated', `The file ends after ${counted(facets, 'facet')} without “endsolid”.`);
    }
    if (this.colours > 0) notes.push('Not carried: colours.');
    const lines = [...unknown.values()].reduce((sum, count) => sum + count, 0);
    if (lines > 0) {
      const names = listed([...unknown.keys()]);
      notes.push(`${counted(lines, 'line')} passed over that no STL file has, beginning with ${names}.`);
    }
    return position.toArray();
  }

  /** Reads what the word at this place of a line announces; gives the place behind it. */
  private readWord(line: TextLine, at: number): number {
    const { words } = line;
    const word = words[at].toLowerCase();
    if (word === 'solid' || word === 'endsolid') {
      this.open = word === 'solid';
      return behindName(words, at + 1);
    }
    if (word === 'vertex') return this.readCorner(line, at);
    if (word === 'facet' && this.corners > 0) throw misplaced(line);
    if (word === 'endfacet') this.endFacet(line);
    else if (word === 'color') this.colours++;
    else if (!keywords.has(word) && parseNumber(word) === undefined) {
      this.unknown.set(words[at], 1 + (this.unknown.get(words[at]) ?? 0));
    }
    return nextKeyword(words, at + 1);
  }

  private readCorner(line: TextLine, at: number): number {
    for (const coordinate of numbersFrom(line, at + 1, 3)) this.position.push(coordinate);
    this.corners++;
    return nextKeyword(line.words, at + 4);
  }

  private endFacet({ number }: TextLine): void {
    const { corners, facets } = this;
    if (corners !== 3) {
      const message = `Facet ${grouped(facets)} has ${counted(corners, 'corner')}; it needs three (line ${number}).`;
      throw new FormatError('bad_polygon', message, `facet ${facets}`);
    }
    this.corners = 0;
    this.facets++;
  }
}

/** Where the next keyword stands; whatever is between belongs to the one before and is not needed. */
function nextKeyword(words: string[], from: number): number {
  let at = from;
  while (at < words.length && !keywords.has(words[at].toLowerCase())) at++;
  return at;
}

/** The name of a solid may be any words, so it takes the rest of its line, but for what cannot be a name. */
function behindName(words: string[], from: number): number {
  const follows = (at: number, one: string, other: RegExp) =>
    words[at].toLowerCase() === one && other.test(words[at + 1] ?? '');
  let at = from;
  while (at < words.length && !follows(at, 'facet', /^normal$/i) && !follows(at, 'color', /^[-+.\d]/)) at++;
  return at;
}

function misplaced({ words, number }: TextLine): FormatError {
  const where = `line ${number}`;
  const message = `${quoted(words.join(' '))} stands inside another facet (${where}).`;
  return new FormatError('bad_header', message, where);
}
