// Words beside points of the scene, as elements above the canvas: sharp at any size, and they print.
import { type Camera, Vector3 } from "three";
import { element } from "../controls";

/** Words at a point of the scene. */
export interface Label {
  at: Vector3;
  text: string;
  className?: string;
  /** Places on a surface, with its normals, of which the words take the one that faces the reader best; hidden without any. */
  places?: Place[];
}

interface Place {
  at: Vector3;
  normal: Vector3;
}

interface Pixel {
  x: number;
  y: number;
}

/** Places that are tried before words are left out. */
const MOST_TRIED = 10;

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

  /** Puts every label where the camera sees its point; those with a choice of places keep clear of the others. */
  place(camera: Camera, width: number, height: number): void {
    const pixel = (at: Vector3): Pixel | null => {
      const seen = at.clone().project(camera);
      const isOutside = Math.abs(seen.z) > 1 || Math.abs(seen.x) > 1 || Math.abs(seen.y) > 1;
      return isOutside ? null : { x: ((seen.x + 1) * width) / 2, y: ((1 - seen.y) * height) / 2 };
    };
    const taken: Pixel[] = [];
    for (const { at, shown, places, text } of [...this.labels].sort((a, b) => Number(!!a.places) - Number(!!b.places))) {
      const spot = places ? this.facing(places, camera, pixel, taken) : pixel(at);
      shown.hidden = !spot;
      if (!spot) continue;
      // words beside a point reach to the right and upwards
      taken.push(...(places ? [spot] : [0, 1, 2].map((part) => ({ x: spot.x + 6 + 3.5 * part * text.length, y: spot.y - 10 }))));
      shown.style.transform = `translate(${spot.x}px, ${spot.y}px) ${places ? "translate(-50%, -50%)" : "translate(6px, -120%)"}`;
    }
  }

  /** Where words may stand that have a choice: facing the camera, not hidden, and clear of others; null where no place is. */
  private facing(places: Place[], camera: Camera, pixel: (at: Vector3) => Pixel | null, taken: Pixel[]): Pixel | null {
    const faced = places.map(({ at, normal }) => ({ at, facing: camera.position.clone().sub(at).normalize().dot(normal) }));
    const turned = faced.filter(({ facing }) => facing > 0.2).sort((a, b) => b.facing - a.facing);
    const isClear = ({ x, y }: Pixel) => taken.every((other) => Math.abs(other.x - x) > 24 || Math.abs(other.y - y) > 18);
    for (const { at } of turned.slice(0, MOST_TRIED)) {
      const spot = pixel(at);
      if (spot && isClear(spot) && !this.isHidden(at)) return spot;
    }
    return null;
  }
}
