// Tips of charts without a pointer: arrow keys walk through the marks of a focused chart. (Plot itself answers to touch.)

/** Makes the tips of a chart reachable by keyboard; charts without tips stay as they are. */
export function offerTips(chart: Node): void {
  if (!(chart instanceof Element)) return;
  // a legend is a drawing of its own
  const drawings = chart instanceof SVGSVGElement ? [chart] : [...chart.querySelectorAll("svg")];
  drawings.filter((drawing) => drawing.querySelector('[aria-label="tip"]')).forEach(offerKeys);
}

function offerKeys(drawing: SVGSVGElement): void {
  drawing.setAttribute("tabindex", "0");
  let at = -1;
  drawing.addEventListener("keydown", (event) => {
    const marks = marksOf(drawing);
    const next = nextMark(event.key, at, marks.length);
    if (next === null) return;
    event.preventDefault();
    at = next;
    const box = marks[at]?.getBoundingClientRect();
    if (box) point(drawing, "pointermove", box.x + 0.5 * box.width, box.y + 0.5 * box.height);
  });
  drawing.addEventListener("blur", () => point(drawing, "pointerleave", 0, 0));
}

/** What the tips are about: the dots drawn last (those below are context), and where a chart has none its cells or bars. */
function marksOf(drawing: SVGSVGElement): Element[] {
  for (const kind of ["dot", "cell", "bar", "rect"]) {
    const marks = [...drawing.querySelectorAll(`[aria-label="${kind}"]`)].at(-1)?.children;
    if (marks && marks.length > 0) return [...marks];
  }
  return [];
}

/** The mark that a key leads to. */
export function nextMark(key: string, at: number, count: number): number | null {
  if (count === 0) return null;
  switch (key) {
    case "ArrowRight":
    case "ArrowDown":
      return Math.min(count - 1, at + 1);
    case "ArrowLeft":
    case "ArrowUp":
      return Math.max(0, at - 1);
    case "Home":
      return 0;
    case "End":
      return count - 1;
    default:
      return null;
  }
}

function point(drawing: SVGSVGElement, type: string, clientX: number, clientY: number): void {
  drawing.dispatchEvent(new PointerEvent(type, { clientX, clientY, pointerType: "mouse", bubbles: true }));
}
