import './app.ts';
import type { App } from './app.ts';
import { fetchSamples } from './samples.ts';

const app = document.createElement('meshbound-app') as App;
document.body.prepend(app);

try {
  app.samples = await fetchSamples();
  if (app.samples.length > 0) app.openSample(app.samples[0]);
} catch (error) {
  app.viewer.session.report(error);
}
