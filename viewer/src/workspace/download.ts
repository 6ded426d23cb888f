// The scene and its hulls as files. They are made from what the page shows; nothing is fetched.
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
