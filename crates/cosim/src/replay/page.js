"use strict";
(() => {
  const run = JSON.parse(document.getElementById("run").textContent);
  const times = run.time, N = run.drones, plane = run.across;
  // A swarm that takes off together has one number a sample.
  const height = run.height && { desired: run.height.desired, actual: run.height.actual.map((z) => [z].flat()) };
  const last = times.length - 1, end = times[last];
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
  function between(rows, t) {
    const k = index(t), a = rows[k];
    if (k === last) return a;
    const b = rows[k + 1], s = (t - times[k]) / (times[k + 1] - times[k]);
    return a.map((x, i) => x + s * (b[i] - x));
  }
  const placesAt = (t, { actual, desired }) => ({ actual: between(actual, t), desired: desired[index(t)] });
  // Of two drones in the plane, or the nearest two.
  const apart = (x, y, i, j) => Math.hypot(x[j] - x[i], y[j] - y[i]);
  function nearest(x, y) {
    let least = Infinity, pair = [0, 1];
    for (let j = 1; j < N; j++) for (let i = 0; i < j; i++) {
      const d = apart(x, y, i, j);
      if (d < least) { least = d; pair = [i, j]; }
    }
    return { least, pair };
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

  // Two segments' lengths to each side at most: a run that breaks loose does not squeeze the rest.
  function alongX(actual) {
    const low = Math.max(Math.min(segment[0], ...actual), segment[0] - 2 * span);
    const high = Math.min(Math.max(segment[1], ...actual), segment[1] + 2 * span);
    const pad = 0.06 * (high - low);
    return [low - pad, high + pad];
  }
  // A drone, and where it is to be.
  const labelled = N <= 40, radius = labelled ? 11 : 4;
  function disc(g, x, y, i, name) {
    g.fillStyle = colour(name);
    g.beginPath(); g.arc(x, y, radius, 0, 2 * Math.PI); g.fill();
    if (labelled) {
      g.fillStyle = colour("paper"); g.textAlign = "center"; g.textBaseline = "middle";
      g.fillText(i, x, y + 1); g.textBaseline = "alphabetic";
    }
  }
  function diamond(g, x, y, r) {
    g.strokeStyle = colour("goal"); g.lineWidth = 2;
    g.beginPath(); g.moveTo(x, y - r); g.lineTo(x + r, y); g.lineTo(x, y + r); g.lineTo(x - r, y); g.closePath();
    g.stroke();
  }
  // Which drones are beyond a picture, on a side.
  const none = () => ({ left: [], right: [], below: [], above: [] });
  const note = (list, i) => { if (!list.includes(i)) list.push(i); };

  function drawLine() {
    const { g, w, h } = surface($("line"));
    const { actual, desired } = placesAt(state.t, run);
    const [low, high] = alongX(actual);
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
    const up = y - 46;
    // What is beyond the picture is no marker at its edge, but an arrow there and a word below.
    const beyond = none();
    const arrow = (x, height, name) => {
      const to = at(x) < left ? -1 : 1, tip = to < 0 ? 3 : w - 3;
      g.fillStyle = colour(name);
      g.beginPath(); g.moveTo(tip, height); g.lineTo(tip - to * 8, height - 5); g.lineTo(tip - to * 8, height + 5); g.fill();
    };
    for (let i = 0; i < N; i++) {
      for (const x of [actual[i], desired[i]]) {
        const side = at(x) < left ? "left" : at(x) > right ? "right" : null;
        if (side) note(beyond[side], i);
      }
      if (!inside(desired[i])) { arrow(desired[i], up, "goal"); continue; }
      const x = at(desired[i]);
      g.strokeStyle = colour("goal"); g.lineWidth = 1;
      g.globalAlpha = 0.5;
      g.beginPath(); g.moveTo(edge(actual[i]), y); g.lineTo(x, up); g.stroke();
      g.globalAlpha = 1;
      diamond(g, x, up, labelled ? 7 : 3);
    }
    if (labelled) {
      g.fillStyle = colour("goal");
      spread(desired.map((x, i) => ({ at: at(x), text: String(i) })).filter((l) => l.at >= left && l.at <= right), g, w)
        .forEach((l) => g.fillText(l.text, l.at, up - 12));
    }
    for (let i = 0; i < N; i++) {
      if (!inside(actual[i])) { arrow(actual[i], y, wrong.has(i) ? "wrong" : "drone"); continue; }
      disc(g, at(actual[i]), y, i, wrong.has(i) ? "wrong" : "drone");
    }
    return { actual, wrong, beyond };
  }

  // Drones in a plane that x goes along: seen from above, or from the side. Both scales are the
  // same where the picture is a map.
  function scatter(canvas, x, v, { across, up, map, paths, wrong }) {
    const { g, w, h } = surface(canvas);
    const left = 58, right = w - 20, top = 16, bottom = h - 30;
    let sx = (right - left) / (across[1] - across[0]), sv = (bottom - top) / (up[1] - up[0]);
    if (map) sx = sv = Math.min(sx, sv);
    const middle = [(across[0] + across[1]) / 2, (up[0] + up[1]) / 2];
    const px = (a) => (left + right) / 2 + sx * (a - middle[0]), pv = (b) => (top + bottom) / 2 - sv * (b - middle[1]);
    const shown = { across: [-1, 1].map((e) => middle[0] + e * (right - left) / 2 / sx), up: [-1, 1].map((e) => middle[1] + e * (bottom - top) / 2 / sv) };
    g.strokeStyle = colour("rule"); g.fillStyle = colour("soft"); g.lineWidth = 1;
    g.textAlign = "center";
    for (const a of ticks(...shown.across, Math.max(2, Math.min(10, Math.floor(w / 90))))) {
      g.beginPath(); g.moveTo(px(a), top); g.lineTo(px(a), bottom); g.stroke();
      label(g, short(a) + " m", px(a), h - 9, w);
    }
    g.textAlign = "right";
    for (const b of ticks(...shown.up, Math.max(2, Math.floor(h / 60)))) {
      g.beginPath(); g.moveTo(left, pv(b)); g.lineTo(right, pv(b)); g.stroke();
      g.fillText(short(b) + " m", left - 6, pv(b) + 4);
    }
    g.save();
    g.beginPath(); g.rect(left - 14, top - 14, right - left + 28, bottom - top + 28); g.clip();
    if (paths) {
      const k = index(state.t), every = Math.ceil((k + 1) / 400);
      g.strokeStyle = colour("drone"); g.lineWidth = 1.5; g.globalAlpha = labelled ? 0.45 : 0.2;
      for (let i = 0; i < N; i++) {
        g.beginPath(); g.moveTo(px(x.actual[i]), pv(v.actual[i]));
        for (let r = k; r >= 0; r -= every) g.lineTo(px(run.actual[r][i]), pv(plane.actual[r][i]));
        g.stroke();
      }
      g.globalAlpha = 1;
    }
    const beyond = none();
    const inside = (a, b, i) => {
      if (a < shown.across[0]) note(beyond.left, i); else if (a > shown.across[1]) note(beyond.right, i);
      else if (b < shown.up[0]) note(beyond.below, i); else if (b > shown.up[1]) note(beyond.above, i);
      else return true;
      return false;
    };
    for (let i = 0; i < N; i++) {
      if (!inside(x.desired[i], v.desired[i], i)) continue;
      const a = px(x.desired[i]), b = pv(v.desired[i]);
      g.strokeStyle = colour("goal"); g.lineWidth = 1; g.globalAlpha = 0.5;
      g.beginPath(); g.moveTo(px(x.actual[i]), pv(v.actual[i])); g.lineTo(a, b); g.stroke();
      g.globalAlpha = 1;
    }
    // Under the drones, and so large as to be seen around one that is there.
    for (let i = 0; i < N; i++) {
      if (inside(x.desired[i], v.desired[i], i)) diamond(g, px(x.desired[i]), pv(v.desired[i]), labelled ? 17 : 6);
    }
    for (let i = 0; i < N; i++) {
      if (inside(x.actual[i], v.actual[i], i)) disc(g, px(x.actual[i]), pv(v.actual[i]), i, wrong.has(i) ? "wrong" : "drone");
    }
    g.restore();
    return beyond;
  }
  // What a picture of the whole run has to show, no farther than two lengths of the start beyond it.
  function range(rows, more = []) {
    const start = rows[0].concat(more);
    const low = Math.min(...start), high = Math.max(...start), size = Math.max(high - low, 1e-9);
    let least = low, most = high;
    for (const row of rows) for (const x of row) { if (x < least) least = x; if (x > most) most = x; }
    least = Math.max(least, low - 2 * size); most = Math.min(most, high + 2 * size);
    const pad = 0.08 * (most - least) || 1;
    return [least - pad, most + pad];
  }
  const extent = plane && { across: range(run.actual.concat(run.desired)), up: range(plane.actual.concat(plane.desired)), map: true, paths: true };
  function drawPlane() {
    const x = placesAt(state.t, run), y = placesAt(state.t, plane), wrong = new Set();
    for (let j = 1; j < N; j++) for (let i = 0; i < j; i++) {
      if (apart(x.actual, y.actual, i, j) <= run.reach) { wrong.add(i); wrong.add(j); }
    }
    return { actual: x.actual, across: y.actual, wrong, beyond: scatter($("line"), x, y, { ...extent, wrong }) };
  }
  const heights = height && range(height.actual, [0, height.desired]);
  function drawSide({ actual, wrong }) {
    const now = between(height.actual, state.t), each = (z) => Array(N).fill(z);
    const z = { actual: now.length === N ? now : each(now[0]), desired: each(height.desired) };
    const across = plane ? extent.across : alongX(actual);
    const beyond = scatter($("side"), { actual, desired: run.desired[index(state.t)] }, z, { across, up: heights, wrong });
    return { least: Math.min(...z.actual), most: Math.max(...z.actual), beyond };
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

  // Curves over time: on a line the gap of every two neighbours; in the plane, where none are
  // neighbours, the distance of the nearest two. Below the floor drones have met.
  const floor = plane ? run.reach : 0;
  const curves = plane
    ? [{ name: "the nearest two", values: run.actual.map((x, k) => nearest(x, plane.actual[k]).least) }]
    : Array.from({ length: N - 1 }, (_, i) => ({ name: `${i}–${i + 1}`, values: run.actual.map((a) => a[i + 1] - a[i]) }));
  // Their picture changes with size and theme only; the moving cursor is drawn over it.
  let gapPicture = null;
  function gapFrame(w, h) {
    let low = Infinity, high = -Infinity;
    for (const { values } of curves) for (const gap of values) {
      if (gap < low) low = gap;
      if (gap > high) high = gap;
    }
    low = Math.max(Math.min(low, 0), -0.5 * span); high = plane ? Math.max(high, 2 * floor) : Math.min(high, 1.2 * span);
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
    if (f.low < floor) g.fillRect(f.left, f.y(floor), f.right - f.left, f.bottom - f.y(floor));
    g.strokeStyle = colour("rule"); g.fillStyle = colour("soft"); g.lineWidth = 1;
    g.textAlign = "right";
    for (const gap of ticks(f.low, f.high, 6)) {
      g.beginPath(); g.moveTo(f.left, f.y(gap)); g.lineTo(f.right, f.y(gap)); g.stroke();
      g.fillText(short(gap) + " m", f.left - 6, f.y(gap) + 4);
    }
    g.textAlign = "center";
    for (const t of ticks(0, end, Math.max(2, Math.min(10, Math.floor(w / 70))))) label(g, short(t) + " s", f.x(t), h - 10, w);
    g.strokeStyle = colour("ink"); g.lineWidth = 1.5;
    g.beginPath(); g.moveTo(f.left, f.y(floor)); g.lineTo(f.right, f.y(floor)); g.stroke();
    // Lines that leave the scale are cut there, and the text below says so.
    g.save();
    g.beginPath(); g.rect(f.left, f.top, f.right - f.left, f.bottom - f.top); g.clip();
    g.lineWidth = few ? 1.8 : 1; g.globalAlpha = few || labelled ? 1 : N <= 100 ? 0.6 : 0.25;
    curves.forEach(({ values }, i) => {
      g.strokeStyle = gapColour(i);
      g.setLineDash(few ? DASHES[i % DASHES.length] : []);
      g.beginPath();
      values.forEach((gap, k) => { if (k) g.lineTo(f.x(times[k]), f.y(gap)); else g.moveTo(f.x(times[k]), f.y(gap)); });
      g.stroke();
    });
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
  const few = curves.length <= 11;
  const gapColour = (i) => (few ? colour(`gap-${i % 7}`) : colour("drone"));
  const limits = gapFrame(100, 100);
  const cut = curves.filter(({ values }) => values.some((gap) => gap < limits.low || gap > limits.high));
  // The gaps' names, below the picture: each a piece that stays in one line.
  function drawLegend() {
    const list = $("gap-names");
    list.textContent = "";
    (few ? curves : []).forEach(({ name }, i) => {
      const li = document.createElement("li"), canvas = document.createElement("canvas");
      canvas.setAttribute("aria-hidden", "true");
      li.append(canvas, ` ${name}`);
      list.append(li);
      const { g, w, h } = surface(canvas);
      g.strokeStyle = gapColour(i); g.lineWidth = 2; g.setLineDash(DASHES[i % DASHES.length]);
      g.beginPath(); g.moveTo(0, h / 2); g.lineTo(w, h / 2); g.stroke();
    });
    list.hidden = !few;
    $("cut").textContent = cut.length
      ? `Cut at the edge of the picture: the ${cut.length === 1 ? "gap" : "gaps"} ${cut.slice(0, 8).map(({ name }) => name).join(", ")}${cut.length > 8 ? ", .." : ""}.`
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

  function tell({ actual, across, wrong, beyond }, side) {
    let least = Infinity, pair = [0, 1];
    if (plane) ({ least, pair } = nearest(actual, across));
    else for (let i = 0; i + 1 < N; i++) if (actual[i + 1] - actual[i] < least) { least = actual[i + 1] - actual[i]; pair = [i, i + 1]; }
    const collisions = run.events.filter((e) => e.kind === "collision" && e.time <= state.t).length;
    const drones = [...wrong].sort((a, b) => a - b).slice(0, 8).join(", ") + (wrong.size > 8 ? ", .." : "");
    const order = wrong.size ? `${plane ? "touching" : "out of order"}: drones ${drones}` : plane ? "none touch" : "in order";
    const high = side ? `; height ${[...new Set([side.least, side.most].map((z) => z.toFixed(2)))].join(" to ")} m of ${height.desired.toFixed(2)} m` : "";
    $("status").textContent = `t = ${state.t.toFixed(2)} s of ${end.toFixed(2)} s; smallest ${plane ? "distance" : "gap"} ${least.toFixed(3)} m (drones ${pair[0]} and ${pair[1]}); ${order}${high}; collisions so far: ${collisions}${outside(beyond)}`;
    $("status").className = wrong.size ? "wrong" : "";
    $("time").value = state.t;
    $("time").setAttribute("aria-valuetext", `${state.t.toFixed(2)} s`);
    document.querySelectorAll("#events li").forEach((li) => { li.className = Number(li.dataset.time) <= state.t ? "past" : ""; });
  }
  function outside(beyond) {
    const side = ([name, list]) => (list.length ? `; beyond the picture, ${name}: ${list.length === 1 ? "drone" : "drones"} ${list.slice(0, 8).join(", ")}` : "");
    return Object.entries(beyond).map(side).join("");
  }
  function draw() {
    const shown = plane ? drawPlane() : drawLine();
    tell(shown, height && drawSide(shown));
    drawCursor();
  }
  function redraw() { gapPicture = null; drawLegend(); drawMarks(); draw(); }
  function seek(t) { state.t = Math.min(end, Math.max(0, t)); draw(); }
  function play(on) {
    if (on && state.t >= end) state.t = 0;
    state.playing = on;
    $("play").textContent = on ? "Pause" : "Play";
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
  $("from-the-side").hidden = !height;
  if (plane) {
    document.body.classList.add("plane");
    document.querySelectorAll("[data-plane]").forEach((e) => { e.textContent = e.dataset.plane; });
    document.querySelectorAll("[data-plane-label]").forEach((e) => e.setAttribute("aria-label", e.dataset.planeLabel));
  }
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
