// Entry of the live page: the form runs without leaving the page, and what it says is the scene at any time.
import "./replay.css";
import "./live.css";
import { type Handle, mount } from "./component.ts";
import { button, make, say } from "./dom.ts";
import type { ReplayData } from "./format.ts";

/** What is wrong, as the server says it. */
interface Problem {
  field: string | null;
  line: number | null;
  column: number | null;
  message: string;
  help: string;
}

/** The scene as the server understood it. */
interface Drawn {
  name: string;
  toml: string;
  /** The inside of the form, filled in. */
  form: string;
  /** Path and query that carry the scene; null if it is too long for a link. */
  link: string | null;
  /** Where the balls lie at the start. */
  picture: string;
}

/** The same, run. */
interface Shot extends Drawn {
  notice: string;
  /** The command that prints the same numbers of the saved scene. */
  command: string;
  html: string;
  no_replay: string;
  replay: ReplayData | null;
}

/** A request that was answered with what is wrong. */
class Wrong extends Error {
  constructor(readonly problems: Problem[]) {
    super(problems.map((problem) => problem.message).join("; "));
  }
}

/** Most bytes of a file that is opened: what the server takes as well, with room for the rest of a request. */
const LARGEST_FILE = 200 * 1024;
/** How long to wait after the last key before the scene is drawn up anew, ms. */
const PAUSE = 350;

function need<T extends Element>(selector: string): T {
  const element = document.querySelector<T>(selector);
  if (!element) {
    throw new Error(`the page has no ${selector}`);
  }
  return element;
}

class Live {
  private readonly form = need<HTMLFormElement>("#shot");
  private readonly tools = need<HTMLElement>("#tools");
  private readonly status = need<HTMLElement>("#status");
  private readonly lead = need<HTMLElement>("#lead");
  private readonly stage = need<HTMLElement>("#replay");
  private readonly answer = need<HTMLElement>("#answer");
  private readonly name = need<HTMLElement>("#name");
  private readonly stop = button("Stop the computation", ["Stop"], () => this.running?.abort());
  private readonly copy = button("Copy a link that carries the whole scene", ["Copy link"], () => void this.copyLink());
  private readonly save = button("Save as a scene file", ["Save scene"], () => this.saveFile());
  private readonly file = make("input", { type: "file", accept: ".toml,text/plain", class: "sr", id: "open-file" });
  private readonly calm = matchMedia("(prefers-reduced-motion: reduce)");
  /** The scene that the fields are put into. */
  private base = "";
  private link: string | null = null;
  private running: AbortController | null = null;
  private drawing: AbortController | null = null;
  private pause = 0;
  private replay: Handle | null = null;

  constructor() {
    this.form.noValidate = true;
    this.link = document.querySelector<HTMLAnchorElement>("#link")?.getAttribute("href") ?? null;
    this.stop.hidden = true;
    const open = make("label", { class: "file", for: "open-file" }, "Open scene …", this.file);
    this.tools.replaceChildren(this.copy, this.save, open);
    this.filledIn();
    this.form.addEventListener("submit", (event) => {
      event.preventDefault();
      void this.start((event as SubmitEvent).submitter);
    });
    this.form.addEventListener("input", (event) => this.typed(event.target));
    need<HTMLFormElement>("#picker").addEventListener("submit", (event) => {
      event.preventDefault();
      const name = need<HTMLSelectElement>("#scene").value;
      void this.load(() => ask<Drawn>(`/scenes/${encodeURIComponent(name)}`));
    });
    this.file.addEventListener("change", () => {
      const [file] = this.file.files ?? [];
      if (file) {
        void this.openFile(file);
      }
      this.file.value = "";
    });
    this.dropping();
  }

  private get text(): HTMLTextAreaElement {
    return need<HTMLTextAreaElement>("#f-scene");
  }

  /** After the inside of the form came from the server. */
  private filledIn(): void {
    this.base = this.text.value;
    this.form.querySelector(".go")?.append(this.stop);
    this.linked();
  }

  private linked(): void {
    this.copy.disabled = this.link === null;
    this.copy.title = this.link === null ? "This scene is too long for a link: save it as a file" : "Copy a link that carries the whole scene";
  }

