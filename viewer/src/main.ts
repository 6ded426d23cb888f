// The pages of the command: fills the figures of the frame that it wrote, from the data in the page.
import "./style.css";
import { coverage } from "./charts/coverage";
import { distribution } from "./charts/distribution";
import { map } from "./charts/map";
import { residuals } from "./charts/residuals";
import type { ReportData } from "./data";
import { offerDefinitions } from "./definitions";
import { fill } from "./figure";
import { offerFigureTips } from "./figure-tips";
import { offerFolding } from "./folding";
import { offerPrinting } from "./printing";
import { offerScrolling } from "./scrolling";
import { readData } from "./reading";
import { showRun } from "./run/page";
import { showScene } from "./scene/scene";
import { showStudy } from "./study/page";
import { offerTheme } from "./theme";
import { showWorkspace } from "./workspace/page";

function drawAll(data: ReportData): void {
  if (!data.result.candidates[data.shown]) return;
  fill("residuals", (figure) => residuals(data, figure));
  fill("distribution", (figure) => distribution(data, figure));
  fill("map", (figure) => map(data, figure));
  fill("coverage", () => coverage(data));
  showScene(data);
  offerFigureTips(data);
}

const data = readData();
offerTheme();
offerDefinitions();
offerPrinting();
offerFolding();
if (data?.page === "study") showStudy(data);
else if (data?.page === "run") showRun(data);
else if (data?.page === "workspace") showWorkspace(data);
else if (data) drawAll(data);
offerScrolling();
document.documentElement.dataset.drawn = "true";
