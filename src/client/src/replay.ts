// Entry of the report's pages: every `<script type="application/json" class="replay-data">` within a `<div class="replay">` becomes a replay.
import "./replay.css";
import { mount } from "./component.ts";
import type { ReplayData } from "./format.ts";

function start(): void {
  for (const script of document.querySelectorAll<HTMLScriptElement>("script.replay-data")) {
    const root = script.closest<HTMLElement>(".replay");
    if (root && script.textContent) {
      mount(root, JSON.parse(script.textContent) as ReplayData);
    }
  }
}

if (document.readyState === "loading") {
  document.addEventListener("DOMContentLoaded", start);
} else {
  start();
}
