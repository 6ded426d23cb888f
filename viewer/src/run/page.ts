// The page of a run: playback in the scene, tensions as they go, and the drawn figures with a line at the time shown.
import { button, choice, element } from "../controls";
import { limitWords, TensionScale } from "../workspace/tension-style";
import { drawn } from "../workspace/svg";
import { Clock, momentAt } from "./clock";
import type { RunData } from "../data";
import { isBroken } from "./breaks";
import { MachineScene } from "./machine-scene";

const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 5, 10];

/** Fills the figure of the page that the command wrote. */
export function showRun(data: RunData): void {
  const figure = document.querySelector<HTMLElement>('figure[data-chart="run"]');
  const times = data.moments.time_s;
  if (!figure || times.length === 0) return;
  const clock = new Clock(times[0] as number, times.at(-1) as number);
  const [controls, timeLine, holder, side] = [element("div", "", "controls"), element("div", "", "time-line"), element("div", "", "playback"), element("div", "", "side")];
  const canvas = element("div", "", "picture");
  holder.append(canvas, side);
  figure.prepend(controls, timeLine, holder);
  offerControls(data, clock, controls);
  showTimeLine(data, clock, timeLine);
  const scale = new TensionScale(data.robot.cables, data.moments.tensions_N);
  showTensions(data, clock, scale, side);
  try {
    new MachineScene(canvas, controls, data, scale, clock);
  } catch (error) {
    canvas.append(element("p", `The scene needs WebGL, which this browser does not offer (${String(error)}). The figures below show the same run.`, "remark"));
  }
  for (const svg of document.querySelectorAll<SVGSVGElement>("svg.figure[data-time]")) follow(clock, svg);
}

function offerControls(data: RunData, clock: Clock, controls: HTMLElement): void {
  const play = button(controls, "Play", () => clock.toggle());
  const slider = element("input");
  const steps = 1000;
  const span = clock.end - clock.start || 1;
  Object.assign(slider, { type: "range", min: "0", max: String(steps), step: "1", value: "0" });
  slider.setAttribute("aria-label", "Time");
  slider.className = "scrubber";
  slider.addEventListener("input", () => clock.moveTo(clock.start + (span * Number(slider.value)) / steps));
  const words = element("output", "", "pose-words");
  const single = (direction: number) => {
    const at = momentAt(data.moments.time_s, clock.time) + direction;
    clock.moveTo(data.moments.time_s[Math.max(0, Math.min(data.moments.time_s.length - 1, at))] as number);
  };
  controls.append(slider, words);
  button(controls, "−1", () => single(-1)).setAttribute("aria-label", "One moment back");
  button(controls, "+1", () => single(1)).setAttribute("aria-label", "One moment on");
  const speeds = [1, ...SPEEDS.filter((speed) => speed !== 1)];
  choice(controls, "Speed", speeds.map((value) => ({ label: `× ${value}`, value })), (value) => {
    clock.speed = value;
  });
  const show = () => {
    play.textContent = clock.runs ? "Pause" : "Play";
    slider.value = String(Math.round((steps * (clock.time - clock.start)) / span));
    const at = momentAt(data.moments.time_s, clock.time);
    slider.setAttribute("aria-valuetext", `${clock.time.toFixed(2)} s`);
    words.textContent = ` ${clock.time.toFixed(2)} s: ${position(data, at)}`;
  };
  clock.onChange(show);
  show();
}

/** Position of the platform, in the plane of a planar robot. */
function position(data: RunData, at: number): string {
  const plane = data.robot.plane;
  const place = data.moments.position_m[at] ?? [0, 0, 0];
  const along = (direction: number[]) => direction.reduce((sum, value, k) => sum + value * (place[k] as number), 0);
  const components = plane ? [along(plane.first), along(plane.second)] : place;
  return `${components.map((value) => value.toFixed(3).replace("-", "−")).join(", ")} m`;
}

