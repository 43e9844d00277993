import { defineConfig } from 'vitest/config';

export default defineConfig({
  test: {
    include: ['tests/**/*.test.ts'],
    exclude: ['tests/e2e/**'],
    // A test that hangs must end; one that shares its cores with other work must not fail for it.
    testTimeout: 120_000,
    hookTimeout: 120_000,
  },
});
