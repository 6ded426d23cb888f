// The page of a study: its errors as a drawing with layers, in a plane or as projections.
import { button, element } from "../controls";
import { fill } from "../figure";
import { picture, save, sheet } from "../saving";
import type { StudyData } from "./data";
import { plane } from "./plane";
import { space } from "./space";

/** Fills the figure of the page that the command wrote. */
export function showStudy(data: StudyData): void {
  const words = element("p", "", "drawing-words");
  words.setAttribute("role", "status");
  let told = "";
  const tell = (text: string) => {
    told = text;
    words.textContent = text ? `${text[0]?.toUpperCase()}${text.slice(1)}.` : "";
  };
  fill("study", (figure) => {
    const draw = plane(data, figure, tell) ?? space(data, figure, tell);
    const place = figure.controls.parentElement as HTMLElement;
    const canvas = place.querySelector<HTMLElement>(".chart");
    if (!draw || !canvas) return null;
    canvas.before(words);
    const buttons = element("div", "", "buttons");
    const legend = () => [...place.querySelectorAll(".layers label:has(input:checked)")].map((label) => ({ picture: label.querySelector("svg") as SVGSVGElement, words: label.textContent ?? "" }));
    const text = () => sheet(canvas, legend(), [`${data.name}${told ? `, ${told}` : ""}`]);
    button(buttons, "Save as SVG", () => save(new Blob([text()], { type: "image/svg+xml" }), `${data.name}.svg`));
    button(buttons, "Save as PNG", async () => save(await picture(text()), `${data.name}.png`));
    figure.controls.append(buttons);
    return draw;
  });
}
