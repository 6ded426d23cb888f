// Lines and markers of the scene, with widths in pixels.
import { BufferGeometry, CanvasTexture, Group, LineDashedMaterial, LineSegments, type Object3D, Points, PointsMaterial, SRGBColorSpace, type Vector3 } from "three";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/examples/jsm/lines/LineSegmentsGeometry.js";
import type { Segment } from "./geometry";

/** Solid lines of this width (pixels). */
export function lines(segments: Segment[], color: string, width: number): Object3D {
  if (segments.length === 0) return new Group();
  const geometry = new LineSegmentsGeometry();
  geometry.setPositions(segments.flatMap(([a, b]) => [a.x, a.y, a.z, b.x, b.y, b.z]));
  return new LineSegments2(geometry, new LineMaterial({ color, linewidth: width }));
}

/** Thin dashed lines; the dash is a length of the scene (m). */
export function dashed(segments: Segment[], color: string, dash: number): Object3D {
  const geometry = new BufferGeometry().setFromPoints(segments.flat());
  const made = new LineSegments(geometry, new LineDashedMaterial({ color, dashSize: dash, gapSize: dash }));
  made.computeLineDistances();
  return made;
}

/** Round markers of this size (pixels), full or as rings. */
export function markers(points: Vector3[], color: string, size: number, full: boolean): Object3D {
  const geometry = new BufferGeometry().setFromPoints(points);
  const map = disc(full);
  const material = new PointsMaterial({ color, size: size * devicePixelRatio, sizeAttenuation: false, map, alphaTest: 0.3, transparent: true });
  return new Points(geometry, material);
}

/** A knob to take hold of: four arrows on a disc, in front of everything. */
export function handle(at: Vector3, ink: string, paper: string, hovered: boolean): Object3D {
  const map = knob(ink, paper);
  const size = (hovered ? 32 : 26) * devicePixelRatio;
  const made = new Points(new BufferGeometry().setFromPoints([at]), new PointsMaterial({ size, sizeAttenuation: false, map, alphaTest: 0.1, transparent: true, depthTest: false }));
  made.renderOrder = 10;
  return made;
}

function knob(ink: string, paper: string): CanvasTexture {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 128;
  const context = canvas.getContext("2d");
  if (context) {
    context.translate(64, 64);
    context.fillStyle = paper;
    context.strokeStyle = ink;
    context.lineWidth = 7;
    context.beginPath();
    context.arc(0, 0, 56, 0, 2 * Math.PI);
    context.fill();
    context.stroke();
    context.fillStyle = ink;
    for (let arrow = 0; arrow < 4; arrow++) {
      context.rotate(0.5 * Math.PI);
      context.fillRect(0, -4, 28, 8);
      context.beginPath();
      context.moveTo(44, 0);
      context.lineTo(26, -14);
      context.lineTo(26, 14);
      context.fill();
    }
  }
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = SRGBColorSpace;
  return texture;
}

function disc(full: boolean): CanvasTexture {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 64;
  const context = canvas.getContext("2d");
  if (context) {
    context.beginPath();
    context.arc(32, 32, full ? 28 : 23, 0, 2 * Math.PI);
    context.fillStyle = context.strokeStyle = "#fff";
    context.lineWidth = 13;
    if (full) context.fill();
    else context.stroke();
  }
  return new CanvasTexture(canvas);
}

/** Frees what the graphics card holds. */
export function dispose(object: Object3D): void {
  object.traverse((part) => {
    const { geometry, material } = part as Partial<LineSegments>;
    geometry?.dispose();
    for (const one of Array.isArray(material) ? material : [material]) one?.dispose();
  });
}
