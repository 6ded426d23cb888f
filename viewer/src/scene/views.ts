// Buttons that turn a scene to usual views, and zoom.
import { Vector3 } from "three";
import { button, element } from "../controls";
import type { Stage } from "./stage";

const UP = new Vector3(0, 0, 1);

/** Adds the buttons; a planar robot is seen from one side only. `standard` is the view to begin with. */
export function offerViews(controls: HTMLElement, stage: Stage, planar: boolean, standard: () => void): void {
  const views = element("div", "", "buttons");
  views.setAttribute("role", "group");
  views.setAttribute("aria-label", "View");
  button(views, "Reset view", standard);
  if (!planar) {
    button(views, "Top", () => stage.lookFrom(new Vector3(0, -1e-3, 1), UP));
    button(views, "Front", () => stage.lookFrom(new Vector3(0, -1, 0), UP));
    button(views, "Side", () => stage.lookFrom(new Vector3(1, 0, 0), UP));
  }
  button(views, "Zoom in", () => stage.zoom(0.85));
  button(views, "Zoom out", () => stage.zoom(1 / 0.85));
  controls.append(views);
}
