import { arrow, box, dot, drawing, type Point, text } from './svg.ts';

/** A folder of the house: its name, and what it is. */
function room([x, y]: Point, width: number, fill: string, name: string, ...words: string[]): string {
  return [
    box(`${fill} veil`, [x, y], width, 34 + 16 * words.length),
    text('title', [x + 12, y + 22], name),
    ...words.map((word, n) => text('small', [x + 12, y + 40 + 16 * n], word)),
  ].join('');
}

function step(number: number, at: Point): string {
  return `${dot('fill-orange', at, 9)}<text class="small middle paper" x="${at[0]}" y="${at[1] + 4}">${number}</text>`;
}

/** The folders, what depends on what (downwards), and the way of one mesh through them. */
export function architecture(): string {
  const way: [Point, Point][] = [
    [
      [70, 46],
      [70, 170],
    ],
    [
      [176, 203],
      [234, 203],
    ],
    [
      [320, 236],
      [320, 320],
    ],
    [
      [320, 370],
      [320, 440],
    ],
    [
      [470, 440],
      [470, 370],
    ],
    [
      [470, 320],
      [470, 236],
    ],
    [
      [470, 170],
      [470, 92],
    ],
    [
      [556, 82],
      [640, 170],
    ],
    [
      [130, 170],
      [130, 46],
    ],
  ];
  const middle = ([from, to]: [Point, Point]): Point => [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2];
  return drawing(760, 530, 'The folders of the project and the way of one mesh through them', [
    text('title', [62, 34], 'a file … a file'),
    room([206, 42], 170, 'fill-blue', 'web/page', 'the page around it'),
    room([386, 42], 170, 'fill-blue', 'web/element', 'viewers and legends (Lit)'),
    room([24, 170], 152, 'fill-green', 'web/formats', 'readers and writers', 'of six formats'),
    room([234, 170], 322, 'fill-green', 'web/session', 'what is open, what is asked of it,', 'what came of it'),
    room([588, 170], 148, 'fill-green', 'web/viewer', 'three.js; knows', 'triangles and colours'),
    room([206, 320], 350, 'fill-violet', 'wasm', 'TypeScript API, queue, worker, bindings (Embind)'),
    room([206, 440], 350, 'fill-orange', 'core', 'the reduction: C++20 and GLM, no file, no browser'),
    room([24, 320], 152, 'fill-blue', 'web/node-cli', 'command line (Node)'),
    room([24, 440], 152, 'fill-soft', 'a C++ program', 'links meshbound::core'),
    room([588, 440], 148, 'fill-orange', 'core/src/verify', 'the judge: knows', 'two meshes, bounds'),
    arrow('soft', [376, 67], [386, 67]),
    arrow('soft', [290, 92], [290, 170]),
    arrow('soft', [100, 320], [100, 236]),
    arrow('soft', [176, 345], [206, 345]),
    arrow('soft', [176, 465], [206, 465]),
    ...way.map(([from, to]) => arrow('line orange', from, to)),
    ...way.map((leg, n) => step(n + 1, middle(leg))),
    text('small soft-text middle', [380, 516], 'grey: what uses what · orange, 1 to 9: the way of one mesh'),
  ]);
}
