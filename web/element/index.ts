import { MeshboundViewer } from './meshbound-viewer.ts';

export { MeshboundViewer };

customElements.define('meshbound-viewer', MeshboundViewer);

declare global {
  interface HTMLElementTagNameMap {
    'meshbound-viewer': MeshboundViewer;
  }
}
