// Colours of balls and runs.

/** How a ball is painted. */
export interface Paint {
  colour: string;
  striped: boolean;
  /** What stands on it; empty for a ball without. */
  label: string;
  /** A white ball with red spots, so that its turning is seen. */
  spotted: boolean;
}

const POOL = ["#f2b705", "#1747b0", "#d3202a", "#4b2a86", "#f26a1b", "#0b6b3a", "#7d1a22", "#16181a"];
const OTHERS = ["#c8452f", "#2f6fb0", "#e0a526", "#3d8f63", "#8a5aa8", "#d9793a", "#4aa0a8", "#b0567c", "#7a8a2e", "#5a6b7a"];
const IVORY = "#f6f1e4";

/** A ball's paint by its name: pool balls as in pool, the cue ball white, all others by index. */
export function paint(id: string, index: number): Paint {
  if (/^(cue|white)$/i.test(id)) {
    return { colour: IVORY, striped: false, label: "", spotted: true };
  }
  const number = /^\d{1,2}$/.test(id) ? Number(id) : 0;
  if (number >= 1 && number <= 15) {
    return { colour: POOL[(number - 1) % 8], striped: number > 8, label: String(number), spotted: false };
  }
  const short = [...id].length <= 3 ? id : [...id].slice(0, 3).join("");
  return { colour: OTHERS[index % OTHERS.length], striped: false, label: short, spotted: false };
}

/** How a run is told from the others: a colour for light and dark paper, one for the cloth, and dashes. */
export interface Ink {
  light: string;
  dark: string;
  cloth: string;
  /** On and off, px; empty for a full line. */
  dash: number[];
  /** Dashes around a ball; 0 for a full ring. */
  beats: number;
}

/** In the order of the pictures of the report. */
const INKS: Ink[] = [
  { light: "#0072b2", dark: "#4aa3e0", cloth: "#7cc8ff", dash: [], beats: 0 },
  { light: "#b84e00", dark: "#ff8a3c", cloth: "#ff9a4d", dash: [7, 4], beats: 8 },
  { light: "#007a59", dark: "#2fc79a", cloth: "#9dffd8", dash: [2, 3], beats: 16 },
  { light: "#a0437c", dark: "#e08ac0", cloth: "#ff9ddb", dash: [10, 3, 2, 3], beats: 5 },
  { light: "#8a5f00", dark: "#edb93c", cloth: "#ffe066", dash: [14, 5], beats: 4 },
  { light: "#1f7aa8", dark: "#9bd3f5", cloth: "#d5efff", dash: [5, 2, 1, 2], beats: 12 },
  { light: "#1d2429", dark: "#e4e8eb", cloth: "#ffffff", dash: [1, 2], beats: 20 },
];

export function ink(index: number): Ink {
  return INKS[index % INKS.length];
}

/** The colour of a run on the page as it is now. */
export function inkNow(index: number): string {
  return matchMedia("(prefers-color-scheme: dark)").matches ? ink(index).dark : ink(index).light;
}
