import { mkdirSync } from 'node:fs';
import { beforeAll, describe, expect, test } from 'vitest';
import { parseBounds } from '../../web/node-cli/options/bound-arguments.ts';
import { Folder } from './command.ts';
import { engine } from './engine.ts';

const folder = new Folder();

beforeAll(async () => {
  const mesh = engine(4);
  await folder.save('in.vtp', mesh);
  const [pressure, ...others] = mesh.variables;
  const holed = { ...pressure, values: pressure.values.with(3, Number.NaN) };
  await folder.save('nan.vtp', { ...mesh, variables: [holed, ...others] });
  await folder.save('map.vtp', { ...mesh, variables: [{ ...pressure, name: 'pressure_error' }, pressure] });
  folder.write('text.vtp', 'no mesh at all');
  folder.write('empty.ply', '');
  await folder.save('line.ply', { ...mesh, triangles: Uint32Array.of(0, 1, 1) });
  folder.write('short.csv', 'heat\n1\n');
  folder.write('cut.vtp', folder.text('in.vtp').slice(0, 900));
  mkdirSync(folder.at('folder.vtp'));
});

const bound = ['--bound', '*=1%'];
const toOut = ['-o', 'out.vtp'];

/** A command line, and what standard error must say of it. */
type Case = [args: string[], message: RegExp | string];

const usageFaults: Case[] = [
  [[], 'A command is missing.'],
  [['shrink'], /no command “shrink”; the commands are inspect, reduce, verify, convert/],
  [['inspect'], 'FILE is missing.'],
  [['inspect', 'in.vtp', 'in.vtp'], '“in.vtp” is one argument too many.'],
  [['inspect', '--fast', 'in.vtp'], 'Unknown option “--fast”.'],
  [['convert', 'in.vtp'], 'OUT is missing.'],
  [['convert', 'in.vtp', 'out.step'], /out\.step: the ending .* \.ply, \.vtp, \.vtk/],
  [['convert', 'in.vtp', 'out'], /out: the ending .* decides/],
  [['reduce', ...toOut, ...bound], 'IN is missing.'],
  [['reduce', 'in.vtp', ...bound], '-o OUT is missing.'],
  [['reduce', 'in.vtp', ...toOut], 'No bound was given'],
  [['reduce', 'in.vtp', ...toOut, ...bound, '--errors', 'guessed'], '“guessed”; it is tracked or propagated'],
  [['reduce', 'in.vtp', ...toOut, ...bound, '--cost', 'sum'], '“sum”; it is maximum or introduced'],
  [['reduce', 'in.vtp', ...toOut, ...bound, '--lock-points', '3,-1'], '“-1” is no point and no range'],
  [['reduce', 'in.vtp', ...toOut, ...bound, '--lock-points', '9-3'], '“9-3” is no point and no range'],
  [['reduce', 'in.vtp', ...toOut, ...bound, '--lock-box', '0,0,0,1,1'], 'a box has six numbers'],
  [['reduce', 'in.vtp', ...toOut, ...bound, '--lock-box', '0,0,0,1,-1,1'], 'its lowest place is above its highest'],
  [['reduce', 'in.vtp', ...toOut, ...bound, '--levels', '1%,3%'], '--bound "*=…" cannot be given beside it'],
  [['reduce', 'in.vtp', ...toOut, '--levels', '1%,some'], '“some” is not a number'],
  [['reduce', 'in.vtp', ...toOut, '--levels', '1%,,3%'], 'is not a number'],
  [
    ['reduce', 'in.vtp', ...toOut, '--levels', '1%,3%,9%', '-b', 'pressure=1%,2%'],
    '3 levels, but this has bounds for 2',
  ],
  [['reduce', 'in.vtp', ...toOut, ...bound, '-b', 'pressure=1%,2%'], '“1%,2%” is not a number'],
  [
    ['reduce', 'in.vtp', ...toOut, ...bound, '--region', 'part', '--lock-region', '-3'],
    'begins with a minus; the latter is written --lock-region=-3.',
  ],
  [['reduce', 'in.vtp', ...toOut, ...bound, '--lock-points', '-1'], 'is written --lock-points=-1.'],
  [['reduce', 'in.vtp', ...toOut, ...bound, '--lock-box', '-1,-1,-1,1,1,1'], 'written --lock-box=-1,-1,-1,1,1,1.'],
  [
    ['reduce', 'in.vtp', '-o', '--quiet', ...bound],
    /value of -o is missing, or begins with a minus; .* --output=--quiet\./,
  ],
  [
    ['reduce', 'in.vtp', ...toOut, ...bound, '--bound-multiplier', 'pressure', '--bound-multiplier', 'heat'],
    '--bound-multiplier was given “pressure”, “heat”',
  ],
  [
    ['verify', 'in.vtp', 'in.vtp', ...bound, '--bound-multiplier', 'a', '--bound-multiplier', 'b'],
    '--bound-multiplier was given “a”, “b”; one variable',
  ],
  [['reduce', 'in.vtp', ...toOut, '-b', '*=1%', '--lock-region', '3'], '--lock-region goes with --region NAME'],
  [['reduce', 'in.vtp', ...toOut, '--levels', '1%,3%', '--map', 'm.vtp'], '--map goes with one result'],
  [
    ['reduce', 'in.vtp', ...toOut, ...bound, '--errors', 'propagated', '--map', 'm.vtp'],
    '--map goes with --errors tracked',
  ],
  [['reduce', 'in.vtp', ...toOut, ...bound, '--map', './out.vtp'], 'Two of the files to be written are the same'],
  [['reduce', 'in.vtp', ...toOut, ...bound, '--exclude', 'position'], 'position cannot be left out'],
  [['verify', 'in.vtp', ...bound], 'REDUCED is missing.'],
  [['verify', 'in.vtp', 'in.vtp'], 'No bound was given'],
  [['verify', 'in.vtp', 'in.vtp', '-b', '*=free'], 'Every variable is free.'],
  [['verify', 'in.vtp', 'in.vtp', ...bound, '--samples', 'many'], '--samples cannot be “many”'],
];

