// Entry of the report's pages: every `<script type="application/json" class="replay-data">` within an element of class `replay`
// becomes a replay in it. The element may ask for more: data-autoplay, data-growing, data-flat.
import "./replay.css";
import { mount } from "./component.ts";
import type { ReplayData } from "./format.ts";

function start(): void {
  for (const script of document.querySelectorAll<HTMLScriptElement>("script.replay-data")) {
    const root = script.closest<HTMLElement>(".replay");
    if (root && script.textContent) {
      const { autoplay, growing, flat } = root.dataset;
      mount(root, JSON.parse(script.textContent) as ReplayData, {
        autoplay: autoplay !== undefined,
        growing: growing !== undefined,
        flat: flat !== undefined,
      });
    }
  }
}

if (document.readyState === "loading") {
  document.addEventListener("DOMContentLoaded", start);
} else {
  start();
}
