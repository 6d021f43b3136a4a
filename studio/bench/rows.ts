// What every measurement here prints at its end: name, figure, bar.
export interface Row {
  name: string;
  figure: string;
  bar: string;
  met: boolean;
}

const rows: Row[] = [];

export function row(name: string, figure: string, bar = '', met = true): void {
  rows.push({ name, figure, bar, met });
}

/** A figure that must be at most, or at least, so much. */
export function atMost(name: string, figure: number, bar: number, unit: string, digits = 0): void {
  row(name, `${figure.toFixed(digits)} ${unit}`, `<= ${bar} ${unit}`, figure <= bar);
}

export function atLeast(name: string, figure: number, bar: number, unit: string, digits = 0): void {
  row(name, `${figure.toFixed(digits)} ${unit}`, `>= ${bar} ${unit}`, figure >= bar);
}

/** Prints what was measured since the last time. */
export function printRows(): void {
  const wide = (pick: (one: Row) => string) => Math.max(...rows.map((one) => pick(one).length));
  const [name, figure, bar] = [wide((one) => one.name), wide((one) => one.figure), wide((one) => one.bar)];
  for (const one of rows) {
    const mark = one.met ? '' : '  FALLS SHORT';
    process.stdout.write(`${one.name.padEnd(name)}  ${one.figure.padStart(figure)}  ${one.bar.padEnd(bar)}${mark}\n`);
  }
  rows.length = 0;
}

/** The value that a share of the sorted ones does not exceed. */
export function quantile(values: readonly number[], share: number): number {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))];
}