const bounds: [bound: string, message: string][] = [
  ['pressure', 'it has the form NAME=1%'],
  ['=1%', 'it has the form NAME=1%'],
  ['pressure=', 'is not a number'],
  ['pressure=%', 'is not a number'],
  ['pressure=some', '“some” is not a number'],
  ['pressure=1%%', 'is not a number'],
  ['pressure=0', 'above zero'],
  ['pressure=-1%', 'above zero'],
  ['pressure=Infinity', 'finite'],
];

const fileFaults: Case[] = [
  [['inspect', 'none.vtp'], 'none.vtp: there is no such file'],
  [['inspect', 'folder.vtp'], 'folder.vtp: this is a folder'],
  [['inspect', 'text.vtp'], 'text.vtp: This is no mesh file'],
  [['inspect', 'empty.ply'], 'empty.ply: The file is empty.'],
  [['convert', 'cut.vtp', 'out.ply'], 'cut.vtp: '],
  [['inspect', 'in.vtp', '--variables', 'none.csv'], 'none.csv: there is no such file'],
  [['inspect', 'in.vtp', '--variables', 'short.csv'], 'short.csv: The CSV file has 1 line of values'],
  [['convert', 'in.vtp', 'folder.vtp'], 'folder.vtp: this is a folder'],
  [['convert', 'in.vtp', 'nowhere/out.ply'], 'nowhere/out.ply: there is no such file or folder'],
  [['reduce', 'none.vtp', ...toOut, ...bound], 'none.vtp: there is no such file'],
  [['reduce', 'in.vtp', ...toOut, ...bound, '--report', 'no/r.json'], 'no/r.json: there is no such file or folder'],
  [
    ['reduce', 'in.vtp', ...toOut, '-b', 'presure=1%'],
    /in\.vtp: there is no variable “presure”; .*“position”, “pressure”, “velocity”/,
  ],
  [['reduce', 'in.vtp', ...toOut, ...bound, '--exclude', 'heat'], /no variable “heat”; the variables are “position”/],
  // More than memory could hold.
  [
    ['reduce', 'in.vtp', ...toOut, ...bound, '--lock-points', '3,0-4294967294'],
    'in.vtp: There is no point 4294967294 to lock: the surface has 25, counted from 0.',
  ],
  [['reduce', 'in.vtp', ...toOut, ...bound, '--lock-points', '25'], 'in.vtp: There is no point 25 to lock'],
  [['reduce', 'in.vtp', ...toOut, '--levels', '3%,1%'], /in\.vtp: The bound of “position” falls .* level 1 .* level 2/],
  [['reduce', 'in.vtp', ...toOut, '--levels', '3%,3%'], 'in.vtp: The bounds of level 2 are those of level 1'],
  [['reduce', 'in.vtp', ...toOut, '-b', 'pressure=1e-30'], 'in.vtp: The bound of “pressure”'],
  [
    ['reduce', 'in.vtp', ...toOut, '-b', '*=1%', '-b', 'position=free', '--limit-to-feature-size'],
    'in.vtp: Limiting to the feature size needs a bound of “position”, which is free.',
  ],
  [
    ['reduce', 'in.vtp', ...toOut, '-b', 'pressure=1%', '--drop-small-components'],
    'in.vtp: Leaving out small parts needs a bound of “position”, which is free.',
  ],
  [
    ['reduce', 'in.vtp', ...toOut, '--levels', '1%,3%', '-b', 'position=free', '--drop-small-components'],
    'in.vtp: Of level 1: Leaving out small parts needs',
  ],
  [
    ['reduce', 'nan.vtp', ...toOut, ...bound],
    /nan\.vtp: .*“pressure” is not a number at vertex 3;.* --bound "pressure=free"\. .*--exclude "pressure"\./,
  ],
  [
    ['reduce', 'nan.vtp', ...toOut, '--levels', '1%,3%'],
    /nan\.vtp: .*“pressure” is not a number at vertex 3;.* --bound "pressure=free"\. .*--exclude "pressure"\./,
  ],
  [
    ['convert', 'nan.vtp', 'out.glb'],
    /out\.glb: GLB cannot hold the value NaN of “pressure”.* --exclude "pressure"\.$/m,
  ],
  [['convert', 'in.vtp', 'out.ply', '--exclude', 'heat'], /in\.vtp: there is no variable “heat”/],
  [
    ['reduce', 'in.vtp', ...toOut, ...bound, '--map', 'm.stl'],
    'm.stl: STL has no place for the variables “reduced_triangle”',
  ],
  [
    ['reduce', 'map.vtp', ...toOut, ...bound, '--map', 'm.vtp'],
    'map.vtp: --map needs the names of the variables “pressure_error”',
  ],
  [
    ['verify', 'in.vtp', 'line.ply', '-b', 'position=1%'],
    'line.ply: there is no triangle with three distinct vertices',
  ],
  [['verify', 'in.vtp', 'none.vtp', ...bound], 'none.vtp: there is no such file'],
  [
    ['verify', 'in.vtp', 'nan.vtp', ...bound],
    /nan\.vtp: “pressure” is not a number at point 3;.* --bound "pressure=free"\. .*--exclude "pressure"\./,
  ],
  [['verify', 'in.vtp', 'map.vtp', ...bound], 'map.vtp: there is no variable “velocity”'],
  [['verify', 'in.vtp', 'in.vtp', '-b', 'presure=1%'], /in\.vtp: there is no variable “presure”/],
];

