// The place of a chart: it draws again when its width changes, and tells when there is nothing to draw.
import { element } from "./controls";
import { PAPER_WIDTH, onPrint } from "./printing";
import { offerTips } from "./tips";

/** Draws a chart of this width, or returns null where the data have nothing to show. */
export type Draw = (width: number) => Node | null;

/** A figure of the page with room for choices above the chart. */
export interface Figure {
  controls: HTMLElement;
  /** Draws again, e.g. after a choice. */
  redraw(): void;
}

/** Fills the figure named `name`; a figure without anything to show is taken off the page. */
export function fill(name: string, makeDraw: (figure: Figure) => Draw | null): void {
  const place = document.querySelector<HTMLElement>(`figure[data-chart="${name}"]`);
  if (!place) return;
  const controls = element("div", "", "controls");
  const canvas = element("div", "", "chart");
  place.prepend(controls, canvas);
  let draw: Draw | null = null;
  let width = 0;
  const redraw = () => {
    const drawn = draw?.(width);
    if (drawn) {
      canvas.replaceChildren(drawn);
      offerTips(drawn);
    }
    place.hidden = !drawn;
  };
  draw = makeDraw({ controls, redraw });
  width = widthOf(place);
  redraw();
  onPrint((isPaper) => {
    width = isPaper ? PAPER_WIDTH : widthOf(place);
    redraw();
  });
  new ResizeObserver(() => {
    const now = widthOf(place);
    if (now === width || now < 100) return;
    width = now;
    redraw();
  }).observe(place);
}

function widthOf(place: HTMLElement): number {
  return Math.round(Math.min(place.clientWidth || place.parentElement?.clientWidth || 640, 1048));
}
