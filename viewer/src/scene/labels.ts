// Words beside points of the scene, as elements above the canvas: sharp at any size, and they print.
import { type Camera, Vector3 } from "three";
import { element } from "../controls";

/** Words at a point of the scene. */
export interface Label {
  at: Vector3;
  text: string;
  className?: string;
  /** Places on a surface, with its normals, of which the words take the one that faces the reader best; hidden without any. */
  places?: { at: Vector3; normal: Vector3 }[];
}

interface Shown extends Label {
  shown: HTMLElement;
}

/** Labels of one scene. */
export class Labels {
  private labels: Shown[] = [];
  /** True for a point that something hides from the camera. */
  isHidden: (point: Vector3) => boolean = () => false;
  private readonly layer = element("div", "", "labels");

  constructor(stage: HTMLElement) {
    this.layer.setAttribute("aria-hidden", "true");
    stage.append(this.layer);
  }

  /** Replaces all labels. */
  set(labels: Label[]): void {
    this.labels = labels.map((label) => ({ ...label, shown: element("span", label.text, label.className ?? "") }));
    this.layer.replaceChildren(...this.labels.map((label) => label.shown));
  }

  /** Puts every label where the camera sees its point. */
  place(camera: Camera, width: number, height: number): void {
    for (const { at: fixed, shown, places } of this.labels) {
      const at = places ? this.facing(places, camera) : fixed;
      shown.hidden = !at;
      if (!at) continue;
      const seen = at.clone().project(camera);
      shown.hidden = Math.abs(seen.z) > 1 || Math.abs(seen.x) > 1 || Math.abs(seen.y) > 1;
      const beside = places ? "translate(-50%, -50%)" : "translate(6px, -120%)";
      shown.style.transform = `translate(${((seen.x + 1) * width) / 2}px, ${((1 - seen.y) * height) / 2}px) ${beside}`;
    }
  }

  /** The place that faces the camera best and is not hidden; none where all turn away. */
  private facing(places: { at: Vector3; normal: Vector3 }[], camera: Camera): Vector3 | null {
    const faced = places.map(({ at, normal }) => ({ at, facing: camera.position.clone().sub(at).normalize().dot(normal) }));
    const turned = faced.filter(({ facing }) => facing > 0.2).sort((a, b) => b.facing - a.facing);
    return turned.slice(0, 6).find(({ at }) => !this.isHidden(at))?.at ?? null;
  }
}
