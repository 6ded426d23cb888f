// The page of a study: its errors as a drawing with layers, in a plane, as projections and on slices.
import { button, element } from "../controls";
import { type Draw, type Figure, fill } from "../figure";
import { picture, save, sheet } from "../saving";
import type { StudyData } from "../data";
import { plane } from "./plane";
import { space } from "./space";

/** Fills the figures of the page that the command wrote. */
export function showStudy(data: StudyData): void {
  show(data, "study", data.robot.plane ? plane : space, data.name);
  if (!data.robot.plane) show(data, "slices", plane, `${data.name}-slices`);
}

type MakeDraw = (data: StudyData, figure: Figure, tell: (words: string) => void) => Draw | null;

/** A drawing with what is said about it, and buttons that save it. */
function show(data: StudyData, name: string, make: MakeDraw, file: string): void {
  const words = element("p", "", "drawing-words");
  words.setAttribute("role", "status");
  let told = "";
  const tell = (text: string) => {
    told = text;
    words.textContent = text ? `${text[0]?.toUpperCase()}${text.slice(1)}.` : "";
  };
  fill(name, (figure) => {
    const draw = make(data, figure, tell);
    const place = figure.controls.parentElement as HTMLElement;
    const canvas = place.querySelector<HTMLElement>(".chart");
    if (!draw || !canvas) return null;
    canvas.before(words);
    const buttons = element("div", "", "buttons");
    const legend = () => [...place.querySelectorAll(".layers label:has(input:checked)")].map((label) => ({ picture: label.querySelector("svg") as SVGSVGElement, words: label.textContent ?? "" }));
    const text = () => sheet(canvas, legend(), [`${data.name}${told ? `, ${told}` : ""}`]);
    button(buttons, "Save as SVG", () => save(new Blob([text()], { type: "image/svg+xml" }), `${file}.svg`));
    button(buttons, "Save as PNG", async () => save(await picture(text()), `${file}.png`));
    figure.controls.append(buttons);
    return draw;
  });
}
