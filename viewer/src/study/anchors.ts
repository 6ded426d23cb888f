// Frame anchors with the numbers of their cables; those that lie on each other share a label.
import { alongAxes } from "../robot";
import * as Plot from "@observablehq/plot";
import { INK, PAPER } from "../charts/style";
import type { StudyData } from "../data";

interface Anchors {
  at: number[];
  names: string[];
}

/** Anchors nearer to each other than this share of all of them share a label. */
const NEAR = 0.06;

/** Marks along two axes of the robot; none where they are not shown. */
export function anchorMarks(data: StudyData, axes: number[], shown: boolean): Plot.Markish[] {
  if (!shown) return [];
  const all = data.robot.cables.map(({ name, frame_anchor_m }) => {
    const anchor = alongAxes(data.robot, frame_anchor_m);
    return { name, at: axes.map((axis) => anchor[axis] as number) };
  });
  const size = Math.max(...axes.map((_, k) => Math.max(...all.map(({ at }) => at[k] as number)) - Math.min(...all.map(({ at }) => at[k] as number))));
  const groups: Anchors[] = [];
  for (const { name, at } of all) {
    const near = groups.find((group) => Math.hypot(...group.at.map((value, k) => value - (at[k] as number))) < NEAR * size);
    if (near) {
      near.names.push(name);
      // the label stands above the highest of them
      if ((at[1] as number) > (near.at[1] as number)) near.at = at;
    } else groups.push({ at, names: [name] });
  }
  return [
    Plot.dot(all, { x: (one) => one.at[0], y: (one) => one.at[1], symbol: "square", r: 5, fill: INK, stroke: PAPER }),
    Plot.text(groups, { x: (one: Anchors) => one.at[0], y: (one: Anchors) => one.at[1], text: (one: Anchors) => one.names.join(", "), dy: -14, fontWeight: 600, fill: INK, stroke: PAPER, strokeWidth: 4 }),
  ];
}
