import { createHash } from "node:crypto";
import { defineConfig, type Plugin } from "vite";
import { viteSingleFile } from "vite-plugin-singlefile";

/**
 * A Content-Security-Policy for the page: nothing comes from a network, and no script runs but the page's own, known by its hash. The data of runs,
 * with names that users chose, stand in the same file.
 */
function contentSecurityPolicy(): Plugin {
  return {
    name: "content-security-policy",
    enforce: "post",
    generateBundle: { order: "post", handler(_, bundle) {
      const page = bundle["index.html"];
      if (page?.type !== "asset") throw new Error("there is no index.html to put the policy into");
      const html = String(page.source);
      const scripts = [...html.matchAll(/<script type="module"[^>]*>([\s\S]*?)<\/script>/g)].map(([, text]) => text!);
      if (scripts.length === 0 || scripts.some((text) => text === "")) throw new Error("the scripts are not in the page yet");
      const hashes = scripts.map((text) => `'sha256-${createHash("sha256").update(text, "utf8").digest("base64")}'`);
      const policy = [
        "default-src 'none'", `script-src ${hashes.join(" ")}`, "style-src 'unsafe-inline'", "img-src data: blob:", "media-src blob:",
        "base-uri 'none'", "form-action 'none'",
      ].join("; ");
      page.source = html.replace("<head>", () => `<head>\n    <meta http-equiv="Content-Security-Policy" content="${policy}" />`);
    } },
  };
}

// One file with all code and style in it: the template that `terp report` fills.
export default defineConfig({
  plugins: [viteSingleFile(), contentSecurityPolicy()],
  build: { target: "es2022", modulePreload: false, reportCompressedSize: false },
});
