import { defineConfig } from "vitest/config";

// In a real browser, one after the other.
export default defineConfig({
  test: { include: ["tests/e2e/**/*.test.ts"], testTimeout: 120_000, hookTimeout: 180_000, fileParallelism: false },
});
