// Words beside points of the scene, as elements above the canvas: sharp at any size, they print, and none lies on another.
import { type Camera, Group, type Scene, Vector2, Vector3 } from "three";
import { CSS2DObject, CSS2DRenderer } from "three/examples/jsm/renderers/CSS2DRenderer.js";
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

/** Corner, width and height on the screen (pixels). */
interface Box extends Pixel {
  width: number;
  height: number;
}

/** Places that are tried before words are left out. */
const MOST_TRIED = 10;

/** Sides of a point where words may stand, the best first, as the part of the words that lies on the point. */
const SIDES: [number, number][] = [[0, 1], [1, 1], [0, 0], [1, 0], [0.5, 1], [0.5, 0]];

interface Shown extends Label {
  object: CSS2DObject;
}

/** Labels of one scene. */
export class Labels {
  /** What the scene holds of them. */
  readonly group = new Group();
  private labels: Shown[] = [];
  /** True for a point that something hides from the camera. */
  isHidden: (point: Vector3) => boolean = () => false;
  private readonly renderer = new CSS2DRenderer();

  constructor(stage: HTMLElement) {
    const layer = this.renderer.domElement;
    layer.className = "labels";
    layer.setAttribute("aria-hidden", "true");
    stage.append(layer);
  }

  /** Replaces all labels. */
  set(labels: Label[]): void {
    this.group.clear();
    this.labels = labels.map((label) => ({ ...label, object: new CSS2DObject(element("span", label.text, label.className ?? "")) }));
    for (const { object, at } of this.labels) {
      object.position.copy(at);
      this.group.add(object);
    }
  }

  /** Puts every label where the camera sees its point and no other label is; those that find no place are hidden. */
  place(scene: Scene, camera: Camera, width: number, height: number): void {
    const pixel = (at: Vector3): Pixel | null => {
      const seen = at.clone().project(camera);
      const isOutside = Math.abs(seen.z) > 1 || Math.abs(seen.x) > 1 || Math.abs(seen.y) > 1;
      return isOutside ? null : { x: ((seen.x + 1) * width) / 2, y: ((1 - seen.y) * height) / 2 };
    };
    const taken: Box[] = [];
    for (const label of [...this.labels].sort((a, b) => Number(!!a.places) - Number(!!b.places))) {
      const box = label.places ? this.facing(label, camera, pixel, taken) : beside(label, pixel(label.at), taken, { width, height });
      label.object.visible = box !== null;
      if (box) taken.push(box);
    }
    this.renderer.setSize(width, height);
    this.renderer.render(scene, camera);
  }

  /** Where words may stand that have a choice: facing the camera, not hidden, and clear of others; null where no place is. */
  private facing({ places = [], text, object }: Shown, camera: Camera, pixel: (at: Vector3) => Pixel | null, taken: Box[]): Box | null {
    const faced = places.map(({ at, normal }) => ({ at, facing: camera.position.clone().sub(at).normalize().dot(normal) }));
    const turned = faced.filter(({ facing }) => facing > 0.2).sort((a, b) => b.facing - a.facing);
    for (const { at } of turned.slice(0, MOST_TRIED)) {
      const spot = pixel(at);
      const box = spot && boxAt(spot, [0.5, 0.5], text);
      if (!box || !isClear(box, taken) || this.isHidden(at)) continue;
      object.position.copy(at);
      object.center.set(0.5, 0.5);
      return box;
    }
    return null;
  }
}

/** The first side of the point where the words are clear of others and inside the picture. */
function beside({ text, object }: Shown, spot: Pixel | null, taken: Box[], picture: { width: number; height: number }): Box | null {
  if (!spot) return null;
  for (const side of SIDES) {
    const box = boxAt(spot, side, text);
    const isInside = box.x >= 0 && box.y >= 0 && box.x + box.width <= picture.width && box.y + box.height <= picture.height;
    if (!isInside || !isClear(box, taken)) continue;
    object.center.copy(new Vector2(...side));
    return box;
  }
  return null;
}

/** About as large as the words are with the padding that the style gives them. */
function boxAt({ x, y }: Pixel, [across, up]: [number, number], text: string): Box {
  const [width, height] = [10 + 8 * text.length, 20];
  return { x: x - across * width, y: y - up * height, width, height };
}

function isClear(box: Box, taken: Box[]): boolean {
  return taken.every((other) => box.x + box.width <= other.x || other.x + other.width <= box.x || box.y + box.height <= other.y || other.y + other.height <= box.y);
}
