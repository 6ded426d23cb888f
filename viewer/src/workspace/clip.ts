// The plane that cuts the hulls open.
import { Plane, Vector3 } from "three";
import { choice, element } from "../controls";
import type { GridAxis } from "../data";

/** The plane chosen, or none. */
export type ClipChoice = () => Plane | null;

/** Choice of an axis and a slider along it. */
export function offerClip(controls: HTMLElement, axes: GridAxis[], changed: () => void): ClipChoice {
  const slider = element("input");
  const words = element("output", "", "pose-words");
  const label = element("label", "at ");
  const fit = () => {
    const axis = chosen();
    label.hidden = flip.hidden = !axis;
    if (!axis) return;
    const high = axis.start_m + (axis.count - 1) * axis.step_m;
    Object.assign(slider, { type: "range", min: String(axis.start_m), max: String(high), step: "any", value: String(0.5 * (axis.start_m + high)) });
    tell();
  };
  const tell = () => {
    words.textContent = ` ${chosen()?.name} = ${slider.valueAsNumber.toFixed(2).replace("-", "−")} m`;
  };
  const chosen = choice(
    controls,
    "Clip plane",
    [{ label: "none", value: null as GridAxis | null }, ...axes.map((axis) => ({ label: `across ${axis.name}`, value: axis as GridAxis | null }))],
    () => {
      fit();
      changed();
    },
  );
  const [flip, turned] = [element("label"), element("input")];
  turned.type = "checkbox";
  flip.append(turned, " show the other side");
  turned.addEventListener("change", changed);
  slider.setAttribute("aria-label", "Place of the clip plane, m");
  slider.addEventListener("input", () => {
    tell();
    changed();
  });
  label.append(slider, words);
  controls.append(label, flip);
  fit();
  return () => {
    const axis = chosen();
    if (!axis) return null;
    const side = turned.checked ? 1 : -1;
    return new Plane(new Vector3(...axis.direction).multiplyScalar(side), -side * slider.valueAsNumber);
  };
}
