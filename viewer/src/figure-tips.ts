// Tips of the figures that come drawn in the page: what a mark says, at the pointer and by arrow keys.
import { element } from "./controls";
import type { ReportData } from "./data";
import { significant } from "./number";
import { nextMark } from "./tips";

/** A mark in the figure's own units, and what is said of it. */
interface Mark {
  x: number;
  y: number;
  words: string;
}

/** Farther from a mark than this (pixels of the screen) nothing is said. */
const REACH = 40;

/** Offers the tips of every figure of the page. */
export function offerFigureTips(data: ReportData): void {
  const tip = element("div", "", "tip");
  tip.hidden = true;
  tip.setAttribute("role", "status");
  document.body.append(tip);
  for (const figure of document.querySelectorAll<SVGSVGElement>("svg.figure")) {
    const marks = [...titled(figure), ...cells(figure, data)];
    if (marks.length > 0) offer(figure, marks, tip);
  }
}

function offer(figure: SVGSVGElement, marks: Mark[], tip: HTMLElement): void {
  const hide = () => {
    tip.hidden = true;
  };
  const show = (mark: Mark) => {
    const at = onScreen(figure, mark);
    tip.textContent = mark.words;
    tip.hidden = false;
    const box = tip.getBoundingClientRect();
    tip.style.left = `${Math.max(4, Math.min(innerWidth - box.width - 4, at.x - 0.5 * box.width))}px`;
    tip.style.top = `${at.y - box.height - 12 > 4 ? at.y - box.height - 12 : at.y + 14}px`;
  };
  figure.addEventListener("pointermove", (event) => {
    const near = nearest(figure, marks, event);
    if (near) show(near);
    else hide();
  });
  figure.addEventListener("pointerleave", hide);
  figure.setAttribute("tabindex", "0");
  let at = -1;
  figure.addEventListener("keydown", (event) => {
    const next = event.key === "Escape" ? null : nextMark(event.key, at, marks.length);
    if (next === null) {
      if (event.key === "Escape") hide();
      return;
    }
    event.preventDefault();
    at = next;
    show(marks[at] as Mark);
  });
  figure.addEventListener("blur", hide);
}

/** Marks with a title of their own, which the tip takes over from the browser. */
function titled(figure: SVGSVGElement): Mark[] {
  return [...figure.querySelectorAll<SVGTitleElement>("circle > title")].map((title) => {
    const circle = title.parentElement as unknown as SVGCircleElement;
    const words = title.textContent ?? "";
    circle.setAttribute("aria-label", words);
    title.remove();
    return { x: circle.cx.baseVal.value, y: circle.cy.baseVal.value, words };
  });
}

/** Cells of the correlations: the drawing says where they lie, the data what they are. */
function cells(figure: SVGSVGElement, data: ReportData): Mark[] {
  const [left, top, side] = (figure.dataset.cells ?? "").split(" ").map(Number);
  const lower = data.correlation;
  const names = data.result.candidates[data.shown]?.parameters?.map((parameter) => parameter.name) ?? [];
  if (!lower || left === undefined || top === undefined || side === undefined) return [];
  return lower.flatMap((values, row) =>
    values.map((value, column) => ({
      x: left + side * (column + 0.5),
      y: top + side * (row + 0.5),
      words: `${names[row]}\n${names[column]}\n${value === null ? "not determined" : `correlation ${significant(value, 3)}`}`,
    })),
  );
}

function onScreen(figure: SVGSVGElement, mark: Mark): DOMPoint {
  return new DOMPoint(mark.x, mark.y).matrixTransform(figure.getScreenCTM() ?? new DOMMatrix());
}

function nearest(figure: SVGSVGElement, marks: Mark[], event: PointerEvent): Mark | null {
  const matrix = figure.getScreenCTM();
  if (!matrix) return null;
  const pointer = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix.inverse());
  const distance = (mark: Mark) => Math.hypot(mark.x - pointer.x, mark.y - pointer.y);
  const near = marks.reduce((best, mark) => (distance(mark) < distance(best) ? mark : best));
  return distance(near) * matrix.a <= REACH ? near : null;
}
