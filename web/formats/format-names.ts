import type { Format } from './surface.ts';

/** What the formats are called in sentences. */
export const formatNames: Record<Format, string> = {
  ply: 'PLY',
  vtp: 'VTP',
  vtk: 'legacy VTK',
  glb: 'GLB',
  obj: 'OBJ',
  stl: 'STL',
};

/** The format that the ending of a file's name asks for, with or without .gz behind it; undefined for any other ending. */
export function formatByEnding(name: string): Format | undefined {
  const ending = /\.(\w+)(\.gz)?$/i.exec(name)?.[1].toLowerCase() ?? '';
  return Object.hasOwn(formatNames, ending) ? (ending as Format) : undefined;
}
