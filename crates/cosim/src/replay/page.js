"use strict";
(() => {
  const run = JSON.parse(document.getElementById("run").textContent);
  const times = run.time, N = run.drones, last = times.length - 1, end = times[last];
  const $ = (id) => document.getElementById(id);
  const motionless = matchMedia("(prefers-reduced-motion: reduce)").matches;
  const words = { "collision": "collide", "order-lost": "lose their order", "order-restored": "are in order again" };
  const FRAME = 16;
  const state = { t: 0, playing: false, speed: 1 };
  let before = 0;

  // Between two samples positions lie on a straight line; desired ones stay where they are.
  function index(t) {
    let low = 0, high = last;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (times[middle] <= t) low = middle; else high = middle;
    }
    return t >= end ? last : low;
  }
  function placesAt(t) {
    const k = index(t), a = run.actual[k];
    if (k === last) return { actual: a, desired: run.desired[k] };
    const b = run.actual[k + 1], s = (t - times[k]) / (times[k + 1] - times[k]);
    return { actual: a.map((x, i) => x + s * (b[i] - x)), desired: run.desired[k] };
  }

  const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue("--" + name).trim();
  function surface(canvas) {
    const ratio = window.devicePixelRatio || 1, box = canvas.getBoundingClientRect();
    canvas.width = Math.max(1, Math.round(box.width * ratio));
    canvas.height = Math.max(1, Math.round(box.height * ratio));
    const g = canvas.getContext("2d");
    g.setTransform(ratio, 0, 0, ratio, 0, 0);
    g.font = "13px system-ui, sans-serif";
    return { g, w: box.width, h: box.height };
  }
  // Round numbers from low to high, about `wanted` of them.
  function ticks(low, high, wanted) {
    const raw = (high - low) / wanted, power = 10 ** Math.floor(Math.log10(raw));
    const step = [1, 2, 5, 10].map((m) => m * power).find((s) => s >= raw);
    const list = [];
    for (let k = Math.ceil(low / step); k * step <= high; k++) list.push(k * step);
    return list;
  }
  const short = (x) => String(Number(x.toPrecision(6)));

  const first = run.actual[0];
  const segment = run.segment || [Math.min(...first), Math.max(...first)];
  const span = Math.max(segment[1] - segment[0], 1e-9);

  function drawLine() {
    const { g, w, h } = surface($("line"));
    const { actual, desired } = placesAt(state.t);
    // Two segments' lengths to each side at most: a run that breaks loose does not squeeze the rest.
    let low = Math.max(Math.min(segment[0], ...actual), segment[0] - 2 * span);
    let high = Math.min(Math.max(segment[1], ...actual), segment[1] + 2 * span);
    const pad = 0.06 * (high - low);
    low -= pad; high += pad;
    const at = (x) => 24 + (w - 48) * (x - low) / (high - low);
    const left = 12, right = w - 12;
    const inside = (x) => at(x) >= left && at(x) <= right;
    const edge = (x) => Math.min(right, Math.max(left, at(x)));
    const y = h * 0.56;
    g.strokeStyle = colour("rule"); g.lineWidth = 1;
    g.fillStyle = colour("soft"); g.textAlign = "center";
    for (const x of ticks(low, high, Math.max(2, Math.min(10, Math.floor(w / 90))))) {
      g.beginPath(); g.moveTo(at(x), 12); g.lineTo(at(x), h - 26); g.stroke();
      label(g, short(x) + " m", at(x), h - 9, w);
    }
    g.strokeStyle = colour("ink"); g.lineWidth = 1.5;
    g.beginPath(); g.moveTo(at(segment[0]), y); g.lineTo(at(segment[1]), y); g.stroke();
    const wrong = new Set();
    for (let i = 0; i + 1 < N; i++) if (actual[i] > actual[i + 1]) { wrong.add(i); wrong.add(i + 1); }
    const radius = N <= 40 ? 11 : 4, labelled = N <= 40;
    const up = y - 46;
    // What is beyond the picture is no marker at its edge, but an arrow there and a word below.
    const beyond = { left: [], right: [] };
    const arrow = (x, height, name) => {
      const to = at(x) < left ? -1 : 1, tip = to < 0 ? 3 : w - 3;
      g.fillStyle = colour(name);
      g.beginPath(); g.moveTo(tip, height); g.lineTo(tip - to * 8, height - 5); g.lineTo(tip - to * 8, height + 5); g.fill();
    };
    for (let i = 0; i < N; i++) {
      for (const x of [actual[i], desired[i]]) {
        const side = at(x) < left ? "left" : at(x) > right ? "right" : null;
        if (side && !beyond[side].includes(i)) beyond[side].push(i);
      }
      if (!inside(desired[i])) { arrow(desired[i], up, "goal"); continue; }
      const x = at(desired[i]);
      g.strokeStyle = colour("goal"); g.lineWidth = 1;
      g.globalAlpha = 0.5;
      g.beginPath(); g.moveTo(edge(actual[i]), y); g.lineTo(x, up); g.stroke();
      g.globalAlpha = 1; g.lineWidth = 2;
      const r = labelled ? 7 : 3;
      g.beginPath(); g.moveTo(x, up - r); g.lineTo(x + r, up); g.lineTo(x, up + r); g.lineTo(x - r, up); g.closePath();
      g.stroke();
    }
    if (labelled) {
      g.fillStyle = colour("goal");
      spread(desired.map((x, i) => ({ at: at(x), text: String(i) })).filter((l) => l.at >= left && l.at <= right), g, w)
        .forEach((l) => g.fillText(l.text, l.at, up - 12));
    }
    for (let i = 0; i < N; i++) {
      if (!inside(actual[i])) { arrow(actual[i], y, wrong.has(i) ? "wrong" : "drone"); continue; }
      g.fillStyle = colour(wrong.has(i) ? "wrong" : "drone");
      g.beginPath(); g.arc(at(actual[i]), y, radius, 0, 2 * Math.PI); g.fill();
      if (labelled) {
        g.fillStyle = colour("paper"); g.textBaseline = "middle";
        g.fillText(i, at(actual[i]), y + 1); g.textBaseline = "alphabetic";
      }
    }
    return { actual, wrong, beyond };
  }
  // A text whose middle is at x, moved so that it stays in the picture.
  function label(g, text, x, y, w) {
    const half = g.measureText(text).width / 2 + 2;
    g.fillText(text, Math.min(w - half, Math.max(half, x)), y);
  }
  // Labels in a row, moved apart where they would lie on each other; those that are equally far.
  function spread(labels, g, w) {
    labels.sort((a, b) => a.at - b.at);
    let end = 0;
    for (const l of labels) {
      const half = g.measureText(l.text).width / 2 + 2;
      l.at = Math.max(l.at, end + half);
      end = l.at + half;
    }
    let limit = w;
    for (const l of labels.slice().reverse()) {
      const half = g.measureText(l.text).width / 2 + 2;
      l.at = Math.min(l.at, limit - half);
      limit = l.at - half;
    }
    return labels;
  }

  // The gaps' picture changes with size and theme only; the moving cursor is drawn over it.
  let gapPicture = null;
  function gapFrame(w, h) {
    let low = Infinity, high = -Infinity;
    for (const a of run.actual) for (let i = 0; i + 1 < N; i++) {
      const gap = a[i + 1] - a[i];
      if (gap < low) low = gap;
      if (gap > high) high = gap;
    }
    low = Math.max(Math.min(low, 0), -0.5 * span); high = Math.min(high, 1.2 * span);
    const pad = 0.06 * (high - low) || 1;
    low -= pad; high += pad;
    const left = 58, right = w - 14, top = 14, bottom = h - 30;
    return {
      low, high, left, right, top, bottom,
      x: (t) => left + (right - left) * t / end,
      y: (gap) => bottom - (bottom - top) * (gap - low) / (high - low),
    };
  }
  function drawGaps() {
    const { g, w, h } = surface($("gaps"));
    const f = gapFrame(w, h);
    g.fillStyle = colour("wrong-soft");
    if (f.low < 0) g.fillRect(f.left, f.y(0), f.right - f.left, f.bottom - f.y(0));
    g.strokeStyle = colour("rule"); g.fillStyle = colour("soft"); g.lineWidth = 1;
    g.textAlign = "right";
    for (const gap of ticks(f.low, f.high, 6)) {
      g.beginPath(); g.moveTo(f.left, f.y(gap)); g.lineTo(f.right, f.y(gap)); g.stroke();
      g.fillText(short(gap) + " m", f.left - 6, f.y(gap) + 4);
    }
    g.textAlign = "center";
    for (const t of ticks(0, end, Math.max(2, Math.min(10, Math.floor(w / 70))))) label(g, short(t) + " s", f.x(t), h - 10, w);
    g.strokeStyle = colour("ink"); g.lineWidth = 1.5;
    g.beginPath(); g.moveTo(f.left, f.y(0)); g.lineTo(f.right, f.y(0)); g.stroke();
    // Lines that leave the scale are cut there, and the text below says so.
    g.save();
    g.beginPath(); g.rect(f.left, f.top, f.right - f.left, f.bottom - f.top); g.clip();
    g.lineWidth = N <= 12 ? 1.8 : 1; g.globalAlpha = N <= 40 ? 1 : 0.25;
    for (let i = 0; i + 1 < N; i++) {
      g.strokeStyle = gapColour(i);
      g.setLineDash(N <= 12 ? DASHES[i % DASHES.length] : []);
      g.beginPath();
      for (let k = 0; k <= last; k++) {
        const a = run.actual[k], x = f.x(times[k]), y = f.y(a[i + 1] - a[i]);
        if (k) g.lineTo(x, y); else g.moveTo(x, y);
      }
      g.stroke();
    }
    g.restore();
    g.globalAlpha = 1;
    g.setLineDash([]);
    g.fillStyle = colour("wrong");
    for (const e of run.events) if (e.kind === "collision") {
      const x = f.x(e.time);
      g.beginPath(); g.moveTo(x - 5, f.top - 12); g.lineTo(x + 5, f.top - 12); g.lineTo(x, f.top - 3); g.fill();
    }
    gapPicture = g.getImageData(0, 0, $("gaps").width, $("gaps").height);
    return f;
  }
  // Colours that people with a colour vision deficiency can tell apart, each with a dash of its own.
  const DASHES = [[], [8, 4], [2, 3], [12, 3, 2, 3], [6, 2], [14, 5], [3, 6], [10, 3, 2, 3, 2, 3], [1, 2], [16, 3, 6, 3], [5, 5]];
  const gapColour = (i) => (N <= 12 ? colour(`gap-${i % 7}`) : colour("drone"));
  const cut = (() => {
    const f = gapFrame(100, 100), gaps = new Set();
    for (const a of run.actual) for (let i = 0; i + 1 < N; i++) {
      const gap = a[i + 1] - a[i];
      if (gap < f.low || gap > f.high) gaps.add(i);
    }
    return [...gaps].sort((a, b) => a - b);
  })();
  // The gaps' names, below the picture: each a piece that stays in one line.
  function drawLegend() {
    const list = $("gap-names");
    list.textContent = "";
    for (let i = 0; N <= 12 && i + 1 < N; i++) {
      const li = document.createElement("li"), canvas = document.createElement("canvas");
      li.append(canvas, ` ${i}–${i + 1}`);
      list.append(li);
      const { g, w, h } = surface(canvas);
      g.strokeStyle = gapColour(i); g.lineWidth = 2; g.setLineDash(DASHES[i % DASHES.length]);
      g.beginPath(); g.moveTo(0, h / 2); g.lineTo(w, h / 2); g.stroke();
    }
    $("cut").textContent = cut.length
      ? `Cut at the edge of the picture: the ${cut.length === 1 ? "gap" : "gaps"} ${cut.slice(0, 8).map((i) => `${i}–${i + 1}`).join(", ")}${cut.length > 8 ? ", .." : ""}.`
      : "";
  }
  let frame = null;
  function drawCursor() {
    const canvas = $("gaps"), g = canvas.getContext("2d");
    if (!gapPicture) frame = drawGaps();
    g.putImageData(gapPicture, 0, 0);
    g.strokeStyle = colour("goal"); g.lineWidth = 2;
    g.beginPath(); g.moveTo(frame.x(state.t), frame.top - 4); g.lineTo(frame.x(state.t), frame.bottom); g.stroke();
  }
  // Above the slider: a triangle a collision, a bar where the order is lost.
  function drawMarks() {
    const { g, w, h } = surface($("marks"));
    const x = (t) => 8 + (w - 16) * t / end;
    g.fillStyle = colour("wrong");
    const since = new Map();
    const bar = (from, to) => g.fillRect(x(from), h - 5, Math.max(2, x(to) - x(from)), 4);
    for (const e of run.events) {
      const pair = e.drones.join();
      if (e.kind === "collision") {
        g.beginPath(); g.moveTo(x(e.time) - 4, 0); g.lineTo(x(e.time) + 4, 0); g.lineTo(x(e.time), 8); g.fill();
      } else if (e.kind === "order-lost") {
        since.set(pair, e.time);
      } else {
        bar(since.get(pair) || 0, e.time); since.delete(pair);
      }
    }
    for (const from of since.values()) bar(from, end);
  }

  function tell({ actual, wrong, beyond }) {
    let least = Infinity, pair = 0;
    for (let i = 0; i + 1 < N; i++) if (actual[i + 1] - actual[i] < least) { least = actual[i + 1] - actual[i]; pair = i; }
    const collisions = run.events.filter((e) => e.kind === "collision" && e.time <= state.t).length;
    const order = wrong.size ? `out of order: drones ${[...wrong].slice(0, 8).join(", ")}` : "in order";
    $("status").textContent = `t = ${state.t.toFixed(2)} s of ${end.toFixed(2)} s; smallest gap ${least.toFixed(3)} m (drones ${pair} and ${pair + 1}); ${order}; collisions so far: ${collisions}${outside(beyond)}`;
    $("status").className = wrong.size ? "wrong" : "";
    $("time").value = state.t;
    document.querySelectorAll("#events li").forEach((li) => { li.className = Number(li.dataset.time) <= state.t ? "past" : ""; });
  }
  function outside({ left, right }) {
    const side = (list, name) => (list.length ? `; beyond the picture, ${name}: drones ${list.slice(0, 8).join(", ")}` : "");
    return side(left, "left") + side(right, "right");
  }
  function draw() { tell(drawLine()); drawCursor(); }
  function redraw() { gapPicture = null; drawLegend(); drawMarks(); draw(); }
  function seek(t) { state.t = Math.min(end, Math.max(0, t)); draw(); }
  function play(on) {
    if (on && state.t >= end) state.t = 0;
    state.playing = on;
    $("play").textContent = on ? "Pause" : "Play";
    $("play").setAttribute("aria-pressed", on);
    if (on) { before = performance.now(); setTimeout(advance, FRAME); }
  }
  // A timer instead of animation frames: it also runs where nothing is shown.
  function advance() {
    if (!state.playing) return;
    const now = performance.now();
    seek(state.t + state.speed * (now - before) / 1000);
    before = now;
    if (state.t >= end) play(false); else setTimeout(advance, FRAME);
  }
  function faster(by) {
    const select = $("speed");
    select.selectedIndex = Math.min(select.length - 1, Math.max(0, select.selectedIndex + by));
    state.speed = Number(select.value);
  }
  function toEvent(forward) {
    const list = run.events.map((e) => e.time);
    const next = forward ? list.find((t) => t > state.t + 1e-9) : list.reverse().find((t) => t < state.t - 1e-9);
    if (next !== undefined) { play(false); seek(next); }
  }
  function theme() {
    const root = document.documentElement;
    const dark = root.dataset.theme ? root.dataset.theme === "dark" : matchMedia("(prefers-color-scheme: dark)").matches;
    root.dataset.theme = dark ? "light" : "dark";
    redraw();
  }

  $("play").addEventListener("click", () => play(!state.playing));
  $("theme").addEventListener("click", theme);
  $("time").max = end;
  $("time").addEventListener("input", (e) => { play(false); seek(Number(e.target.value)); });
  $("speed").addEventListener("change", (e) => { state.speed = Number(e.target.value); });
  $("gaps").addEventListener("pointerdown", (e) => {
    play(false);
    seek(end * (e.offsetX - frame.left) / (frame.right - frame.left));
  });
  document.addEventListener("keydown", (e) => {
    if (e.ctrlKey || e.metaKey || e.altKey) return;
    const step = (by) => { play(false); seek(e.shiftKey ? state.t + by : times[Math.min(last, Math.max(0, index(state.t + 1e-9) + by))]); };
    const keys = {
      " ": () => play(!state.playing), ArrowLeft: () => step(-1), ArrowRight: () => step(1),
      Home: () => { play(false); seek(0); }, End: () => { play(false); seek(end); },
      "-": () => faster(-1), "+": () => faster(1), "=": () => faster(1),
      n: () => toEvent(true), p: () => toEvent(false), d: theme,
    };
    const action = keys[e.key.length === 1 ? e.key.toLowerCase() : e.key];
    // A control that has the focus keeps the keys that work it.
    const tag = e.target.tagName;
    if (!action || tag === "SELECT" || (tag === "BUTTON" && e.key === " ")) return;
    e.preventDefault();
    action();
  });
  addEventListener("resize", redraw);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", redraw);

  $("setup").textContent = run.setup;
  const most = 200;
  for (const e of run.events.slice(0, most)) {
    const li = document.createElement("li"), button = document.createElement("button");
    button.type = "button";
    button.textContent = `${e.time.toFixed(3)} s: drones ${e.drones[0]} and ${e.drones[1]} ${words[e.kind]}`;
    button.addEventListener("click", () => { play(false); seek(e.time); });
    li.dataset.time = e.time;
    li.append(button);
    $("events").append(li);
  }
  const more = run.events.length - most;
  $("none").textContent = run.events.length === 0
    ? "None in this run, at the samples and between them."
    : more > 0 ? `${run.events.length} in all; the first ${most} are listed.` : "";

  const wanted = new URLSearchParams(location.hash.slice(1));
  if (wanted.has("theme")) document.documentElement.dataset.theme = wanted.get("theme");
  state.t = Math.min(end, Math.max(0, Number(wanted.get("t")) || 0));
  redraw();
  if (wanted.has("play") && !motionless) play(true);
})();
