/** Enough TOML to compare controllers: sections and one `key = value` a line, comments and [layout] left out, order of
 *  keys within a section not kept. Ids are what both sides were built with. */
export function plain(toml: string): string[] {
  const sections: string[][] = [[]];
  for (const line of toml.split('\n')) {
    const words = line.replace(/\s+#.*$/, '').trim();
    if (words === '' || words.startsWith('#')) continue;
    if (words.startsWith('[')) sections.push([words]);
    else sections[sections.length - 1].push(canonical(words));
  }
  return sections
    .filter(([head]) => head !== '[layout]')
    .map((section, i) => (i === 0 ? section.sort() : [section[0], ...section.slice(1).sort()]).join('\n'));
}

/** Numbers by value: 3.0 and 3 are the same. */
function canonical(line: string): string {
  const [key, value] = line.split(/ = (.*)/);
  return /^[-+.\d]+$/.test(value) ? `${key} = ${Number(value)}` : line;
}
