// Words beside points of the scene, as elements above the canvas: sharp at any size, and they print.
import { type Camera, Vector3 } from "three";
import { element } from "../controls";

interface Label {
  at: Vector3;
  shown: HTMLElement;
}

/** Labels of one scene. */
export class Labels {
  private labels: Label[] = [];
  private readonly layer = element("div", "", "labels");

  constructor(stage: HTMLElement) {
    this.layer.setAttribute("aria-hidden", "true");
    stage.append(this.layer);
  }

  /** Replaces all labels. */
  set(labels: { at: Vector3; text: string; className?: string }[]): void {
    this.labels = labels.map(({ at, text, className }) => ({ at, shown: element("span", text, className ?? "") }));
    this.layer.replaceChildren(...this.labels.map((label) => label.shown));
  }

  /** Puts every label where the camera sees its point. */
  place(camera: Camera, width: number, height: number): void {
    for (const { at, shown } of this.labels) {
      const seen = at.clone().project(camera);
      shown.hidden = Math.abs(seen.z) > 1 || Math.abs(seen.x) > 1 || Math.abs(seen.y) > 1;
      shown.style.transform = `translate(${((seen.x + 1) * width) / 2}px, ${((1 - seen.y) * height) / 2}px) translate(6px, -120%)`;
    }
  }
}