  /** What the form says, for the server. */
  private fields(of: "form" | "file"): unknown {
    const fields: Record<string, string | string[]> = {};
    const sent = new FormData(this.form);
    for (const name of new Set(sent.keys())) {
      const values = sent.getAll(name).filter((value) => typeof value === "string");
      const engines = name === "engine" || name === "more-engines" || name.startsWith("dt.");
      if (name === "engine") {
        fields[name] = values;
      } else if (name !== "scene" && name !== "run" && (of === "form" || engines)) {
        fields[name] = values[values.length - 1] ?? "";
      }
    }
    return { scene: of === "form" ? this.base : this.text.value, fields };
  }

  /** What a browser does not let through to the server: a number field that holds no number. */
  private unreadable(): Problem[] {
    const inputs = [...this.form.querySelectorAll<HTMLInputElement>("input[type=number]")];
    return inputs
      .filter((input) => input.validity.badInput && input.offsetParent !== null)
      .map((input) => ({ field: input.name, line: null, column: null, message: `${input.labels?.[0]?.firstChild?.textContent?.trim() ?? input.name} must be a number`, help: "such as 0.2 or 1e-3" }));
  }

  private async start(submitter: HTMLElement | null): Promise<void> {
    const file = submitter instanceof HTMLButtonElement && submitter.value === "file";
    const unreadable = file ? [] : this.unreadable();
    if (unreadable.length > 0) {
      this.wrong(unreadable);
      return;
    }
    clearTimeout(this.pause);
    this.drawing?.abort();
    this.running?.abort();
    const running = new AbortController();
    this.running = running;
    this.busy(true);
    const begin = performance.now();
    try {
      const asked = this.fields(file ? "file" : "form");
      // what is wrong is found out before anything runs
      await ask<Drawn>("/scene", asked, running.signal);
      const shot = await ask<Shot>("/shot", asked, running.signal);
      this.shown(shot, file, (performance.now() - begin) / 1000);
    } catch (reason) {
      if (this.running === running) {
        this.failed(reason, "The computation was stopped.");
      }
    } finally {
      if (this.running === running) {
        this.running = null;
        this.busy(false);
      }
    }
  }

  private busy(on: boolean): void {
    const start = this.form.querySelector<HTMLButtonElement>(".start");
    start?.setAttribute("aria-busy", String(on));
    this.stop.hidden = !on;
    if (on) {
      this.say("Running …");
    }
  }

  private shown(shot: Shot, fill: boolean, seconds: number): void {
    this.correct();
    if (fill) {
      this.fill(shot);
    } else {
      this.take(shot);
    }
    const notice = shot.notice ? `<p class="notice-line">${escaped(shot.notice)}</p>` : "";
    this.answer.innerHTML = notice + shot.html;
    this.answer.append(make("p", {}, "The same numbers on a command line, with the scene saved:"), make("pre", {}, make("code", {}, shot.command)));
    this.replay?.destroy();
    this.replay = null;
    this.stage.classList.remove("stale");
    // the sentence a person came for stands first
    const lead = this.answer.querySelector(".lead");
    say(this.lead, lead?.textContent ?? "");
    lead?.remove();
    this.say(`Answered in ${seconds.toFixed(2)} s. ${shot.no_replay ? `There is no replay: ${shot.no_replay}.` : ""}`);
    if (shot.replay) {
      this.replay = mount(this.stage, shot.replay, { growing: true, autoplay: true });
    }
    if (this.stage.getBoundingClientRect().top > 0.7 * window.innerHeight) {
      this.lead.scrollIntoView({ behavior: this.calm.matches ? "auto" : "smooth", block: "start" });
    }
  }

  /** Takes what the server made of the fields, and leaves them as they are. */
  private take(drawn: Drawn): void {
    this.text.value = drawn.toml;
    this.link = drawn.link;
    say(this.name, drawn.name);
    document.title = `${drawn.name} · carom play`;
    if (drawn.link) {
      // a reload, a bookmark and the address carry the shot
      history.replaceState(null, "", drawn.link);
    }
    this.linked();
  }

