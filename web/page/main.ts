import { inspect, reduce } from '../../wasm/index.ts';
import { readInWorker } from '../session/read.ts';
import { fetchBytes, fetchSamples } from '../session/samples.ts';
import { Session } from '../session/session.ts';
import './app.ts';
import type { App } from './app.ts';

const session = new Session({ inspect, reduce, read: readInWorker, fetchBytes });
const app = document.createElement('meshbound-app') as App;
app.session = session;
document.body.prepend(app);

try {
  app.samples = await fetchSamples();
  if (app.samples.length > 0) app.openSample(app.samples[0]);
} catch (error) {
  session.report(error);
}
