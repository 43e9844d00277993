import { FormatError } from '../format-error.ts';
import { quoted } from '../text/wording.ts';
import type { VtkType } from '../vtk-data/vtk-values.ts';
import type { LegacyVtkText } from './legacy-vtk-text.ts';

/** What the types of numbers are called in legacy VTK files. */
const types = new Map<string, VtkType>([
  ['bit', 'Bit'],
  ['char', 'Int8'],
  ['signed_char', 'Int8'],
  ['unsigned_char', 'UInt8'],
  ['short', 'Int16'],
  ['unsigned_short', 'UInt16'],
  ['int', 'Int32'],
  ['unsigned_int', 'UInt32'],
  // As on every 64-bit system but Windows, where VTK writes long_long instead.
  ['long', 'Int64'],
  ['unsigned_long', 'UInt64'],
  ['long_long', 'Int64'],
  ['unsigned_long_long', 'UInt64'],
  ['vtktypeint64', 'Int64'],
  ['vtktypeuint64', 'UInt64'],
  // Always written as int, whatever its size in memory.
  ['vtkidtype', 'Int32'],
  ['float', 'Float32'],
  ['double', 'Float64'],
]);

/** A word of a line as a count. */
export function countOf(word: string | undefined, text: LegacyVtkText): number {
  if (/^\d{1,15}$/.test(word ?? '')) return Number(word);
  const message = `${quoted(word ?? '')} stands where a count should (${text.place()}).`;
  throw new FormatError(text.atEnd() ? 'truncated' : 'bad_header', message, text.place());
}

/** A word of a line as a type of numbers. */
export function typeOf(word: string | undefined, text: LegacyVtkText): VtkType {
  const type = types.get(word?.toLowerCase() ?? '');
  if (type) return type;
  const message = `${quoted(word ?? '')} is no type of numbers that is read here (${text.place()}).`;
  throw new FormatError(text.atEnd() ? 'truncated' : 'unsupported_feature', message, text.place());
}
