import { defineConfig } from "vite";
import { viteSingleFile } from "vite-plugin-singlefile";

// One file with all code and style in it: the template that `terp report` fills.
export default defineConfig({
  plugins: [viteSingleFile()],
  build: { target: "es2022", modulePreload: false, reportCompressedSize: false },
});
