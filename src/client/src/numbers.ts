// How numbers are written.

/** Decimals that show a hundred-thousandth of `whole`, from 0 to 15. */
export function decimals(whole: number, digits = 5): number {
  return whole > 0 && Number.isFinite(whole) ? Math.min(15, Math.max(0, digits - Math.ceil(Math.log10(whole)))) : 3;
}

/** A number to so many significant digits, without a tail of zeros; with an exponent where it is very large or small. */
export function short(x: number, digits = 4): string {
  if (!Number.isFinite(x)) {
    return "–";
  }
  if (x === 0) {
    return "0";
  }
  const size = Math.abs(x);
  if (size >= 1e6 || size < 1e-3) {
    return x.toExponential(digits - 2).replace(/\.?0*e\+?/, "e");
  }
  const text = x.toPrecision(digits);
  return text.includes("e") ? String(Number(text)) : text.replace(/(\.\d*?)0+$/, "$1").replace(/\.$/, "");
}

/** A time with as many decimals as its shot calls for. */
export function timeText(t: number, end: number): string {
  return t.toFixed(decimals(end));
}
