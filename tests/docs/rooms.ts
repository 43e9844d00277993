// The rooms of the core: folders of core/src, which a table orders from the lowest to the highest.
import { existsSync, readFileSync } from 'node:fs';
import { dirname, join, normalize } from 'node:path';

/** For each room the rooms and files that it may include besides its own. */
export type Rooms = Map<string, string[]>;

/** From the rows of the table (room, text of the last column). Throws where a row names a room that is not above it. */
export function parse(rows: [string, string][]): Rooms {
  const table: Rooms = new Map();
  for (const [room, cell] of rows) {
    const lower = [...table.keys()];
    const named = Array.from(cell.matchAll(/`([\w/.]+)`/g), ([, name]) => name);
    for (const name of named) {
      if (!lower.some((above) => above === name || dirname(name) === above)) {
        throw new Error(`${room} names ${name}, which is no room above it and in none.`);
      }
    }
    table.set(room, cell.includes('all above') ? lower : named);
  }
  return table;
}

/** The file's includes in quotes, by path from the root. Throws where one names no file. */
export function includesOf(path: string): string[] {
  return Array.from(readFileSync(path, 'utf8').matchAll(/^\s*#\s*include\s*"([^"]+)"/gm), ([, name]) => {
    const places = [dirname(path), 'core/src', 'core/include'].map((folder) => normalize(join(folder, name)));
    const found = places.find((place) => existsSync(place));
    if (!found) throw new Error(`${path} includes ${name}, which is not there.`);
    return found;
  });
}

/** The room that a file lies in: its folder. A room within another one is a room of its own. */
function roomOf(table: Rooms, path: string): string | undefined {
  return table.has(dirname(path)) ? dirname(path) : undefined;
}

/** Rooms of the table that no file lies in. */
export function withoutFiles(table: Rooms, files: string[]): string[] {
  return [...table.keys()].filter((room) => !files.some((path) => roomOf(table, path) === room));
}

/** Each include that the table forbids, and each file that lies in no room. Public headers are open to all. */
export function faults(table: Rooms, includes: Map<string, string[]>): string[] {
  return [...includes].flatMap(([path, included]) => {
    const room = roomOf(table, path);
    if (!room) return [`${path} is in no room`];
    const open = [room, ...(table.get(room) ?? [])];
    return included
      .filter((name) => name.startsWith('core/src/'))
      .filter((name) => !open.includes(name) && !open.includes(roomOf(table, name) ?? ''))
      .map((name) => `${path} includes ${name}`);
  });
}
