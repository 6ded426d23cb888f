// Layers of a drawing: each can be switched on and off, and the box to tick is its entry in the legend.
import { element } from "../controls";
import { drawn } from "../workspace/svg";

/** How a line looks; dashes tell lines apart without colour. */
export interface Look {
  stroke: string;
  width: number;
  dashes: string;
}

/** A layer that can be hidden. */
export interface Layer {
  words: string;
  shown: boolean;
  /** What stands for it in the legend. */
  picture: SVGElement[];
}

/** A short line of this look. */
export function line(look: Look): SVGElement[] {
  return [drawn("line", { x1: 2, y1: 7, x2: 32, y2: 7, stroke: look.stroke, "stroke-width": look.width, "stroke-dasharray": look.dashes })];
}

/** An arrow as the exact error vectors are. */
export function arrow(): SVGElement[] {
  return [drawn("path", { d: "M3 7H30M24 2.5L30 7L24 11.5", fill: "none", stroke: "var(--ink)", "stroke-width": 1.8 })];
}

/** A dashed line to a ring, as the vectors of the linear step are. */
export function pin(colour: string): SVGElement[] {
  return [
    drawn("path", { d: "M3 7H26", fill: "none", stroke: colour, "stroke-width": 1.8, "stroke-dasharray": "4 3" }),
    drawn("circle", { cx: 28, cy: 7, r: 3, fill: "none", stroke: colour, "stroke-width": 1.6 }),
  ];
}

/** A mark in the middle. */
export function mark(name: "ring" | "point" | "square"): SVGElement[] {
  if (name === "square") return [drawn("rect", { x: 13, y: 3, width: 8, height: 8, fill: "var(--ink)" })];
  const look = name === "ring" ? { r: 4.5, fill: "none", stroke: "var(--ink)", "stroke-width": 1.5 } : { r: 2.6, fill: "var(--bad)", stroke: "none" };
  return [drawn("circle", { cx: 17, cy: 7, ...look })];
}

/** Boxes to tick after `controls`, in groups with a name. */
export function offerLayers(controls: HTMLElement, groups: [string, Layer[]][], changed: () => void): void {
  const place = element("div", "", "layers");
  for (const [name, layers] of groups) {
    if (layers.length === 0) continue;
    const group = element("fieldset");
    group.append(element("legend", name), ...layers.map((layer) => box(layer, changed)));
    place.append(group);
  }
  controls.after(place);
}

function box(layer: Layer, changed: () => void): HTMLLabelElement {
  const [label, input] = [element("label"), element("input")];
  Object.assign(input, { type: "checkbox", checked: layer.shown });
  input.addEventListener("change", () => {
    layer.shown = input.checked;
    changed();
  });
  const picture = drawn("svg", { width: 34, height: 14, viewBox: "0 0 34 14", "aria-hidden": "true" });
  picture.append(...layer.picture);
  label.append(input, picture, element("span", layer.words));
  return label;
}
