// The program under test: what CAROM names, or what was built last.
import assert from "node:assert/strict";
import { statSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const root = join(dirname(fileURLToPath(import.meta.url)), "../..");

export function program() {
  if (process.env.CAROM) {
    return process.env.CAROM;
  }
  const built = ["release", "debug"].map((profile) => join(root, "target", profile, "carom")).filter((file) => statSync(file, { throwIfNoEntry: false }));
  built.sort((a, b) => statSync(b).mtimeMs - statSync(a).mtimeMs);
  assert.ok(built.length > 0, "there is no carom to test: cargo build");
  return built[0];
}
