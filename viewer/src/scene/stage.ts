// Canvas, camera and light of the scene; draws only when something changed.
import { Box3, Group, PerspectiveCamera, Scene, Sphere, Vector3, WebGLRenderer } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { element } from "../controls";
import { PAPER_WIDTH, onPrint } from "../printing";
import { Labels } from "./labels";

const FIELD_OF_VIEW = 32;

/** A place to draw in. */
export class Stage {
  readonly content = new Group();
  readonly labels: Labels;
  /** What sees the scene, for finding what the pointer is on. */
  readonly camera = new PerspectiveCamera(FIELD_OF_VIEW, 1, 0.01, 1000);
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly orbit: OrbitControls;
  private sphere = new Sphere(new Vector3(), 1);
  private points: Vector3[] = [];
  private waiting = false;
  /** The last view that was asked for, until the reader turns or zooms. */
  private view: { direction: Vector3; up: Vector3 } | null = null;

  /** Throws where the browser has no WebGL. */
  constructor(place: HTMLElement, words: string) {
    const holder = element("div", "", "stage");
    place.append(holder);
    // kept, so that printing and copying the picture work at any time
    this.renderer = new WebGLRenderer({ antialias: true, alpha: true, preserveDrawingBuffer: true });
    this.renderer.localClippingEnabled = true; // materials with clip planes obey them
    const { canvas } = this;
    canvas.tabIndex = 0;
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", words);
    holder.append(canvas);
    this.labels = new Labels(holder);
    this.scene.add(this.content, this.labels.group);
    this.orbit = new OrbitControls(this.camera, canvas);
    this.orbit.enableZoom = false; // the wheel scrolls the page; the buttons and + − zoom
    this.orbit.addEventListener("change", () => this.draw());
    this.orbit.addEventListener("start", () => this.leaveView());
    canvas.addEventListener("keydown", (event) => this.steer(event));
    new ResizeObserver(() => this.fit(holder.clientWidth)).observe(holder);
    onPrint((isPaper) => this.fit(isPaper ? PAPER_WIDTH : holder.clientWidth));
    this.fit(holder.clientWidth);
  }

  /** Where the scene is drawn and the pointer is heard. */
  get canvas(): HTMLCanvasElement {
    return this.renderer.domElement;
  }

  /** Looks at everything from a direction; `up` is the direction that points up on the screen. */
  lookFrom(direction: Vector3, up: Vector3): void {
    const towards = direction.clone().normalize();
    const { target, distance } = this.fitting(towards, up);
    this.view = { direction, up };
    this.camera.up.copy(up);
    this.camera.position.copy(target).addScaledVector(towards, distance);
    this.camera.near = distance / 100;
    this.camera.far = distance * 10;
    this.camera.updateProjectionMatrix();
    this.orbit.target.copy(target);
    this.camera.lookAt(target);
    this.draw();
  }

  /** Where to look and from how far, so that all points are seen and their picture lies in the middle. */
  private fitting(towards: Vector3, up: Vector3): { target: Vector3; distance: number } {
    const right = up.clone().cross(towards).normalize();
    const upright = towards.clone().cross(right);
    const slope = 0.86 * Math.tan((0.5 * FIELD_OF_VIEW * Math.PI) / 180);
    const target = this.sphere.center.clone();
    const arms = () => this.points.map((point) => point.clone().sub(target));
    const distance = () => Math.max(this.sphere.radius, ...arms().map((arm) => Math.max(Math.abs(arm.dot(right)) / this.camera.aspect, Math.abs(arm.dot(upright))) / slope + arm.dot(towards)));
    // the middle of the picture moves with the distance
    for (let round = 0; round < 6; round++) {
      const far = distance();
      const middle = (axis: Vector3) => {
        const seen = arms().map((arm) => arm.dot(axis) / (far - arm.dot(towards)));
        return 0.5 * far * (Math.min(...seen) + Math.max(...seen));
      };
      const [across, above] = [middle(right), middle(upright)];
      if (this.points.length > 0) target.addScaledVector(right, across).addScaledVector(upright, above);
    }
    return { target, distance: distance() };
  }

  private leaveView(): void {
    this.view = null;
  }

  /** The points that must be seen. */
  frame(points: Vector3[]): void {
    this.points = points;
    new Box3().setFromPoints(points).getBoundingSphere(this.sphere);
    this.sphere.radius = Math.max(this.sphere.radius, 1e-3);
  }

  zoom(factor: number): void {
    this.leaveView();
    this.camera.position.sub(this.orbit.target).multiplyScalar(factor).add(this.orbit.target);
    this.draw();
  }

  /** Draws with the next frame of the browser. */
  draw(): void {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => {
      this.waiting = false;
      this.drawNow();
    });
  }

  drawNow(): void {
    const { canvas } = this;
    this.renderer.render(this.scene, this.camera);
    this.labels.place(this.scene, this.camera, canvas.clientWidth, canvas.clientHeight);
  }

  private steer(event: KeyboardEvent): void {
    const turns: Record<string, [number, number]> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
    const turn = turns[event.key];
    if (turn) this.turn(0.12 * turn[0], 0.12 * turn[1]);
    else if (event.key === "+" || event.key === "=") this.zoom(0.9);
    else if (event.key === "-") this.zoom(1 / 0.9);
    else return;
    event.preventDefault();
  }

  private turn(sideways: number, upwards: number): void {
    this.leaveView();
    const { position, up } = this.camera;
    const arm = position.clone().sub(this.orbit.target);
    arm.applyAxisAngle(up, sideways);
    const across = up.clone().cross(arm).normalize();
    const raised = arm.clone().applyAxisAngle(across, -upwards);
    if (Math.abs(raised.angleTo(up) - 0.5 * Math.PI) < 1.5) arm.copy(raised);
    position.copy(this.orbit.target).add(arm);
    this.camera.lookAt(this.orbit.target);
    this.draw();
  }

  /** Takes so much room; a view that nobody turned shows everything again. */
  private fit(room: number): void {
    if (room === 0) return; // folded
    const width = Math.max(200, room);
    const height = Math.round(Math.min(0.66 * width, 560));
    this.renderer.setPixelRatio(Math.min(2, devicePixelRatio));
    this.renderer.setSize(width, height);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    if (this.view) this.lookFrom(this.view.direction, this.view.up);
    this.drawNow();
  }
}
