// What is known where the platform stands, in words and as a table.
import { element } from "../controls";
import { significant } from "../number";
import { type Platform, cableName } from "./platform";
import { type TensionScale, hasTensions, limitWords } from "./tension-style";

const VERDICTS = {
  holds: ["good", "✓", "holds"],
  fails: ["bad", "✗", "fails"],
  between: ["", "≈", "at the boundary: some grid points around hold, others fail"],
} as const;

/** Fills the place and keeps it up to date. */
export function showReadout(place: HTMLElement, platform: Platform, scale: TensionScale): void {
  const verdict = element("div", "", "verdict");
  const head = element("p", "", "heading");
  const line = element("p", "", "line");
  line.setAttribute("role", "status");
  const margin = element("p", "", "margin");
  const reason = element("p", "", "reason");
  verdict.append(head, line, margin, reason);
  const holder = element("div", "", "scroll");
  const caption = element("p", "", "tension-source");
  place.append(verdict);
  if (hasTensions(platform.data)) place.append(holder, caption);
  const { margin_unit, result } = platform.data;
  head.textContent = `Criterion: ${result.criterion}`;
  const show = () => {
    const { reading } = platform;
    const [look, sign, words] = VERDICTS[reading.verdict];
    verdict.className = `verdict ${look}`;
    const text = `${sign} ${words}`;
    if (line.textContent !== text) line.textContent = text;
    const limiting = reading.cable === null ? "" : `, limited by cable ${cableName(platform.data, reading.cable)}`;
    margin.textContent = `Margin ${significant(reading.margin, 3)} ${margin_unit}${limiting}`.replace(/ $/, "");
    reason.textContent = reading.reason ? `Why a grid point ${reading.verdict === "between" ? "beside it " : ""}fails: ${reading.reason}` : "";
    reason.hidden = !reading.reason;
    holder.replaceChildren(table(platform, scale));
    caption.textContent = source(platform);
  };
  platform.onMove(show);
  show();
}

/** Where the numbers are from. */
function source({ reading }: Platform): string {
  if (!reading.tensions) return "No tensions within the limits balance the load here.";
  return reading.from === "interpolated" ? "Tensions: interpolated between the grid points around." : "Tensions: those of the nearest grid point.";
}

function table(platform: Platform, scale: TensionScale): HTMLTableElement {
  const made = element("table", "", "tensions");
  const head = made.createTHead().insertRow();
  for (const [title, className] of [["cable", ""], ["tension, N", "number"], ["least … largest", ""], ["", ""]] as const) {
    const cell = element("th", title, className);
    cell.scope = "col";
    head.append(cell);
  }
  const body = made.createTBody();
  platform.data.robot.cables.forEach((cable, index) => {
    const tension = platform.reading.tensions?.[index] ?? null;
    const row = body.insertRow();
    row.append(element("td", cable.name), element("td", tension === null ? "–" : tension.toFixed(0), "number"));
    const between = element("td", "", "limits");
    between.append(bar(tension, cable.tension_min_N, cable.tension_max_N, scale));
    row.append(between, element("td", tension === null ? "" : limitWords(tension, cable.tension_min_N, cable.tension_max_N), "short"));
  });
  return made;
}

/** A tension between its limits: as long as its share, as thick and as coloured as the cable. */
function bar(tension: number | null, least: number | null, largest: number | null, scale: TensionScale): HTMLElement {
  const made = element("span", "", "limit-bar");
  const [from, to] = [least ?? scale.least, largest ?? scale.largest];
  made.append(element("span", least === null ? "?" : from.toFixed(0), "limit"));
  const track = element("span", "", "track");
  if (tension !== null) {
    const fill = element("span", "", "fill");
    const { colour, width } = scale.look(tension);
    const share = Math.max(0, Math.min(1, (tension - from) / (to - from || 1)));
    fill.style.cssText = `width:${(100 * share).toFixed(1)}%;height:${width + 2}px;background:var(--${colour})`;
    track.append(fill);
  }
  made.append(track, element("span", largest === null ? "?" : to.toFixed(0), "limit"));
  return made;
}
