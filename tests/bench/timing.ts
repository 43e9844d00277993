import type { Measurement } from './cases.ts';

/** How long a quick task is repeated. */
const leastSeconds = 0.5;

/** Runs a task until half a second is full, at least once; the mean of one run. */
export function timed(task: () => void): Pick<Measurement, 'wall' | 'cpu'> {
  let runs = 0;
  const start = performance.now();
  const usage = process.cpuUsage();
  let wall = 0;
  while (wall < leastSeconds) {
    task();
    runs++;
    wall = (performance.now() - start) / 1000;
  }
  const { user, system } = process.cpuUsage(usage);
  return { wall: wall / runs, cpu: (user + system) / 1e6 / runs };
}
