// The platform's position as sliders and numbers: for keyboards, for touch, and for exact values.
import { element } from "../controls";
import type { Platform } from "./platform";

/** A slider and a number for each axis, and the choice to keep to the grid. */
export function offerPosition(place: HTMLElement, platform: Platform): void {
  const group = element("fieldset", "", "position");
  group.append(element("legend", "Platform"));
  const updates = platform.data.grid.axes.map((axis, k) => {
    const [low, high] = [axis.start_m, axis.start_m + (axis.count - 1) * axis.step_m];
    const [slider, number] = [element("input"), element("input")];
    const fine = axis.step_m / 20 || 0.001;
    Object.assign(slider, { type: "range", min: String(low), max: String(high), step: "any" });
    Object.assign(number, { type: "number", min: String(low), max: String(high), step: "any" });
    slider.setAttribute("aria-label", `${axis.name} of the platform, m`);
    number.setAttribute("aria-label", `${axis.name} of the platform in figures, m`);
    const moved = (input: HTMLInputElement) => () => {
      if (Number.isFinite(input.valueAsNumber)) platform.moveTo(platform.coordinates.map((value, at) => (at === k ? input.valueAsNumber : value)));
    };
    slider.addEventListener("input", moved(slider));
    slider.addEventListener("keydown", (event) => {
      const steps = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1, PageDown: -10, PageUp: 10 }[event.key];
      if (steps === undefined) return;
      event.preventDefault(); // a step of the browser would be a tenth of a millimetre
      platform.step(k, steps);
    });
    number.addEventListener("change", moved(number));
    const row = element("div", "", "axis-row");
    row.append(element("span", axis.name, "axis-name"), slider, number, element("span", "m"));
    group.append(row);
    return () => {
      const value = platform.coordinates[k] ?? 0;
      slider.value = String(value);
      if (document.activeElement !== number) number.value = value.toFixed(decimals(fine));
    };
  });
  const snap = element("input");
  snap.type = "checkbox";
  snap.addEventListener("change", () => platform.snap(snap.checked));
  const label = element("label");
  label.append(snap, " keep to grid points (computed, not interpolated)");
  group.append(label);
  place.append(group);
  const update = () => updates.forEach((one) => one());
  platform.onMove(update);
  update();
}

/** Digits behind the point that show this size. */
function decimals(size: number): number {
  return Math.max(0, Math.min(6, Math.ceil(-Math.log10(size))));
}
