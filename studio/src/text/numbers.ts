import type { Value } from '../api/types';

/** A number as files write it: with a point. A comma is taken as one while typing. */
export function numberOf(words: string): number | null {
  const plain = words.trim().replace(',', '.');
  const value = Number(plain);
  return plain === '' || !Number.isFinite(value) ? null : value;
}

export function shown(value: Value): string {
  if (Array.isArray(value)) return value.join(' ');
  return typeof value === 'number' ? `${Number(value.toPrecision(12))}` : `${value}`;
}

/** For reading only: pi need not fill a line. */
export function rounded(value: number): string {
  return `${Number(value.toPrecision(4))}`;
}
