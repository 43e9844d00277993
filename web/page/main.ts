import './app.ts';
import type { App } from './app.ts';
import { fetchSamples } from './toolbar/samples.ts';

const app = document.createElement('meshbound-app') as App;
document.body.prepend(app);

try {
  app.samples = await fetchSamples();
  app.begin();
} catch (error) {
  app.viewer.session.report(error);
}
