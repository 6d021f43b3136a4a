import { defineConfig } from 'vitest/config';

// Measurements, not tests: they print rows and fail only where something cannot be measured.
export default defineConfig({
  test: {
    include: ['bench/**/*.bench.ts'],
    environment: 'node',
    fileParallelism: false,
    testTimeout: 1_200_000,
    hookTimeout: 60_000,
    disableConsoleIntercept: true,
  },
});
