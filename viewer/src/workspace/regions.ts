// The results on the page: each has a letter, a colour and a line of its own, and may be hidden.
import { element } from "../controls";
import { significant } from "../number";
import type { WorkspaceRegion, WorkspaceData } from "../data";
import { sample } from "./legend";

/** A result with its looks. */
export interface ShownRegion {
  region: WorkspaceRegion;
  letter: string;
  /** Name of the colour (CSS variable). */
  colour: string;
  /** Dashes of its outline (pixels). */
  dashes: string;
  shown: boolean;
}

const DASHES = ["none", "9 4", "2 3", "10 3 2 3"];

/** All results, the first ones shown. */
export function regionsOf(data: WorkspaceData): ShownRegion[] {
  return data.regions.map((region, index) => ({
    region,
    letter: String.fromCharCode(65 + (index % 26)),
    colour: `region-${(index % DASHES.length) + 1}`,
    dashes: DASHES[index % DASHES.length] as string,
    shown: true,
  }));
}

/** A box to tick for each result, with its measure. */
export function offerRegions(place: HTMLElement, regions: ShownRegion[], changed: () => void): void {
  if (regions.length === 0) return;
  const list = element("ul", "", "legend regions");
  list.setAttribute("aria-label", "Results");
  for (const one of regions) {
    const box = element("input");
    Object.assign(box, { type: "checkbox", checked: one.shown });
    box.addEventListener("change", () => {
      one.shown = box.checked;
      changed();
    });
    const label = element("label");
    const line = sample({ stroke: `var(--${one.colour})`, "stroke-width": 3, "stroke-dasharray": one.dashes });
    label.append(box, line, element("span", `${one.letter}: ${one.region.name}, ${measureWords(one.region)}`));
    const entry = element("li");
    entry.append(label);
    list.append(entry);
  }
  place.append(list);
}

/** E.g. "243.1 ± 0.8 m³". */
function measureWords({ measure, error_bound, unit }: WorkspaceRegion): string {
  return `${significant(measure, 4)}${error_bound === null ? "" : ` ± ${significant(error_bound, 2)}`} ${unit}`;
}