/** Events and violations on a strip as long as the run. */
function showTimeLine(data: RunData, clock: Clock, place: HTMLElement): void {
  const [width, height] = [1000, 26];
  const span = clock.end - clock.start || 1;
  const x = (time: number) => (width * (time - clock.start)) / span;
  const strip = drawn("svg", { viewBox: `0 0 ${width} ${height}`, preserveAspectRatio: "none", role: "img", "aria-label": "Events and broken limits over the time" });
  strip.append(drawn("rect", { x: 0, y: 8, width, height: 10, class: "way" }));
  for (const { from_s, to_s, words } of data.broken_limits) {
    strip.append(titled(drawn("rect", { x: x(from_s), y: 8, width: Math.max(2, x(to_s) - x(from_s)), height: 10, class: "violation" }), `${from_s.toFixed(3)} to ${to_s.toFixed(3)} s: ${words}`));
  }
  for (const { time_s, words } of data.events) {
    strip.append(titled(drawn("rect", { x: x(time_s) - 1.5, y: 1, width: 3, height: 24, class: "event" }), `${time_s.toFixed(3)} s: ${words}`));
  }
  const now = drawn("rect", { x: 0, y: 0, width: 2, height, class: "now" });
  strip.append(now);
  strip.addEventListener("pointerdown", (event) => {
    const box = strip.getBoundingClientRect();
    clock.moveTo(clock.start + (span * (event.clientX - box.left)) / box.width);
  });
  clock.onChange(() => now.setAttribute("x", String(x(clock.time) - 1)));
  place.append(strip, element("p", legend(data), "caption"));
}

function legend(data: RunData): string {
  const parts = [data.events.length > 0 ? "tall bars: events" : "", data.broken_limits.length > 0 ? "red: limits broken" : "no limit is broken"];
  const words = parts.filter(Boolean).join("; ");
  return `Time line: ${words}.`;
}

function titled(mark: SVGElement, words: string): SVGElement {
  const title = drawn("title", {});
  title.textContent = words;
  mark.append(title);
  return mark;
}

/** A row for every cable: its tension between its limits. */
function showTensions(data: RunData, clock: Clock, scale: TensionScale, place: HTMLElement): void {
  const table = element("table", "", "run-tensions");
  table.append(element("caption", "Tensions at the time shown"));
  const head = table.createTHead().insertRow();
  head.append(...["cable", "N", "", ""].map((text) => element("th", text, text === "N" ? "number" : "")));
  const bodyOf = table.createTBody();
  const rows = data.robot.cables.map((cable) => {
    const row = bodyOf.insertRow();
    const [number, track, fill, words] = [element("td", "", "number"), element("span", "", "track"), element("span", "", "fill"), element("td", "", "short")];
    const bar = element("td");
    track.append(fill);
    bar.append(track);
    row.append(element("td", cable.name), number, bar, words);
    return { cable, number, fill, words };
  });
  const show = () => {
    const tensions = data.moments.tensions_N[momentAt(data.moments.time_s, clock.time)] ?? [];
    rows.forEach(({ cable, number, fill, words }, index) => {
      const tension = tensions[index] ?? 0;
      const look = scale.look(tension);
      number.textContent = tension.toFixed(0);
      fill.style.width = `${Math.max(0, Math.min(100, (100 * tension) / scale.largest))}%`;
      fill.style.height = "8px";
      fill.style.background = `var(--${look.colour})`;
      words.textContent = isBroken(data, index, clock.time) ? "broken" : outside(tension, cable.tension_min_N, cable.tension_max_N);
    });
  };
  clock.onChange(show);
  show();
  place.append(table);
}

function outside(tension: number, least: number | null, largest: number | null): string {
  if (!(tension > 0)) return "slack";
  if (least !== null && tension < least) return "▼ below limit";
  if (largest !== null && tension > largest) return "▲ above limit";
  return limitWords(tension, least, largest);
}

/** A line at the time shown, in a figure whose `data-time` tells pixels and seconds of its ends: "left right top bottom from to". */
function follow(clock: Clock, svg: SVGSVGElement): void {
  const [left, right, top, bottom, from, to] = (svg.dataset.time ?? "").split(" ").map(Number) as [number, number, number, number, number, number];
  if (![left, right, top, bottom, from, to].every(Number.isFinite) || to <= from) return;
  const line = drawn("line", { y1: top, y2: bottom, class: "now-line" });
  svg.append(line);
  const show = () => {
    const x = String(left + ((right - left) * (clock.time - from)) / (to - from));
    line.setAttribute("x1", x);
    line.setAttribute("x2", x);
  };
  svg.addEventListener("pointerdown", (event) => {
    const matrix = svg.getScreenCTM();
    if (!matrix) return;
    const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix.inverse());
    clock.moveTo(from + ((to - from) * (at.x - left)) / (right - left));
  });
  clock.onChange(show);
  show();
}
