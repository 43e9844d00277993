declare module 'bunny' {
  export const positions: [number, number, number][];
  export const cells: [number, number, number][];
}