  /** Takes a scene into the form. */
  private fill(drawn: Drawn): void {
    const open = [...this.form.querySelectorAll("details[open]")].map((part) => part.id);
    const at = document.activeElement?.id;
    this.form.innerHTML = drawn.form;
    for (const id of open) {
      document.getElementById(id)?.setAttribute("open", "");
    }
    this.filledIn();
    this.take(drawn);
    const picked = need<HTMLSelectElement>("#scene");
    if ([...picked.options].some((option) => option.value === drawn.name)) {
      picked.value = drawn.name;
    }
    if (at && this.form.contains(document.getElementById(at))) {
      document.getElementById(at)?.focus({ preventScroll: true });
    }
  }

  /** A field was changed, or the file. */
  private typed(target: EventTarget | null): void {
    clearTimeout(this.pause);
    const file = target === this.text;
    this.pause = window.setTimeout(() => void this.draw(file), PAUSE);
  }

  /** Lets the server draw up the scene, so that file, link and errors are those of what is in the form. */
  private async draw(file: boolean): Promise<void> {
    const unreadable = file ? [] : this.unreadable();
    if (unreadable.length > 0) {
      this.wrong(unreadable, false);
      return;
    }
    this.drawing?.abort();
    const drawing = new AbortController();
    this.drawing = drawing;
    try {
      const drawn = await ask<Drawn>("/scene", this.fields(file ? "file" : "form"), drawing.signal);
      this.correct();
      if (file) {
        const { selectionStart, selectionEnd, scrollTop } = this.text;
        const written = this.text.value;
        this.fill(drawn);
        this.text.value = written;
        this.base = written;
        this.text.setSelectionRange(selectionStart, selectionEnd);
        this.text.scrollTop = scrollTop;
      } else {
        this.take(drawn);
      }
      this.outdated(drawn);
    } catch (reason) {
      if (reason instanceof Wrong) {
        this.wrong(reason.problems, false);
      } else if (!drawing.signal.aborted) {
        this.failed(reason, "");
      }
    }
  }

  /** What is shown is no longer what the form says. */
  private outdated(drawn: Drawn): void {
    if (this.replay) {
      this.stage.classList.add("stale");
      this.answer.classList.add("stale");
      this.say("The inputs have changed since this ran.");
    } else {
      this.stage.innerHTML = drawn.picture;
      this.say("");
    }
  }

  /** Opens a scene: of the catalogue, or a file. */
  private async load(scene: () => Promise<Drawn>): Promise<void> {
    this.running?.abort();
    try {
      const drawn = await scene();
      this.correct();
      this.fill(drawn);
      this.replay?.destroy();
      this.replay = null;
      this.answer.replaceChildren();
      this.lead.replaceChildren();
      this.stage.classList.remove("stale");
      this.stage.innerHTML = drawn.picture;
      this.say(`Opened ${drawn.name}.`);
    } catch (reason) {
      this.failed(reason, "");
    }
  }

  private async openFile(file: File): Promise<void> {
    if (file.size > LARGEST_FILE) {
      this.wrong([{ field: null, line: null, column: null, message: `${file.name} has ${file.size} bytes; ${LARGEST_FILE} are the most`, help: "carom compare takes a file of any size" }]);
      return;
    }
    const text = await file.text();
    await this.load(() => ask<Drawn>("/scene", { scene: text }));
  }

  private dropping(): void {
    const { body } = document;
    const files = (event: DragEvent) => event.dataTransfer?.types.includes("Files") ?? false;
    addEventListener("dragover", (event) => {
      if (files(event)) {
        event.preventDefault();
        body.classList.add("dropping");
      }
    });
    addEventListener("dragleave", (event) => {
      if (event.relatedTarget === null) {
        body.classList.remove("dropping");
      }
    });
    addEventListener("drop", (event) => {
      body.classList.remove("dropping");
      const file = event.dataTransfer?.files[0];
      if (file) {
        event.preventDefault();
        void this.openFile(file);
      }
    });
  }

  private async copyLink(): Promise<void> {
    if (this.link === null) {
      return;
    }
    const address = location.origin + this.link;
    try {
      await navigator.clipboard.writeText(address);
      this.say("The link is copied. It works wherever carom play runs on this port.");
    } catch {
      // a browser may refuse; the address of the page is the link
      history.replaceState(null, "", this.link);
      this.say("The browser does not let a page copy: the link is in its address bar.");
    }
  }

