// Pages without a player: only the language can be changed.

dictionary = JSON.parse(document.getElementById('words').textContent);
speak(document.documentElement.lang);
document.getElementById('language').addEventListener('click', () => speak(language === 'en' ? 'es' : 'en'));
