// The surfaces of the results in the scene: their colours, transparency, clip plane, letters, and the names of the cables that limit.
import { BoxGeometry, type BufferGeometry, EdgesGeometry, Group, type Plane, Raycaster, Vector3 } from "three";
import { choice, element } from "../controls";
import { significant } from "../number";
import { dashed, dispose, lines } from "../scene/drawing";
import type { Segment } from "../scene/geometry";
import type { Label } from "../scene/labels";
import { colour } from "../theme";
import { type ClipChoice, offerClip } from "./clip";
import { type Colouring, type Patch, type Piece, areaOf, cableColour, isKnown, marginColour, marginsOf, patchesOf, piecesOf, placeOf } from "./colouring";
import { marginOf } from "./field";
import { type Surface, cut, dress, geometryOfPieces, paint, paintEach, surface, top } from "./hull";
import { colourLegend } from "./legend";
import { levelsOf } from "./margin-chart";
import { type Platform, cableName } from "./platform";
import type { ShownRegion } from "./regions";

/** Smaller patches, as a share of their surface, bear no name: it would hide them. */
const NAMED = 0.01;
/** Colours are told apart through other surfaces only when these are nearly opaque. */
const OPAQUE = 0.9;

/** A surface of more triangles hides no names: to find out would take too long. */
const SEARCHED = 20_000;

/** A surface with what its limiting cables make of it. */
interface Cut {
  geometry: BufferGeometry;
  pieces: Piece[];
  borders: Segment[];
  patches: Patch[];
  /** Area by cable (m²). */
  areas: Map<number, number>;
}

/** Surfaces that are drawn anew whenever a choice changes. */
export class Surfaces {
  readonly group = new Group();
  /** What the colours mean. */
  readonly legend = element("div");
  /** Letters of the results and names of limiting cables. */
  labels: Label[] = [];
  private readonly cuts = new Group();
  private readonly surfaces: Surface[];
  private readonly plain: BufferGeometry[];
  private readonly byCable = new Map<ShownRegion, Cut>();
  private opacity = 0.35;
  private clip: ClipChoice = () => null;
  private colouring: () => Colouring = () => "result";

  constructor(
    private readonly platform: Platform,
    private readonly regions: ShownRegion[],
    private readonly size: number,
  ) {
    this.surfaces = regions.map(({ region }) => surface(region));
    this.plain = this.surfaces.map(({ geometry }) => geometry);
    this.group.add(...this.surfaces, this.cuts);
  }

  /** Choices of colour, opacity and clip plane. */
  offer(controls: HTMLElement, changed: () => void): void {
    if (this.regions.length === 0) return;
    const slider = this.offerOpacity(controls, changed);
    this.offerColouring(controls, slider, changed);
    this.clip = offerClip(controls, this.platform.data.grid.axes, changed);
  }

  private offerOpacity(controls: HTMLElement, changed: () => void): HTMLInputElement {
    const slider = element("input");
    Object.assign(slider, { type: "range", min: "0.05", max: "1", step: "0.05", value: String(this.opacity) });
    slider.addEventListener("input", () => {
      this.opacity = slider.valueAsNumber;
      changed();
    });
    const label = element("label", "Opacity of surfaces ");
    label.append(slider);
    controls.append(label);
    return slider;
  }

  private offerColouring(controls: HTMLElement, slider: HTMLInputElement, changed: () => void): void {
    const names: Record<Colouring, string> = { result: "by result", cable: "by limiting cable", margin: "by margin" };
    const offered = (Object.keys(names) as Colouring[]).filter((one) => this.regions.some(({ region }) => region.triangles.length > 0 && isKnown(region, one)));
    let transparent = this.opacity;
    this.colouring = choice(controls, "Colour of surfaces", offered.map((value) => ({ label: names[value], value })), (chosen) => {
      const wasOpaque = this.opacity === OPAQUE;
      if (!wasOpaque) transparent = this.opacity;
      this.opacity = chosen === "result" ? transparent : OPAQUE;
      slider.value = String(this.opacity);
      changed();
    });
  }

