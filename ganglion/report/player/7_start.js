// Puts the player together from what the page carries.

function makePlayer(run) {
  const layers = {};
  for (const box of document.querySelectorAll('[data-layer]')) {
    layers[box.dataset.layer] = box.type === 'checkbox' ? box.checked : box.value;
  }
  return {
    run,
    view: new View($('stage'), run.bounds),
    bands: $('bands'),
    panels: makePanels(run),
    duration: Math.max(run.duration, 1e-3),
    colours: readColours(run.roles),
    layers,
    robot: 0,
    t: 0,
    speed: 1,
    playing: false,
    stale: true,
    calm: false,
    smooth: true,
  };
}

/** Follows what the reader's system asks for: light or dark, motion or none. */
function followSystem(player) {
  const dark = window.matchMedia('(prefers-color-scheme: dark)');
  dark.addEventListener('change', () => {
    player.colours = readColours(player.run.roles);
    redraw(player);
  });
  const calm = window.matchMedia('(prefers-reduced-motion: reduce)');
  const follow = () => {
    player.calm = calm.matches;
    player.smooth = !calm.matches;
  };
  calm.addEventListener('change', follow);
  follow();
  new ResizeObserver(() => redraw(player)).observe($('stage'));
}

/** A link to a moment: "#t=12.5&lang=es&robot=1", each part optional. */
function followLink(player) {
  const asked = new URLSearchParams(window.location.hash.slice(1));
  const robot = Number(asked.get('robot'));
  if (player.run.robots[robot]) {
    player.robot = robot;
    $('robot').value = String(robot);
  }
  const t = Number.parseFloat(asked.get('t'));
  if (Number.isFinite(t)) {
    seek(player, t);
    document.body.classList.add('begun');
  }
  speak(asked.get('lang') ?? document.documentElement.lang);
}

function start() {
  dictionary = JSON.parse($('words').textContent);
  const player = makePlayer(decodeRun(JSON.parse($('run').textContent)));
  $('slider').max = String(player.duration);
  connectButtons(player);
  connectPointer(player);
  connectKeys(player);
  followSystem(player);
  followLink(player);
  window.addEventListener('hashchange', () => {
    followLink(player);
    redraw(player);
  });
  document.body.classList.add('ready');
  refresh(player);
}

start();
