import { chmodSync, statSync, symlinkSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { requireWritable, StagedFiles } from '../../web/node-cli/files/staged-files.ts';
import { Folder } from './command.ts';

const folder = new Folder();
const running = new AbortController().signal;

describe('files take their places', () => {
  test('all together, at the end', async () => {
    folder.write('old', 'old');
    await StagedFiles.complete(running, async (files) => {
      await files.write(folder.at('old'), 'new');
      await files.write(folder.at('other'), 'other');
      expect(folder.text('old')).toBe('old');
      expect(folder.files()).not.toContain('other');
    });
    expect([folder.text('old'), folder.text('other')]).toEqual(['new', 'other']);
    expect(folder.files().filter((name) => name.endsWith('.partial'))).toEqual([]);
  });

  test('with the permissions of what they replace, through links', async () => {
    folder.write('real', 'old');
    chmodSync(folder.at('real'), 0o640);
    symlinkSync(folder.at('real'), folder.at('link'));
    await StagedFiles.complete(running, (files) => files.write(folder.at('link'), 'new'));
    expect(folder.text('real')).toBe('new');
    expect(statSync(folder.at('real')).mode & 0o777).toBe(0o640);
    expect(folder.text('link')).toBe('new');
  });
});

test('a file that is write-protected is not replaced', async () => {
  folder.write('guarded', 'old');
  await expect(requireWritable([folder.at('guarded')])).resolves.toBeUndefined();
  chmodSync(folder.at('guarded'), 0o444);
  await expect(requireWritable([folder.at('guarded')])).rejects.toThrow('guarded: this file is write-protected.');
});

describe('no file changes', () => {
  async function expectUnchanged(signal: AbortSignal, work: (files: StagedFiles) => Promise<void>, reason: string) {
    folder.write('kept', 'kept');
    const before = folder.files();
    await expect(StagedFiles.complete(signal, work)).rejects.toThrow(reason);
    expect(folder.files()).toEqual(before);
    expect(folder.text('kept')).toBe('kept');
  }

  test('when what writes them fails', async () => {
    const work = async (files: StagedFiles) => {
      await files.write(folder.at('kept'), 'new');
      throw new Error('the second one failed');
    };
    await expectUnchanged(running, work, 'the second one failed');
  });

  test('when it is aborted between two', async () => {
    const controller = new AbortController();
    const work = async (files: StagedFiles) => {
      await files.write(folder.at('kept'), 'new');
      controller.abort(new Error('stop'));
      await files.write(folder.at('second'), 'second');
    };
    await expectUnchanged(controller.signal, work, 'abort');
  });

  test('when it is aborted while one is being written', async () => {
    const controller = new AbortController();
    const work = (files: StagedFiles) => {
      const writing = files.write(folder.at('kept'), new Uint8Array(2 ** 26));
      setTimeout(() => controller.abort());
      return writing;
    };
    await expectUnchanged(controller.signal, work, 'abort');
  });

  test('when it is aborted after all were written', async () => {
    const controller = new AbortController();
    const work = async (files: StagedFiles) => {
      await files.write(folder.at('kept'), 'new');
      controller.abort(new Error('too late'));
    };
    await expectUnchanged(controller.signal, work, 'too late');
  });
});
