// Node takes no TypeScript, and what compiles it in the main thread does not reach a worker's. So the worker starts here.
import { register } from 'tsx/esm/api';

register();
await import('./worker.ts');
