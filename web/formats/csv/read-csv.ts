import { dsvFormat } from 'd3-dsv';
import type { Variable } from '../../../wasm/types.ts';
import { FormatError } from '../format-error.ts';
import { groupProperties } from '../ply/ply-variables.ts';
import { type Labels, noLabels } from '../surface.ts';
import { parseNumber } from '../text/ascii-numbers.ts';
import { cutNotes } from '../text/text-lines.ts';
import { utf8Text } from '../text/utf8-text.ts';
import { counted, grouped, listed, quoted } from '../text/wording.ts';

interface Column {
  name: string;
  unit: string | undefined;
  cells: string[];
}

export interface CsvVariables extends Labels {
  variables: Variable[];
  notes: string[];
}

/**
 * The variables in a CSV file: a line of names, then one line for each of `points` points in their order, separated by
 * commas, semicolons or tabs. A unit may follow a name in brackets: `pressure [Pa]`. Columns name_x name_y name_z or name_0
 * name_1 … (ParaView: name:0 name:1 …) are the components of one variable. Values are doubles, since text has no precision.
 */
export function readCsv(bytes: Uint8Array, points: number): CsvVariables {
  const columns = columnsOf(utf8Text(bytes, 'the CSV file'), points);
  const texts = columns.filter(
    ({ cells }) => points > 0 && cells.every((cell) => parseNumber(cell) === undefined && cell !== ''),
  );
  const numbers = new Map(columns.filter((column) => !texts.includes(column)).map((column) => [column.name, column]));
  const notes: string[] = [];
  if (texts.length > 0)
    notes.push(`Not carried: the columns ${listed(texts.map(({ name }) => name))}, which are text.`);
  const labels = noLabels();
  const variables = groupProperties([...numbers.keys()]).map(({ name, properties }): Variable => {
    const parts = properties.flatMap((property) => numbers.get(property) ?? []);
    const values = new Float64Array(points * parts.length);
    for (const [component, part] of parts.entries()) {
      for (let point = 0; point < points; point++) values[point * parts.length + component] = numberIn(part, point);
    }
    if (parts[0].unit) labels.units[name] = parts[0].unit;
    return { name, components: parts.length, values };
  });
  const empty = [...numbers.values()].reduce((sum, { cells }) => sum + cells.filter((cell) => cell === '').length, 0);
  if (empty > 0) notes.push(`${counted(empty, 'empty cell')} taken for “not a number”.`);
  return { variables, notes: [...notes, ...cutNotes(bytes, 'the CSV file')], ...labels };
}

function columnsOf(text: string, points: number): Column[] {
  const head = /^[^\n]*/.exec(text)?.[0] ?? '';
  const separator = ['\t', ';', ','].find((letter) => head.includes(letter)) ?? ',';
  const [names = [], ...rows] = dsvFormat(separator)
    .parseRows(text.replace(/^\u{FEFF}/u, ''))
    .filter((row) => row.some((cell) => cell.trim() !== ''));
  if (rows.length !== points) {
    const message = `The CSV file has ${counted(rows.length, 'line')} of values, but the surface has ${counted(points, 'point')}.`;
    throw new FormatError('count_mismatch', message);
  }
  checkNames(names);
  const short = rows.findIndex((row) => row.length !== names.length);
  if (short >= 0) {
    const where = `line ${grouped(short + 2)}`;
    const message = `The CSV file has ${counted(names.length, 'name')}, but ${counted(rows[short].length, 'cell')} in ${where}.`;
    throw new FormatError('count_mismatch', message, where);
  }
  return names.map((title, index) => ({ ...nameAndUnit(title), cells: rows.map((row) => row[index].trim()) }));
}

function nameAndUnit(title: string): Pick<Column, 'name' | 'unit'> {
  const text = title.trim();
  const bracket = text.endsWith(']') ? text.lastIndexOf('[') : -1;
  const name = bracket < 0 ? text : text.slice(0, bracket).trim();
  const unit = bracket < 0 ? undefined : text.slice(bracket + 1, -1).trim() || undefined;
  return { name: name.replace(/:(\d+)$/, '_$1'), unit };
}

function checkNames(titles: string[]): void {
  const seen = new Set<string>();
  for (const [index, title] of titles.entries()) {
    const { name } = nameAndUnit(title);
    const where = `column ${index + 1}`;
    if (name === '') throw new FormatError('empty_name', `The CSV file has no name for ${where}.`, where);
    if (seen.has(name))
      throw new FormatError('duplicate_name', `Two columns are named ${quoted(name)} (${where}).`, where);
    seen.add(name);
  }
}

function numberIn({ name, cells }: Column, point: number): number {
  const value = cells[point] === '' ? Number.NaN : parseNumber(cells[point]);
  if (value !== undefined) return value;
  const where = `column ${quoted(name)}, line ${grouped(point + 2)}`;
  throw new FormatError('bad_number', `${quoted(cells[point])} is not a number (${where}).`, where);
}