  /** Draws all of them again. */
  build(): void {
    const { cuts } = this;
    const clip = this.clip();
    dispose(cuts);
    cuts.clear();
    this.labels = [];
    this.regions.forEach((one, index) => {
      const drawn = this.surfaces[index] as Surface;
      drawn.visible = one.shown;
      drawn.renderOrder = index;
      if (one.shown) this.show(one, drawn, clip);
    });
    if (clip) cuts.add(lines(this.clipFrame(clip), colour("muted"), 1));
    this.explain();
  }

  private show(one: ShownRegion, drawn: Surface, clip: Plane | null): void {
    const { region, letter, dashes } = one;
    const own = colour(one.colour);
    this.colour(one, drawn);
    dress(drawn, this.opacity, clip);
    if (clip) this.cuts.add(dashes === "none" ? lines(cut(region, clip), own, 3) : dashed(cut(region, clip), own, 0.01 * this.size));
    const at = top(region, clip);
    if (at) this.labels.push({ at, text: letter, className: "letter" });
    if (this.now(one) !== "cable") return;
    const { patches, borders } = this.cutOf(one);
    const isKept = (point: Vector3) => !clip || clip.distanceToPoint(point) >= 0;
    this.cuts.add(lines(borders.filter((border) => border.every(isKept)), colour("ink"), 1.5));
    const several = this.regions.filter((other) => other.shown).length > 1;
    for (const { cable, places } of patches.filter(({ share }) => share > NAMED)) {
      const kept = places.filter((place) => isKept(place.at));
      // cut open, a surface shows its inside too
      if (clip && this.isSearched(drawn)) kept.push(...kept.map((place) => ({ at: place.at, normal: place.normal.clone().negate() })));
      if (kept[0]) this.labels.push({ at: kept[0].at, places: kept, text: `${several ? `${letter} ` : ""}${this.name(cable)}`, className: "patch" });
    }
  }

  /** Gives a surface the colours of what they tell. */
  private colour(one: ShownRegion, drawn: Surface): void {
    const resolved = (name: string) => colour(name.slice("var(--".length, -1));
    const plain = this.plain[this.regions.indexOf(one)] as BufferGeometry;
    const now = this.now(one);
    if (drawn.geometry !== plain && drawn.geometry !== this.byCable.get(one)?.geometry) drawn.geometry.dispose();
    drawn.geometry = plain;
    if (now === "cable") {
      const { geometry, pieces } = this.cutOf(one);
      drawn.geometry = geometry;
      paintEach(drawn, geometry, pieces.map(({ cable }) => resolved(cableColour(cable))));
    } else if (now === "margin") {
      drawn.geometry = plain.toNonIndexed();
      paintEach(drawn, drawn.geometry, marginsOf(one.region).map((margin) => resolved(marginColour(margin, this.levels()))));
    } else paint(drawn, colour(one.colour));
  }

  private cutOf(one: ShownRegion): Cut {
    const known = this.byCable.get(one);
    if (known) return known;
    const { region } = one;
    const normals = (this.plain[this.regions.indexOf(one)] as BufferGeometry).getAttribute("normal").array;
    const { pieces, borders } = piecesOf(region);
    const areas = new Map<number, number>();
    for (const piece of pieces) areas.set(piece.cable, (areas.get(piece.cable) ?? 0) + areaOf(region, piece));
    const made: Cut = {
      geometry: geometryOfPieces(region, pieces, normals),
      pieces,
      borders: borders.map(([from, to]): Segment => [placeOf(region, from), placeOf(region, to)]),
      patches: patchesOf(region, normals),
      areas,
    };
    this.byCable.set(one, made);
    return made;
  }

  /** True for a point that a surface hides from a camera here. */
  hides(from: Vector3, point: Vector3): boolean {
    const clip = this.clip();
    const [towards, distance] = [point.clone().sub(from).normalize(), point.distanceTo(from)];
    const ray = new Raycaster(from, towards, 0, distance - 0.01 * this.size);
    const searched = this.surfaces.filter((drawn) => drawn.visible && this.isSearched(drawn));
    return ray.intersectObjects(searched, false).some((hit) => !clip || clip.distanceToPoint(hit.point) >= 0);
  }

