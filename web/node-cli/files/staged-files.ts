import { constants, type Stats } from 'node:fs';
import { access, realpath, rename, rm, stat, writeFile } from 'node:fs/promises';
import { basename, dirname, join, resolve } from 'node:path';
import { Fault, faultOf, UsageFault } from '../fault.ts';

/**
 * The files that a command writes, all or none: each is written beside its place under another name, and takes its place
 * only when all are complete. Whatever happens before leaves every file as it was.
 */
export class StagedFiles {
  private readonly staged: { path: string; target: string; temporary: string }[] = [];
  private readonly signal: AbortSignal;

  /** Once `signal` is aborted, writing rejects. */
  private constructor(signal: AbortSignal) {
    this.signal = signal;
  }

  async write(path: string, bytes: Uint8Array | string): Promise<void> {
    try {
      const there = await statOf(path);
      if (there && !there.isFile()) return await writeFile(path, bytes); // A device or a pipe keeps no half of anything.
      const target = there ? await realpath(path) : path;
      const temporary = join(dirname(target), `.${basename(target)}.${process.pid}.partial`);
      this.staged.push({ path, target, temporary });
      await writeFile(temporary, bytes, { mode: there?.mode, signal: this.signal });
    } catch (error) {
      throw faultOf(path, error);
    }
  }

  /** Runs what writes files, and puts them in their places if it succeeds; else removes what there is of them. */
  static async complete<Value>(signal: AbortSignal, work: (files: StagedFiles) => Promise<Value>): Promise<Value> {
    const files = new StagedFiles(signal);
    try {
      const value = await work(files);
      await files.commit();
      return value;
    } finally {
      await files.discard();
    }
  }

  private async commit(): Promise<void> {
    this.signal.throwIfAborted();
    for (const { path, target, temporary } of this.staged) {
      await rename(temporary, target).catch((error) => {
        throw faultOf(path, error);
      });
    }
  }

  private async discard(): Promise<void> {
    await Promise.all(this.staged.map(({ temporary }) => rm(temporary, { force: true })));
  }
}

/** Throws a Fault, before any work is done, where files cannot be written to these paths, or two of them are one. */
export async function requireWritable(paths: string[]): Promise<void> {
  const places = new Set(paths.map((path) => resolve(path)));
  if (places.size < paths.length)
    throw new UsageFault(`Two of the files to be written are the same: ${paths.join(', ')}.`);
  for (const path of paths) await requirePlace(path);
}

/** Of the mode of a file: its owner, its group or others may write to it. */
const writeBits = constants.S_IWUSR | constants.S_IWGRP | constants.S_IWOTH;

async function requirePlace(path: string): Promise<void> {
  const there = await statOf(path);
  if (there?.isDirectory()) throw new Fault(`${path}: this is a folder, not a file.`);
  // Putting a file in its place asks its folder alone: one that its owner protects would be replaced all the same.
  if (there?.isFile() && (there.mode & writeBits) === 0) throw new Fault(`${path}: this file is write-protected.`);
  const place = there && !there.isFile() ? path : dirname(resolve(path));
  await access(place, constants.W_OK).catch((error) => {
    throw faultOf(path, error);
  });
}

function statOf(path: string): Promise<Stats | undefined> {
  return stat(path).catch(() => undefined);
}
