import { loadWorkersFrom } from '../../workers/from-any-host.ts';
import { MeshboundViewer } from './meshbound-viewer.ts';

export { loadWorkersFrom, MeshboundViewer };

customElements.define('meshbound-viewer', MeshboundViewer);

declare global {
  interface HTMLElementTagNameMap {
    'meshbound-viewer': MeshboundViewer;
  }
}
