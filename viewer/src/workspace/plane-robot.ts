// Robot and platform upon a margin chart. The platform follows the pointer, a finger and the arrow keys.
import type { Vector3 } from "three";
import type { MarginChart, Plane } from "./margin-chart";
import { type Platform, cableName } from "./platform";
import { drawn } from "./svg";
import type { TensionScale } from "./tension-style";

const STEPS: Record<string, [number, number]> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowDown: [0, -1], ArrowUp: [0, 1] };

/** Draws the platform, with cables where `scale` is given, and returns what draws it again after a move. */
export function placePlatform(chart: MarginChart, plane: Plane, platform: Platform, scale: TensionScale | null): () => void {
  const layer = drawn("g", { class: "robot" });
  const picture = drawn("g", {});
  const handle = drawn("g", { class: "handle", tabindex: 0, role: "application", "aria-label": "Platform: drag it, or move it with the arrow keys; with Shift ten steps at once" });
  handle.append(drawn("circle", { r: 22, fill: "transparent" }), drawn("circle", { r: 9, class: "grip" }), drawn("path", { d: "M-5 0H5M0-5V5", class: "cross" }));
  layer.append(picture, handle);
  chart.drawing.append(layer);
  offerDragging(chart, plane, platform, handle);
  const draw = () => {
    const point = place(chart, plane, platform, platform.position);
    handle.setAttribute("transform", `translate(${point.x},${point.y})`);
    picture.replaceChildren(...(scale ? robot(chart, plane, platform, scale) : []));
  };
  draw();
  return draw;
}

/** Cables with tensions, frame anchors, and the platform's edges. */
function robot(chart: MarginChart, plane: Plane, platform: Platform, scale: TensionScale): SVGElement[] {
  const at = (point: Vector3) => place(chart, plane, platform, point);
  const { anchors, edges, frame } = platform;
  const { tensions } = platform.reading;
  const parts: SVGElement[] = edges.flatMap(([from, to]) => [line(at(from), at(to), { class: "edge halo" }), line(at(from), at(to), { class: "edge" })]);
  const words: SVGElement[] = [];
  frame.forEach((anchor, index) => {
    const [from, to] = [at(anchor), at(anchors[index] as Vector3)];
    const tension = tensions?.[index];
    const look: Record<string, string | number> = tension === undefined ? { class: "cable none" } : { class: "cable", stroke: `var(--${scale.look(tension).colour})`, "stroke-width": scale.look(tension).width };
    parts.push(line(from, to, { class: "cable halo", "stroke-width": Number(look["stroke-width"] ?? 1.5) + 3 }), line(from, to, look), drawn("circle", { cx: from.x, cy: from.y, r: 4, class: "anchor" }));
    const name = cableName(platform.data, index);
    // nearer to the frame, where cables are farther apart
    const [x, y] = [from.x + 0.32 * (to.x - from.x), from.y + 0.32 * (to.y - from.y)];
    words.push(drawn("text", { x, y, class: "tension" }, tension === undefined ? name : `${name}: ${tension.toFixed(0)} N`));
  });
  return [...parts, ...words];
}

function line(from: Pixel, to: Pixel, look: Record<string, string | number>): SVGElement {
  return drawn("line", { x1: from.x, y1: from.y, x2: to.x, y2: to.y, ...look });
}

interface Pixel {
  x: number;
  y: number;
}

function place(chart: MarginChart, plane: Plane, platform: Platform, point: Vector3): Pixel {
  const coordinates = platform.coordinatesOf(point);
  return { x: chart.x.apply(coordinates[plane.across]), y: chart.y.apply(coordinates[plane.up]) };
}

function offerDragging(chart: MarginChart, plane: Plane, platform: Platform, handle: SVGGElement): void {
  const { drawing } = chart;
  const follow = (event: PointerEvent | MouseEvent) => {
    const box = drawing.getBoundingClientRect();
    const scale = drawing.viewBox.baseVal.width / box.width;
    const [x, y] = [chart.x.invert?.((event.clientX - box.left) * scale), chart.y.invert?.((event.clientY - box.top) * scale)];
    platform.moveTo(platform.coordinates.map((value, k) => (k === plane.across ? x : k === plane.up ? y : value)));
  };
  handle.addEventListener("pointerdown", (event) => {
    handle.setPointerCapture(event.pointerId);
    handle.focus({ preventScroll: true });
    event.preventDefault();
  });
  handle.addEventListener("pointermove", (event) => handle.hasPointerCapture(event.pointerId) && follow(event));
  handle.addEventListener("keydown", (event) => {
    const step = STEPS[event.key];
    if (!step) return;
    event.preventDefault();
    const axis = step[0] !== 0 ? plane.across : plane.up;
    platform.step(axis, (step[0] + step[1]) * (event.shiftKey ? 10 : 1));
  });
  drawing.addEventListener("dblclick", follow);
}
