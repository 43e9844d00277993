/** Every buffer that is reachable from a plain value, so that a message moves its arrays instead of copying them. */
export function transferables(value: unknown): ArrayBuffer[] {
  const buffers = new Set<ArrayBuffer>();
  collect(value, buffers);
  return [...buffers];
}

function collect(value: unknown, buffers: Set<ArrayBuffer>): void {
  if (ArrayBuffer.isView(value)) {
    // Shared memory is shared by every message and cannot be moved.
    if (value.buffer instanceof ArrayBuffer) {
      buffers.add(value.buffer);
    }
  } else if (typeof value === 'object' && value !== null) {
    for (const part of Object.values(value)) {
      collect(part, buffers);
    }
  }
}
