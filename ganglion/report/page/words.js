// The page in two languages: every word comes from the dictionary in the page's data.

let language = 'en';
let dictionary = { en: {}, es: {} };

function word(key) {
  return dictionary[language][key] ?? key;
}

/** Words everything marked with data-word (text), data-en and data-es (recorded words) or data-label (accessible name) anew. */
function speak(tag) {
  language = tag === 'es' ? 'es' : 'en';
  document.documentElement.lang = language;
  for (const element of document.querySelectorAll('[data-word]')) element.textContent = word(element.dataset.word);
  for (const element of document.querySelectorAll('[data-en]')) {
    element.textContent = language === 'es' ? element.dataset.es : element.dataset.en;
    element.lang = language;
  }
  for (const element of document.querySelectorAll('[data-label]')) {
    element.setAttribute('aria-label', word(element.dataset.label));
    if (element.tagName === 'BUTTON') element.title = word(element.dataset.label);
  }
}

const DECIMALS = { s: 1, m: 2 };

/** "1.25 m"; always with the decimal point, as the files have it. */
function quantity(value, unit) {
  return `${value.toFixed(DECIMALS[unit] ?? 3)} ${unit}`;
}

function describeReading(range) {
  if (Number.isNaN(range)) return word('no_reading');
  if (range === Number.POSITIVE_INFINITY) return word('nothing_in_range');
  if (range === Number.NEGATIVE_INFINITY) return word('too_close');
  return quantity(range, 'm');
}
