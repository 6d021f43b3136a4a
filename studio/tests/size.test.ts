import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import ts from 'typescript';
import { expect, test } from 'vitest';

const kSource = join(import.meta.dirname, '..', 'src');
const kMostLines = 60;

/** Functions longer than a reader takes in, as "file:line: name has n lines". */
function tooLong(file: string, text: string): string[] {
  const kind = file.endsWith('x') ? ts.ScriptKind.TSX : ts.ScriptKind.TS;
  const source = ts.createSourceFile(file, text, ts.ScriptTarget.Latest, true, kind);
  const line = (at: number) => source.getLineAndCharacterOfPosition(at).line + 1;
  const found: string[] = [];
  const look = (node: ts.Node) => {
    if (ts.isFunctionLike(node) && 'body' in node && node.body) {
      const lines = line(node.end) - line(node.getStart()) + 1;
      const name = node.name?.getText() ?? 'a function';
      if (lines > kMostLines) found.push(`${file}:${line(node.getStart())}: ${name} has ${lines} lines`);
    }
    ts.forEachChild(node, look);
  };
  look(source);
  return found;
}

test('a function that is too long is found', () => {
  const words = (lines: number) => `\nfunction f() {${'\n'.repeat(lines - 1)}}`;
  expect(tooLong('a.ts', words(kMostLines))).toEqual([]);
  expect(tooLong('a.ts', words(kMostLines + 1))).toEqual(['a.ts:2: f has 61 lines']);
  expect(tooLong('a.tsx', `const f = () => <p>${'\n'.repeat(kMostLines)}</p>`)).toEqual([
    'a.tsx:1: a function has 61 lines',
  ]);
});

test('the page has none', () => {
  const files = readdirSync(kSource, { recursive: true, encoding: 'utf8' }).filter((file) => /\.tsx?$/.test(file));
  expect(files.length).toBeGreaterThan(50);
  expect(files.flatMap((file) => tooLong(file, readFileSync(join(kSource, file), 'utf8')))).toEqual([]);
});