  private saveFile(): void {
    const name = this.name.textContent || "scene";
    const address = `data:application/toml;charset=utf-8,${encodeURIComponent(this.text.value)}`;
    const anchor = make("a", { href: address, download: `${name}.toml` });
    anchor.click();
    this.say(`Saved as ${name}.toml.`);
  }

  private failed(reason: unknown, stopped: string): void {
    if (reason instanceof Wrong) {
      this.wrong(reason.problems);
    } else if (reason instanceof DOMException && reason.name === "AbortError") {
      this.say(stopped);
    } else {
      this.say("carom play does not answer: it may have been ended. Start it again with carom play.", true);
    }
  }

  /** Takes all errors away. */
  private correct(): void {
    this.form.querySelectorAll(".error").forEach((error) => error.remove());
    this.form.querySelector(".errors")?.replaceChildren();
    for (const control of this.form.querySelectorAll("[aria-invalid]")) {
      control.removeAttribute("aria-invalid");
      control.setAttribute("aria-describedby", `hint-${control.id}`);
    }
    this.stage.classList.remove("stale");
    this.answer.classList.remove("stale");
    this.status.classList.remove("wrong");
  }

  /** Shows each error at its field. */
  private wrong(problems: Problem[], focus = true): void {
    this.correct();
    const list = this.form.querySelector(".errors");
    let first: HTMLElement | null = null;
    for (const problem of problems) {
      const control = problem.field === null ? null : this.control(problem.field);
      if (!control) {
        const place = problem.line === null ? "" : `${problem.line}:${problem.column}: `;
        list?.append(make("li", {}, place, ...inline(problem.message), ". ", make("span", { class: "help" }, ...inline(problem.help))));
        continue;
      }
      const place = problem.field === "scene" && problem.line !== null ? `line ${problem.line}: ` : "";
      const id = `error-${control.id}`;
      const words = make("p", { class: "error" }, place, ...inline(problem.message), ". ", make("span", { class: "help" }, ...inline(problem.help)));
      if (!document.getElementById(id)) {
        words.id = id;
      }
      control.setAttribute("aria-invalid", "true");
      control.setAttribute("aria-describedby", `${id} hint-${control.id}`);
      control.closest(".field, .tick")?.append(words);
      control.closest("details")?.setAttribute("open", "");
      first ??= control;
    }
    const label = first?.closest(".field")?.querySelector("label")?.textContent;
    const things = problems.length === 1 ? "One thing is wrong" : `${problems.length} things are wrong`;
    const [{ message }] = problems;
    this.say(`${things}. ${label && first?.getAttribute("name") === problems[0].field ? `${label}: ` : ""}${message}.`, true);
    if (focus) {
      first?.focus();
    }
  }

  private control(name: string): HTMLElement | null {
    const named = this.form.querySelectorAll<HTMLElement>(`[name="${CSS.escape(name)}"]:not([type=hidden])`);
    return named[0] ?? null;
  }

  private say(words: string, wrong = false): void {
    this.status.replaceChildren(...inline(words));
    this.status.classList.toggle("wrong", wrong);
  }
}

function escaped(text: string): string {
  return make("p", {}, text).innerHTML;
}

/** Words; what stands between two backticks is code. */
function inline(words: string): (string | HTMLElement)[] {
  return words.split("`").map((part, i) => (i % 2 === 1 ? make("code", {}, part) : part));
}

/** Asks the server; throws a `Wrong` where it says what is wrong. */
async function ask<T>(path: string, body?: unknown, signal?: AbortSignal): Promise<T> {
  const options: RequestInit = body === undefined ? {} : { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(body) };
  const response = await fetch(path, { ...options, signal: signal ?? null });
  const answer = (await response.json()) as T & { errors?: Problem[] };
  if (answer.errors || !response.ok) {
    throw new Wrong(answer.errors ?? [{ field: null, line: null, column: null, message: `the server answered ${response.status}`, help: "" }]);
  }
  return answer;
}

new Live();