async function expectFault(args: string[], message: RegExp | string) {
  const before = folder.files();
  const { status, stdout, stderr } = await folder.run(...args);
  expect({ status, stdout }).toEqual({ status: 2, stdout: '' });
  expect(stderr).toMatch(message);
  expect(stderr).not.toMatch(/\n\s+at /);
  expect(folder.files()).toEqual(before);
  return stderr;
}

describe('a wrong command line is explained, with status 2 and where to look it up', () => {
  test.each(usageFaults)('meshbound %j', async (args, message) => {
    const command = args.length > 0 && args[0] !== 'shrink' ? `${args[0]} ` : '';
    expect(await expectFault(args, message)).toContain(`Try: meshbound ${command}--help`);
  });

  test('--bound', async () => {
    const stderr = await expectFault(['reduce', 'in.vtp', ...toOut, '--bound', 'pressure=some'], 'is not a number');
    expect(stderr).toContain('The bound “pressure=some” cannot be');
  });

  test.each(bounds)('--bound %j', (text, message) => {
    expect(() => parseBounds([text])).toThrow(`The bound “${text}” cannot be: `);
    expect(() => parseBounds([text])).toThrow(message);
  });
});

describe('a fault of a file is named with the file, with status 2', () => {
  test.each(fileFaults)('meshbound %j', async (args, message) => {
    await expectFault(args, message);
  });
});

test.each([
  ['reduce', 'nan.vtp', ...toOut, ...bound],
  ['convert', 'nan.vtp', 'out.vtp'],
])('what is broken can be left out: %s', async (...args) => {
  expect(await folder.run(...args, '--exclude', 'pressure')).toMatchObject({ status: 0 });
  const { mesh } = await folder.read('out.vtp');
  expect(mesh.variables.map(({ name }) => name)).toEqual(['velocity', 'temperature']);
});

test('a reader that stops early is no error', async () => {
  const { stderr } = await folder.runShell('meshbound inspect --json in.vtp | true');
  expect(stderr).toBe('');
});
