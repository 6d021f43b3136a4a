/** What is said in both languages. */
export type Language = 'en' | 'es';
export type Worded = Record<Language, string>;
