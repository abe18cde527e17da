// The page: what there is, what a person does with it, and what is told to others.

const find = (id) => document.getElementById(id);

function follows(query, then) {
  const media = window.matchMedia(query);
  media.addEventListener("change", () => then(media.matches));
  then(media.matches);
}

async function opened() {
  const data = JSON.parse(find("data").textContent);
  data.map.obstacles = new Uint8Array(await inflated(data.map.obstacles));
  return Promise.all(data.colonies.map((packed) => Colony.unpacked(packed, data)));
}

function head(colonies) {
  const [{ map, seed }] = colonies;
  document.querySelector("main").dataset.colonies = colonies.length;
  find("title").textContent = `${colonies.map((one) => one.name).join(" · ")} on ${map.name}`;
  const ants = [...new Set(colonies.map((one) => one.size))].join(", ");
  find("about").textContent = `seed ${seed} · ${map.rows} × ${map.cols} cells · ${ants} ants a cycle` +
    (colonies.some((one) => one.size > one.shown) ? `, ${colonies[0].shown} of them shown` : "");
}

function start(colonies) {
  const cycles = Math.max(...colonies.map((one) => one.cycles));
  const point = (cell) => boards.forEach((board) => { board.cell = cell; board.redraw(); board.tellCell(); });
  const boards = colonies.map((colony, place) => new Board(colony, place, point));
  find("boards").append(...boards.map((board) => board.element));
  const player = new Player(cycles, show);
  const chart = new Chart(document.querySelector("#chart svg"), colonies, (cycle) => player.seek(cycle));

  function show() {
    const cycle = Math.ceil(player.time), slider = find("slider");
    for (const board of boards) board.show(player.time);
    chart.show(player.time);
    slider.max = cycles;
    slider.value = cycle;
    slider.setAttribute("aria-valuetext", `cycle ${cycle} of ${cycles}`);
    set("cycle", `cycle ${cycle} of ${cycles}`);
    set("speed", `${player.speed} cycle${player.speed === 1 ? "" : "s"}/s`);
    find("play").classList.toggle("playing", player.playing);
    find("play").setAttribute("aria-label", player.playing ? "Pause" : "Play");
    if (!player.playing) announce(cycle);
  }

  function announce(cycle) {
    const words = boards.map(({ colony, facts }) => `${colony.name}: best so far ${facts[0].textContent}, lost ${facts[2].textContent}`);
    set("status", `Cycle ${cycle}. ${words.join(". ")}.`);
    boards.forEach((board, i) => board.canvas.setAttribute("aria-label", `Map of cycle ${cycle}. ${words[i]}.`));
  }

  function dress() {
    drawScale(document.querySelector(".scale canvas"), rampOf(theme.name));
    for (const board of boards) board.dress();
    chart.draw();
    show();
  }

  follows("(prefers-color-scheme: dark)", (dark) => { theme.name = dark ? "dark" : "light"; dress(); });
  listen(player, () => { theme.toggle(); dress(); });
  return { player, boards };
}

function set(id, text) {
  const element = find(id);
  if (element.textContent !== text) element.textContent = text;
}

function listen(player, toggleTheme) {
  const help = () => { if (!find("help").open) find("help").showModal(); };
  const clicks = {
    play: () => player.toggle(), back: () => player.step(-1), on: () => player.step(1), ask: help,
    slower: () => player.faster(-1), faster: () => player.faster(1), theme: toggleTheme,
  };
  for (const [id, act] of Object.entries(clicks)) find(id).addEventListener("click", act);
  find("slider").addEventListener("input", (event) => { player.pause(); player.seek(Number(event.target.value)); });
  const keys = {
    " ": clicks.play, ArrowLeft: clicks.back, ArrowRight: clicks.on, "+": clicks.faster, "=": clicks.faster,
    "-": clicks.slower, t: toggleTheme, "?": help, Home: () => player.step(-Infinity), End: () => player.step(Infinity),
  };
  document.addEventListener("keydown", (event) => {
    const own = event.target.matches("button, dialog *") && event.key === " ";  // which presses the button
    if (own || find("help").open || event.ctrlKey || event.metaKey || event.altKey || !keys[event.key]) return;
    event.preventDefault();
    keys[event.key]();
  });
}

/** Cells as [row, col], for others. */
function placed({ cols }, cells) {
  return cells ? Array.from(cells, (cell) => [Math.floor(cell / cols), cell % cols]) : null;
}

const colonies = await opened();
head(colonies);
const { player, boards } = start(colonies);

// for programs that drive the page, tests among them
window.acoexp = {
  get time() { return player.time; },
  get playing() { return player.playing; },
  get speed() { return player.speed; },
  cycles: player.cycles,
  seek: (time) => { player.pause(); player.seek(time); },
  play: () => player.play(),
  pause: () => player.pause(),
  colonies: boards.map((board) => ({
    name: board.colony.name,
    shownCycle: () => board.after,
    path: () => placed(board.map, board.colony.bestBy(board.after)?.cells),
    ways: () => board.colony.ants(board.cycle).map(({ cells, lost }) => ({ cells: placed(board.map, cells), lost })),
    pheromone: (row, col) => board.colony.byteAt(row * board.map.cols + col, board.after),
  })),
};
