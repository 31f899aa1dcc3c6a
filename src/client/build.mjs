// Bundles the client: `node build.mjs [FOLDER]` writes replay.js, replay.css, live.js and live.css (default: dist).
//
// Reproducible: the same sources and lock file give the same bytes, which is what `.ci/pages` compares.
import { build } from "esbuild";
import { mkdirSync, rmSync, statSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const out = process.argv[2] ?? join(here, "dist");

rmSync(out, { recursive: true, force: true });
mkdirSync(out, { recursive: true });
await build({
  absWorkingDir: here,
  entryPoints: ["src/replay.ts", "src/live.ts"],
  outdir: out,
  bundle: true,
  minify: true,
  format: "iife",
  platform: "browser",
  target: "es2022",
  charset: "utf8",
  legalComments: "none",
  banner: { js: "/* carom. Contains three.js and uPlot, MIT; texts in src/client/LICENSES. */" },
  logLevel: "warning",
});
for (const name of ["replay.js", "replay.css", "live.js", "live.css"]) {
  const bytes = statSync(join(out, name)).size;
  console.log(`${name.padEnd(10)} ${String(bytes).padStart(7)} bytes`);
}
