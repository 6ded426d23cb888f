// Pictures and meshes as files. They are made from what the page shows; nothing is fetched.
import { Group, Mesh } from "three";
import { STLExporter } from "three/examples/jsm/exporters/STLExporter.js";
import { geometryOf } from "./hull";
import type { ShownRegion } from "./regions";

/** A hull as binary STL (world, m). */
export function stl(regions: ShownRegion[]): Blob {
  const group = new Group();
  for (const { region } of regions) group.add(new Mesh(geometryOf(region)));
  const view = new STLExporter().parse(group, { binary: true });
  return new Blob([view.buffer as ArrayBuffer], { type: "model/stl" });
}

/** A drawing as a file of its own: colours of the page are written into it. */
export function svgText(drawing: SVGSVGElement): string {
  const copy = drawing.cloneNode(true) as SVGSVGElement;
  copy.setAttribute("xmlns", "http://www.w3.org/2000/svg");
  const from = [...drawing.querySelectorAll<SVGElement>("[class]")];
  // what classes say is known only to the page
  [...copy.querySelectorAll<SVGElement>("[class]")].forEach((part, index) => {
    const look = getComputedStyle(from[index] as SVGElement);
    for (const name of ["fill", "stroke", "stroke-width", "stroke-dasharray", "paint-order", "font-weight", "font-size"]) part.style.setProperty(name, look.getPropertyValue(name));
  });
  const ground = document.createElementNS("http://www.w3.org/2000/svg", "rect");
  ground.setAttribute("style", "fill: var(--paper)");
  ground.setAttribute("width", "100%");
  ground.setAttribute("height", "100%");
  copy.prepend(ground);
  const page = getComputedStyle(document.documentElement);
  return new XMLSerializer().serializeToString(copy).replace(/var\((--[\w-]+)\)/g, (whole, name: string) => page.getPropertyValue(name).trim() || whole);
}

export function svg(drawing: SVGSVGElement): Blob {
  return new Blob([svgText(drawing)], { type: "image/svg+xml" });
}

/** The scene with its labels on the paper's colour. */
export async function png(stage: HTMLElement): Promise<Blob | null> {
  const canvas = stage.querySelector("canvas");
  if (!canvas) return null;
  const copy = document.createElement("canvas");
  [copy.width, copy.height] = [canvas.width, canvas.height];
  const context = copy.getContext("2d");
  if (!context) return null;
  const page = getComputedStyle(document.documentElement);
  context.fillStyle = page.getPropertyValue("--paper");
  context.fillRect(0, 0, copy.width, copy.height);
  context.drawImage(canvas, 0, 0);
  const box = canvas.getBoundingClientRect();
  const scale = canvas.width / box.width;
  context.scale(scale, scale);
  context.textBaseline = "top";
  for (const label of stage.querySelectorAll<HTMLElement>(".labels span:not([hidden])")) {
    const at = label.getBoundingClientRect();
    const look = getComputedStyle(label);
    context.font = `${look.fontStyle} ${look.fontWeight} ${look.fontSize} ${look.fontFamily}`;
    context.lineWidth = 3;
    context.strokeStyle = page.getPropertyValue("--paper");
    context.fillStyle = look.color;
    context.strokeText(label.textContent ?? "", at.left - box.left, at.top - box.top);
    context.fillText(label.textContent ?? "", at.left - box.left, at.top - box.top);
  }
  return new Promise((done) => copy.toBlob(done, "image/png"));
}

/** Hands a file to the reader. */
export function save(blob: Blob | null, name: string): void {
  if (!blob) return;
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}
