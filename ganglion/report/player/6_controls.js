// Buttons, keys, pointer and the clock that drives it all.

const $ = (id) => document.getElementById(id);

function seek(player, t) {
  player.t = Math.min(player.duration, Math.max(0, t));
  player.stale = true;
}

function play(player, playing) {
  if (playing && player.t >= player.duration) seek(player, 0);
  player.playing = playing;
  player.stale = true;
  $('play').dataset.label = playing ? 'pause' : 'play';
  $('play').setAttribute('aria-label', word($('play').dataset.label));
  $('play').title = word($('play').dataset.label);
  document.body.classList.toggle('playing', playing);
  if (playing) document.body.classList.add('begun');
  if (playing) requestAnimationFrame((now) => tick(player, now, now));
}

/** One tick of the robot forth (+1) or back (-1). */
function step(player, direction) {
  play(player, false);
  const times = player.run.robots[player.robot]?.t ?? [];
  const row = indexAt(times, player.t + 1e-6);
  const next = Math.min(times.length - 1, Math.max(0, row + direction));
  if (times.length > 0) seek(player, times[next]);
  refresh(player);
}

/** Advances the run by the wall time since the last picture; with reduced motion it moves on only twice a second. */
function tick(player, now, before) {
  if (!player.playing) return;
  const least = player.calm ? 500 : 0;
  if (now - before >= least) {
    seek(player, player.t + (Math.min(now - before, 1000) / 1000) * player.speed);
    if (player.t >= player.duration) play(player, false);
    refresh(player);
    requestAnimationFrame((next) => tick(player, next, now));
  } else {
    requestAnimationFrame((next) => tick(player, next, before));
  }
}

function listReadings(player, row) {
  const robot = player.run.robots[player.robot];
  const list = $('readings');
  const sensors = robot ? robot.sensors.slice(0, 24) : [];
  while (list.children.length > 2 * sensors.length) list.lastChild.remove();
  sensors.forEach((sensor, i) => {
    if (list.children.length <= 2 * i) list.append(document.createElement('dt'), document.createElement('dd'));
    list.children[2 * i].textContent = sensor.id;
    list.children[2 * i + 1].textContent = row < 0 ? '' : describeReading(reading(sensor, row));
  });
}

function showNow(player) {
  const robot = player.run.robots[player.robot];
  const row = robot ? indexAt(robot.t, player.t) : -1;
  const coordination = robot?.coordinations[0];
  const active = activeAt(coordination, row);
  const name = active >= 0 ? coordination.candidates[active] : word('no_behaviour');
  $('behaviour').hidden = !coordination;
  $('behaviour-name').textContent = name;
  $('behaviour-swatch').style.background = lookColour(player.colours, active);
  $('clock').textContent = `${quantity(player.t, 's')} / ${quantity(player.duration, 's')}`;
  $('slider').value = String(player.t);
  $('slider').setAttribute('aria-valuetext', quantity(player.t, 's'));
  $('place').textContent =
    row >= 0 && Number.isFinite(robot.x[row] + robot.y[row])
      ? `x ${quantity(robot.x[row], 'm')}, y ${quantity(robot.y[row], 'm')}, ${((robot.yaw[row] * 180) / Math.PI).toFixed(0)}°`
      : word('no_reading');
  listReadings(player, row);
  if (!player.playing) $('told').textContent = coordination ? `${quantity(player.t, 's')}: ${name}` : quantity(player.t, 's');
}

/** Draws everything anew where something changed. */
function refresh(player) {
  if (!player.stale) return;
  player.stale = false;
  drawWorld(player);
  drawBands(player);
  drawPanels(player);
  showNow(player);
}

function redraw(player) {
  player.stale = true;
  refresh(player);
}

const KEYS = {
  ' ': (player) => play(player, !player.playing),
  ',': (player) => step(player, -1),
  '.': (player) => step(player, 1),
  ArrowLeft: (player, event) => seek(player, player.t - (event.shiftKey ? 10 : 1)),
  ArrowRight: (player, event) => seek(player, player.t + (event.shiftKey ? 10 : 1)),
  Home: (player) => seek(player, 0),
  End: (player) => seek(player, player.duration),
};

/** Keys work wherever they have no other meaning. */
function connectKeys(player) {
  document.addEventListener('keydown', (event) => {
    const inField = event.target.closest('input, select, textarea, summary, a');
    const onButton = event.key === ' ' && event.target.closest('button');
    if (inField && !(event.target.type === 'checkbox' && event.key !== ' ')) return;
    if (onButton || event.ctrlKey || event.altKey || event.metaKey || !KEYS[event.key]) return;
    event.preventDefault();
    KEYS[event.key](player, event);
    refresh(player);
  });
}

function connectPointer(player) {
  const seekTo = (event) => {
    seek(player, bandsTime(player, event.clientX - player.bands.getBoundingClientRect().left));
    refresh(player);
  };
  player.bands.addEventListener('pointerdown', (event) => {
    player.bands.setPointerCapture(event.pointerId);
    seekTo(event);
  });
  player.bands.addEventListener('pointermove', (event) => event.buttons && seekTo(event));
  const stage = $('stage');
  stage.addEventListener('wheel', (event) => {
    if (!event.ctrlKey && !event.shiftKey) return;
    event.preventDefault();
    const box = stage.getBoundingClientRect();
    zoomAt(player.view, Math.exp(-(event.deltaY || event.deltaX) / 300), event.clientX - box.left, event.clientY - box.top);
    redraw(player);
  }, { passive: false });
  stage.addEventListener('pointermove', (event) => {
    if (!event.buttons || player.view.zoom === 1) return;
    player.view.centre[0] -= event.movementX / player.view.scale;
    player.view.centre[1] += event.movementY / player.view.scale;
    redraw(player);
  });
}

function connectButtons(player) {
  $('play').addEventListener('click', () => play(player, !player.playing));
  $('big-play').addEventListener('click', () => play(player, true));
  $('back').addEventListener('click', () => step(player, -1));
  $('forth').addEventListener('click', () => step(player, 1));
  for (const [id, factor] of [['nearer', 1.4], ['farther', 1 / 1.4]]) {
    $(id).addEventListener('click', () => {
      zoomAt(player.view, factor, ...player.view.middle);
      redraw(player);
    });
  }
  $('slider').addEventListener('input', (event) => {
    seek(player, Number(event.target.value));
    refresh(player);
  });
  $('speed').addEventListener('change', (event) => {
    player.speed = Number(event.target.value);
  });
  $('robot').addEventListener('change', (event) => {
    player.robot = Number(event.target.value);
    redraw(player);
  });
  for (const box of document.querySelectorAll('[data-layer]')) {
    box.addEventListener('change', () => {
      player.layers[box.dataset.layer] = box.type === 'checkbox' ? box.checked : box.value;
      redraw(player);
    });
  }
  for (const link of document.querySelectorAll('[data-seek]')) {
    link.addEventListener('click', () => {
      seek(player, Number(link.dataset.seek));
      refresh(player);
    });
  }
  $('language').addEventListener('click', () => {
    speak(language === 'en' ? 'es' : 'en');
    redraw(player);
  });
}
