import type { ReadOptions } from '../../formats/read.ts';
import type { NamedFile } from '../../formats/read-together.ts';
import type { Services } from '../services.ts';
import type { Opening } from '../session-state.ts';
import type { Source } from './open-surface.ts';
import type { OpenedFile } from './read.ts';

/** Told how far the loading is. */
type Tell = (step: Omit<Opening, 'name'>) => void;

/** A source of which a surface can be made: the session opens all kinds in the same way. */
export interface Loadable extends Source {
  load(services: Services, signal: AbortSignal, tell: Tell, options?: ReadOptions): Promise<OpenedFile>;
}

/** A file of the user; `beside` are those chosen together with it: variables in CSV, what a glTF file refers to. */
export function fromFile(file: File, beside: readonly File[]): Loadable {
  const { name } = file;
  const others = () => Promise.all(beside.map(async (other) => ({ name: other.name, bytes: await bytesOf(other) })));
  const load: Loadable['load'] = async (services, signal, tell, options) => {
    const [bytes, named] = await Promise.all([bytesOf(file), others()]);
    return read(services, name, bytes, signal, tell, named, options);
  };
  return { name, address: null, load };
}

export function fromAddress(address: string): Loadable {
  const name = nameIn(address);
  const load: Loadable['load'] = async (services, signal, tell, options) => {
    const onProgress = (progress: number) => {
      if (!signal.aborted) tell({ phase: 'download', progress });
    };
    onProgress(0);
    return read(services, name, await services.fetchBytes(address, { signal, onProgress }), signal, tell, [], options);
  };
  return { name, address, load };
}

/** The same surface, with cracks closed as it is read: points that lie within this fraction of the extent are joined. */
export function welded(source: Loadable, weld: number): Loadable {
  return { ...source, load: (services, signal, tell) => source.load(services, signal, tell, { weld }) };
}

/** What was read already, but for one variable. */
export function withoutVariable({ name, address }: Source, file: OpenedFile, variable: string): Loadable {
  const variables = file.mesh.variables.filter((each) => each.name !== variable);
  const notes = [...file.notes, `The variable “${variable}” was left out.`];
  return { name, address, load: async () => ({ ...file, notes, mesh: { ...file.mesh, variables } }) };
}

function read(
  services: Services,
  name: string,
  bytes: Uint8Array<ArrayBuffer>,
  signal: AbortSignal,
  tell: Tell,
  beside: NamedFile[] = [],
  options: ReadOptions = {},
): Promise<OpenedFile> {
  signal.throwIfAborted();
  tell({ phase: 'read', progress: 0 });
  return services.read(name, bytes, { signal }, beside, options);
}

async function bytesOf(file: File): Promise<Uint8Array<ArrayBuffer>> {
  return new Uint8Array(await file.arrayBuffer());
}

/** What the file at an address is called. */
function nameIn(address: string): string {
  const path = address.replace(/[?#].*$/s, '');
  const name = path.slice(path.lastIndexOf('/') + 1);
  try {
    return decodeURIComponent(name) || address;
  } catch {
    return name;
  }
}
