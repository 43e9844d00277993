import { median } from 'd3-array';
import type { Report } from '../../wasm/types.ts';

/** One step on the way. Times in milliseconds since the page began. */
interface Step {
  name: string;
  start: number;
  end: number;
  /** Of a reduction. */
  report?: Report;
}

/** From an event to the last picture that came of it. */
export interface Way {
  start: number;
  steps: Step[];
  /** Of one surface each, in the order of drawing. */
  pictures: { triangles: number; end: number }[];
}

/** Where the time of a way goes: milliseconds, one after the other, without the gaps between them. */
interface Parts {
  triangles: number;
  left: number;
  reading: number;
  checking: number;
  /** Until the original is in the picture; the reduction runs meanwhile. */
  shown: number;
  core: number;
  /** Copies and messages of the reduction. */
  around: number;
  preparing: number;
  drawing: number;
  /** Until the reduced surface is in the picture. */
  whole: number;
}

/** What answers: a reduction from a checkpoint, provisional, or the one from the original. */
type Answer = 'resumeReduction' | 'reduce';

function partsOf({ start, steps, pictures }: Way, answer: Answer = 'reduce'): Parts {
  const named = (name: string) => steps.filter((step) => step.name === name);
  const duration = (step: Step | undefined) => (step ? step.end - step.start : 0);
  const reduction = named(answer).at(-1);
  const prepared = named('prepare').find(({ end }) => reduction && end > reduction.end);
  if (!reduction?.report || !prepared) throw new Error('The page reduced nothing.');
  const { triangles: count, seconds } = reduction.report;
  const drawnAt = (triangles: number, after: number) =>
    pictures.find((picture) => picture.triangles === triangles && picture.end > after)?.end ?? Number.NaN;
  const picture = drawnAt(count.after, prepared.end);
  const core = 1000 * seconds;
  const inspection = named('inspect').at(-1);
  return {
    triangles: count.before,
    left: count.after,
    reading: duration(named('read').at(-1)),
    checking: duration(inspection),
    shown: drawnAt(count.before, 0) - start,
    core,
    around: duration(reduction) - core,
    preparing: duration(prepared),
    drawing: picture - prepared.end,
    whole: picture - start,
  };
}

/** From the choice of a file. */
export function fileTable(ways: Way[]): string {
  const head = ['triangles', 'left', 'seconds', 'reading', 'checking', 'reducing', 'around it', 'preparing', 'drawing'];
  const lines = ways
    .map((way) => partsOf(way))
    .map((parts) => [
      ...[parts.triangles, parts.left, (parts.whole / 1000).toFixed(2)],
      ...[parts.reading, parts.checking, parts.core, parts.around, parts.preparing, parts.drawing].map(share(parts)),
      share(parts)(parts.shown),
    ]);
  return markdown([...head, 'original shown after'], lines);
}

/** From the move of a slider to each answer: the median of several. A surface that is reduced at once has only one. */
export function dragTable(drags: Way[][]): string {
  const head = [
    'triangles',
    'answer',
    'left',
    'milliseconds',
    'waiting',
    'reducing',
    'around it',
    'preparing',
    'drawing',
  ];
  const lines = drags.flatMap((ways) => {
    const hasDrafts = ways.every(({ steps }) => steps.some(({ name }) => name === 'resumeReduction'));
    return [...(hasDrafts ? [dragLine(ways, 'resumeReduction')] : []), dragLine(ways, 'reduce')];
  });
  return markdown(head, lines);
}

function dragLine(ways: Way[], answer: Answer): (string | number)[] {
  const all = ways.map((way) => partsOf(way, answer));
  const middle = (part: keyof Parts) => median(all, (parts) => parts[part]) ?? 0;
  const whole = middle('whole');
  const done = middle('core') + middle('around') + middle('preparing') + middle('drawing');
  return [
    ...[middle('triangles'), answer === 'reduce' ? 'exact' : 'provisional', middle('left'), whole.toFixed(0)],
    share({ whole })(whole - done),
    ...(['core', 'around', 'preparing', 'drawing'] as const).map((part) => share({ whole })(middle(part))),
  ];
}

function share({ whole }: { whole: number }): (time: number) => string {
  return (time) => `${Math.max(0, (100 * time) / whole).toFixed(0)} %`;
}

function markdown(head: string[], lines: (string | number)[][]): string {
  return [head, head.map(() => '---:'), ...lines].map((line) => `| ${line.join(' | ')} |`).join('\n');
}
