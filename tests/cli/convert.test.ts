import { mkdirSync, readFileSync, rmSync } from 'node:fs';
import { gunzipSync } from 'node:zlib';
import { NodeIO } from '@gltf-transform/core';
import { beforeAll, expect, test } from 'vitest';
import { writeSurface } from '../../web/formats/write.ts';
import { Folder } from './command.ts';
import { engine } from './engine.ts';

const folder = new Folder();
const mesh = engine(4);

beforeAll(() => folder.save('engine.vtp', mesh));

test.each(['vtk', 'ply', 'vtp'])('to .%s keeps every number, name and precision', async (ending) => {
  const outcome = await folder.run('convert', 'engine.vtp', `out.${ending}`);
  expect(outcome).toEqual({ status: 0, signal: null, stdout: '', stderr: '' });
  const { format, mesh: there } = await folder.read(`out.${ending}`);
  expect(format).toBe(ending);
  expect(there).toEqual(mesh);
});

test('cell data of whole numbers go along where the format has a place for them, all arrays of them', async () => {
  const triangles = mesh.triangles.length / 3;
  const cellData = new Map([
    ['part', Int32Array.from({ length: triangles }, (_, triangle) => triangle % 5)],
    ['material id', Int32Array.from({ length: triangles }, (_, triangle) => -triangle)],
  ]);
  folder.write('parted.vtp', await writeSurface('vtp', mesh, { cellData }));
  for (const [from, to] of [
    ['parted.vtp', 'out.vtk'],
    ['out.vtk', 'out.ply'],
    ['out.ply', 'out.vtp'],
  ]) {
    expect(await folder.run('convert', from, to)).toMatchObject({ status: 0, stderr: '' });
    expect((await folder.read(to)).regions).toEqual(cellData);
  }
  const { status, stderr } = await folder.run('convert', 'parted.vtp', 'out.obj', '--exclude', 'pressure');
  expect(status).toBe(0);
  expect(stderr).toContain('out.obj: OBJ has no place for the cell data “part”, “material id”.');
  expect(stderr).not.toContain('Not carried');
});

test('.gz behind an ending packs the file', async () => {
  await folder.run('convert', 'engine.vtp', 'out.vtk');
  await folder.run('convert', 'engine.vtp', 'out.vtk.gz');
  expect(gunzipSync(readFileSync(folder.at('out.vtk.gz')))).toEqual(readFileSync(folder.at('out.vtk')));
  const back = await folder.run('convert', 'out.vtk.gz', 'back.vtp');
  expect(back).toMatchObject({ status: 0 });
  expect((await folder.read('back.vtp')).mesh).toEqual(mesh);
});

test('what the format does not hold is said, unless --quiet', async () => {
  const { stderr } = await folder.run('convert', 'engine.vtp', 'out.stl');
  expect(stderr).toContain('out.stl: STL has no place for the variables “pressure”, “velocity”, “temperature”');
  expect(await folder.run('convert', '--quiet', 'engine.vtp', 'out.stl')).toMatchObject({ status: 0, stderr: '' });
});

test('onto itself is a file like any other', async () => {
  folder.write('self.vtp', readFileSync(folder.at('engine.vtp')));
  expect(await folder.run('convert', 'self.vtp', 'self.vtp')).toMatchObject({ status: 0 });
  expect((await folder.read('self.vtp')).mesh).toEqual(mesh);
});

test('a glTF file finds its buffers beside it; one that is missing is named', async () => {
  await folder.run('convert', 'engine.vtp', 'out.glb');
  mkdirSync(folder.at('scene'));
  const document = await new NodeIO().read(folder.at('out.glb'));
  document.getRoot().listBuffers()[0].setURI('engine.bin');
  await new NodeIO().write(folder.at('scene/engine.gltf'), document);
  expect(await folder.run('convert', 'scene/engine.gltf', 'back.glb')).toMatchObject({ status: 0, stderr: '' });
  expect((await folder.read('back.glb')).mesh).toEqual((await folder.read('out.glb')).mesh);
  rmSync(folder.at('scene/engine.bin'));
  const { status, stderr } = await folder.run('inspect', 'scene/engine.gltf');
  expect({ status, stderr }).toEqual({
    status: 2,
    stderr: 'meshbound: scene/engine.bin: there is no such file or folder.\n',
  });
});
