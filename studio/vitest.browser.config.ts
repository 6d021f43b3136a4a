import { defineConfig } from 'vitest/config';

// One browser and one server after the other: the machine may have two cores only.
export default defineConfig({
  test: {
    include: ['browser/**/*.test.ts'],
    environment: 'node',
    fileParallelism: false,
    testTimeout: 60_000,
    hookTimeout: 60_000,
  },
});
