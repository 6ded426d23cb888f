// What colours and widths mean, with the ranges in figures.
import { element } from "../controls";
import { drawn } from "./svg";
import { LOOKS, type TensionScale } from "./tension-style";

/** The looks of cables, from slack to tight. */
export function tensionLegend(scale: TensionScale): HTMLElement {
  const list = element("ul", "", "legend");
  list.setAttribute("aria-label", "Cables by tension");
  LOOKS.forEach(({ colour, width }, step) => list.append(entry(sample({ stroke: `var(--${colour})`, "stroke-width": width }), scale.words(step))));
  list.append(entry(sample({ stroke: "var(--muted)", "stroke-width": 1.5, "stroke-dasharray": "3 4" }), "no tensions"));
  return list;
}

/** Entries of colours with words, under a name. */
export function colourLegend(name: string, entries: { colour: string; words: string }[]): HTMLElement {
  const list = element("ul", "", "legend colours");
  list.setAttribute("aria-label", name);
  list.append(element("li", `${name}:`));
  for (const { colour, words } of entries) {
    const picture = drawn("svg", { width: 16, height: 12, viewBox: "0 0 16 12", "aria-hidden": "true" });
    picture.append(drawn("rect", { width: 16, height: 12, fill: colour, stroke: "var(--ink)" }));
    list.append(entry(picture, words));
  }
  return list;
}

/** A short line. */
export function sample(look: Record<string, string | number>): SVGSVGElement {
  const picture = drawn("svg", { width: 34, height: 12, viewBox: "0 0 34 12", "aria-hidden": "true" });
  picture.append(drawn("line", { x1: 2, y1: 6, x2: 32, y2: 6, ...look }));
  return picture;
}

function entry(picture: SVGElement, words: string): HTMLLIElement {
  const made = element("li");
  made.append(picture, element("span", words));
  return made;
}
