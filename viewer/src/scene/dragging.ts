// Moving something in space with the pointer: in a plane through it, so that it stays under the pointer.
import { Plane, Raycaster, Vector2, Vector3 } from "three";
import type { Stage } from "./stage";

/** Something that can be moved. */
export interface Movable {
  /** Where it is. */
  position(): Vector3;
  /** Points to take hold of it by. */
  grips(): Vector3[];
  moveTo(position: Vector3): void;
  /** Normal of the plane that it moves in; null for the plane of the screen. */
  normal(): Vector3 | null;
  /** The pointer is on it, or no longer. */
  hover(on: boolean): void;
}

/** Pixels around a grip that count as on it: more for a finger. */
const REACH = { mouse: 16, pen: 20, touch: 30 };

/** Lets mouse, pen and finger move it; a pointer elsewhere turns the scene as before. */
export function offerDragging(stage: Stage, movable: Movable): void {
  const { canvas, camera } = stage;
  let held: { plane: Plane; offset: Vector3 } | null = null;
  const ray = (event: PointerEvent) => {
    const box = canvas.getBoundingClientRect();
    const caster = new Raycaster();
    caster.setFromCamera(new Vector2((2 * (event.clientX - box.left)) / box.width - 1, 1 - (2 * (event.clientY - box.top)) / box.height), camera);
    return caster.ray;
  };
  const isOn = (event: PointerEvent) => {
    const box = canvas.getBoundingClientRect();
    const reach = REACH[event.pointerType as keyof typeof REACH] ?? REACH.mouse;
    return movable.grips().some((grip) => {
      const seen = grip.clone().project(camera);
      const [x, y] = [box.left + ((seen.x + 1) * box.width) / 2, box.top + ((1 - seen.y) * box.height) / 2];
      return Math.hypot(event.clientX - x, event.clientY - y) < reach;
    });
  };
  const start = (event: PointerEvent) => {
    if (event.button !== 0 || !isOn(event)) return;
    const towards = camera.getWorldDirection(new Vector3());
    const chosen = movable.normal();
    // a plane seen from its edge would throw the thing far away
    const normal = chosen && Math.abs(chosen.dot(towards)) > 0.15 ? chosen : towards;
    const plane = new Plane().setFromNormalAndCoplanarPoint(normal, movable.position());
    const hit = ray(event).intersectPlane(plane, new Vector3());
    if (!hit) return;
    held = { plane, offset: movable.position().sub(hit) };
    canvas.setPointerCapture(event.pointerId);
    canvas.focus({ preventScroll: true });
    event.stopImmediatePropagation(); // or the scene would turn
  };
  const move = (event: PointerEvent) => {
    if (!held) {
      movable.hover(isOn(event));
      return;
    }
    const hit = ray(event).intersectPlane(held.plane, new Vector3());
    if (hit) movable.moveTo(hit.add(held.offset));
    event.stopImmediatePropagation();
  };
  const end = () => {
    held = null;
  };
  canvas.addEventListener("pointerdown", start, { capture: true });
  canvas.addEventListener("pointermove", move, { capture: true });
  canvas.addEventListener("pointerup", end);
  canvas.addEventListener("pointercancel", end);
}
