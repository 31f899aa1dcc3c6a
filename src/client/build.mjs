// Bundles the client: `node build.mjs [FOLDER]` writes replay.js, replay.css, live.js and live.css (default: dist).
//
// Reproducible: the same sources and lock file give the same bytes, which is what `.ci/pages` compares.
import { build } from "esbuild";
import { mkdirSync, readFileSync, rmSync, statSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const out = process.argv[2] ?? join(here, "dist");

/** Shaders of materials that the replay does not use: they would be a tenth of the bundle. */
const UNUSED = /(physical|transmission|clearcoat|iridescence|toon|matcap|phong|cube_uv|ltc)\w*\.glsl\.js$/;

/** three from its modules, its shaders without comments, indentation and what is not used. */
const three = {
  name: "three",
  setup(bundle) {
    const entry = join(here, "node_modules/three/src/Three.js");
    bundle.onResolve({ filter: /^three$/ }, () => ({ path: entry, sideEffects: false }));
    bundle.onLoad({ filter: /\.glsl\.js$/ }, ({ path }) => ({
      contents: readFileSync(path, "utf8").replace(/\/\* glsl \*\/\s*`([^`]*)`/g, (_, shader) => `\`${UNUSED.test(path) ? "" : plain(shader)}\``),
    }));
  },
};

function plain(shader) {
  return shader.replace(/\/\*[^]*?\*\//g, "").replace(/\/\/.*/g, "").replace(/[ \t]+/g, " ").replace(/\s*\n\s*/g, "\n");
}

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
  plugins: [three],
  logLevel: "warning",
});
for (const name of ["replay.js", "replay.css", "live.js", "live.css"]) {
  const bytes = statSync(join(out, name)).size;
  console.log(`${name.padEnd(10)} ${String(bytes).padStart(7)} bytes`);
}