  private isSearched({ geometry }: Surface): boolean {
    return (geometry.index ?? geometry.getAttribute("position")).count <= 3 * SEARCHED;
  }

  /** What the colours of a surface tell; its result where nothing else is known. */
  private now({ region }: ShownRegion): Colouring {
    return isKnown(region, this.colouring()) ? this.colouring() : "result";
  }

  private levels(): number[] {
    const { grid } = this.platform.data;
    return levelsOf(grid.margin.map((_, node) => marginOf(grid, node)).filter(Number.isFinite));
  }

  private name(cable: number): string {
    return cable === 0 ? "none" : cableName(this.platform.data, cable - 1);
  }

  /** Fills the legend. */
  private explain(): void {
    const shown = this.regions.filter((one) => one.shown);
    const unknown = shown.filter((one) => this.now(one) !== this.colouring() && one.region.triangles.length > 0).map(({ letter }) => element("p", `${letter}: not known, so in the colour of its result.`, "remark"));
    switch (this.colouring()) {
      case "cable":
        return this.legend.replaceChildren(colourLegend("Limiting cable, share of the surface", this.shares(shown)), ...unknown);
      case "margin":
        return this.legend.replaceChildren(colourLegend(`Margin${this.unit(shown)}`, bands(this.levels())), ...unknown);
      default:
        return this.legend.replaceChildren();
    }
  }

  private unit(shown: ShownRegion[]): string {
    const unit = shown.find((one) => this.now(one) === "margin")?.region.margin_unit ?? "";
    return unit === "" || unit === "1" ? "" : `, ${unit}`;
  }

  /** Cables that limit the shown surfaces, by their number. */
  private shares(shown: ShownRegion[]): { colour: string; words: string }[] {
    const areas = shown.filter((one) => this.now(one) === "cable").flatMap((one) => [...this.cutOf(one).areas]);
    const all = areas.reduce((sum, [, area]) => sum + area, 0) || 1;
    const cables = [...new Set(areas.map(([cable]) => cable))].sort((a, b) => a - b);
    const share = (cable: number) => areas.filter(([other]) => other === cable).reduce((sum, [, area]) => sum + area, 0) / all;
    return cables.map((cable) => ({ colour: cableColour(cable), words: `${this.name(cable)}: ${significant(100 * share(cable), 2)} %` }));
  }

  /** The rectangle that the clip plane cuts out of the grid's box. */
  private clipFrame(clip: Plane): Segment[] {
    const corners = boxCorners(this.platform);
    const [low, high] = [corners[0] as Vector3, corners.at(-1) as Vector3];
    const size = high.clone().sub(low);
    const box = new EdgesGeometry(new BoxGeometry(size.x, size.y, size.z)).getAttribute("position");
    const middle = low.clone().lerp(high, 0.5);
    const flat = (index: number) => clip.projectPoint(new Vector3().fromBufferAttribute(box, index).add(middle), new Vector3());
    return [...Array(box.count / 2).keys()].map((k): Segment => [flat(2 * k), flat(2 * k + 1)]);
  }
}

/** Bands of a margin with their colours. */
function bands(levels: number[]): { colour: string; words: string }[] {
  const number = (level: number) => significant(level, 2);
  const middle = (k: number) => (k === 0 ? (levels[0] as number) - 1 : (levels[k - 1] as number));
  return [...levels, Number.NaN].map((level, k) => {
    const from = levels[k - 1];
    const words = from === undefined ? `below ${number(level)}` : Number.isNaN(level) ? `${number(from)} and more` : `${number(from)} to ${number(level)}`;
    return { colour: marginColour(middle(k), levels), words };
  });
}

/** Corners of the grid's box. */
export function boxCorners(platform: Platform): Vector3[] {
  const { axes } = platform.data.grid;
  const ends = axes.map((axis) => [axis.start_m, axis.start_m + (axis.count - 1) * axis.step_m]);
  return [...Array(1 << axes.length).keys()].map((k) => platform.positionOf(ends.map((pair, axis) => pair[(k >> axis) & 1] as number)));
}
