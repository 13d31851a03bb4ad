import { defineConfig } from "vite";
import { viteSingleFile } from "vite-plugin-singlefile";

// One file: the page around the solver, which solver/assemble.mjs fills with the program.
export default defineConfig({
  plugins: [viteSingleFile()],
  build: { target: "es2022", modulePreload: false, reportCompressedSize: false, outDir: "dist/solver",
    rollupOptions: { input: "solver.html" } },
});
