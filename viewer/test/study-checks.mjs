// What must be true of the page of a study: layers can be switched off and on, and the pointer reads the computed values.
import { readFileSync } from "node:fs";

/** Everything wrong with the page, in words. */
export async function checkStudy(page, layout) {
  const data = JSON.parse(await page.locator("#cdpr-data").textContent());
  const found = [];
  const check = async (what, examine) => {
    for (const complaint of await examine(page, data)) found.push(`${what}: ${complaint}`);
  };
  await check("drawing", drawings);
  if (data.robot.plane) await check("layers", planeLayers);
  else await check("layers", spaceLayers);
  if (!data.robot.plane && data.regions.length > 0) await check("slices", slices);
  await check("pointer", pointer);
  await check("keyboard", keyboard);
  await check("magnification", magnification);
  await check("downloads", downloads);
  found.push(...(await layout(page)));
  return found;
}

const CHART = 'figure[data-chart="study"] .chart';

/** The figure that every robot has. */
const study = (page) => page.locator('figure[data-chart="study"]');

async function drawings(page, data) {
  const broken = await page.locator(`${CHART} svg`).evaluateAll((all) => all.filter((svg) => /NaN|undefined|Infinity/.test(svg.outerHTML)).length);
  const found = broken > 0 ? [`${broken} drawings contain NaN, undefined or Infinity`] : [];
  const poses = await page.locator(`${CHART} [aria-description="commanded poses"] > *`).count();
  const expected = data.samples.number.length * (data.robot.plane ? 1 : 3);
  if (poses !== expected) found.push(`${poses} commanded poses are drawn, not ${expected}`);
  return found;
}

/** Ticks a box off and on again; what it stands for goes and comes back. */
async function switched(page, label, description) {
  const box = study(page).getByLabel(label, { exact: true });
  const marks = page.locator(`${CHART} [aria-description="${description}"]`);
  await box.check();
  const before = await marks.count();
  await box.uncheck();
  const without = await marks.count();
  await box.check();
  const found = before > 0 ? [] : [`"${label}" shows nothing`];
  if (without !== 0) found.push(`"${label}" is drawn although it is switched off`);
  if ((await marks.count()) !== before) found.push(`"${label}" does not come back`);
  return found;
}

async function planeLayers(page, data) {
  const layers = [
    ["exact error", "contours of the exact error"],
    ["error by one linear step", "contours of the linear error"],
    ["difference of both", "contours of the difference"],
    ["exact vectors", "exact error vectors"],
    ["vectors by one linear step", "error vectors of the linear step"],
    ["commanded poses", "commanded poses"],
    ["emerging poses", "emerging poses"],
  ];
  if (data.samples.tensions_N.some(Boolean)) layers.push(["largest tension, N", "contours of the largest tension"], ["smallest tension, N", "contours of the smallest tension"]);
  if (data.samples.tension_error_N.some((error) => error !== null)) layers.push(["largest tension error, N", "contours of the largest tension error"]);
  if (data.samples.residual_N.some((force) => force !== null)) layers.push(["residual force, N", "contours of the residual force"]);
  if (data.regions[0].linear) layers.push(["reachable by one linear step", "reachable by one linear step"]);
  if (data.regions[0].physical) layers.push(["physical workspace", "physical workspace"]);
  if (data.regions[0].reachable) layers.push(["reachable workspace", "reachable workspace"]);
  const found = [];
  for (const [label, description] of layers) found.push(...(await switched(page, label, description)));
  const values = await study(page).locator("text.contour-value").allTextContents();
  if (!values.some((text) => / mm$/.test(text)) || values.some((text) => !/^−?[\d.]+ ?(mm|°|N)$/.test(text))) found.push(`contours bear the values ${values}`);
  found.push(...(await looks(page)));
  for (const [label] of layers.filter(([label]) => /linear|difference|tension|residual/.test(label))) await study(page).getByLabel(label, { exact: true }).uncheck();
  return found;
}

/** Every slice has contours of its own, the poses that lie on it, and a pointer that reads the computed values. */
async function slices(page, data) {
  const figure = page.locator('figure[data-chart="slices"]');
  const found = [];
  const drawn = new Set();
  for (const [index, region] of data.regions.entries()) {
    await figure.getByLabel("Slice").selectOption({ index });
    const contours = figure.locator('[aria-description="contours of the exact error"]');
    drawn.add(await contours.evaluate((one) => one.innerHTML));
    const axis = [0, 1, 2].find((one) => !region.plane.includes(one));
    const expected = data.samples.commanded.filter((pose) => Math.abs(pose[axis] - region.level_m) < 1e-3).length;
    const poses = await figure.locator('[aria-description="commanded poses"] > *').count();
    if (poses !== expected) found.push(`${region.name}: ${poses} poses are drawn, not ${expected}`);
    const drawing = figure.locator(".chart svg").last();
    await drawing.evaluate((element) => element.scrollIntoView({ block: "center" }));
    const box = await drawing.boundingBox();
    await page.mouse.move(box.x + 0.53 * box.width, box.y + 0.47 * box.height);
    await page.waitForTimeout(100);
    const text = (await figure.locator('[aria-label="tip"]').textContent()).replaceAll("\u200b", "");
    await page.mouse.move(2, 2);
    if (!text.includes(`${data.robot.axes[axis]} ${region.level_m.toFixed(4).replace("-", "−")}`) || !/position error [\d.]+ mm/.test(text)) found.push(`${region.name}: the tip reads "${text}"`);
  }
  if (drawn.size !== data.regions.length) found.push("slices look the same");
  await figure.getByLabel("Slice").selectOption({ index: 0 });
  return found;
}

/** Entries of the legend differ in more than their colour. */
async function looks(page) {
  const pictures = await study(page).locator(".layers label svg").evaluateAll((all) => all.map((svg) => svg.innerHTML.replace(/(stroke|fill)="[^"]*"/g, "")));
  return new Set(pictures).size === pictures.length ? [] : ["two entries of the legend differ in colour alone"];
}

async function spaceLayers(page) {
  const found = [];
  for (const [label, description] of [["commanded poses", "commanded poses"], ["emerging poses", "emerging poses"], ["exact vectors", "exact error vectors"], ["vectors by one linear step", "error vectors of the linear step"]]) {
    found.push(...(await switched(page, label, description)));
  }
  for (const label of ["emerging poses", "vectors by one linear step"]) await study(page).getByLabel(label, { exact: true }).uncheck();
  return found;
}

/** The tip's text must be that of the pose. */
function tipComplaints(text, data, at) {
  const { samples } = data;
  const error = samples.error_m[at];
  const found = [];
  if (!text.includes(`pose ${samples.number[at]}commanded`)) found.push(`pose ${samples.number[at]} is not named: "${text}"`);
  if (!error) return found;
  const size = (1e3 * Math.hypot(...error)).toPrecision(4);
  const shown = /position error ([\d.]+) mm/.exec(text)?.[1];
  if (!shown || Math.abs(Number(shown) - Number(size)) > 1e-3 * Number(size)) found.push(`the position error reads ${shown} mm, ${size} mm was computed`);
  const tension = samples.tensions_N[at]?.[0];
  if (tension !== undefined && !text.includes(`${data.robot.cables[0].name}: ${tension.toFixed(0)} N`)) found.push(`the first tension, ${tension} N, is missing: "${text}"`);
  return found;
}

async function tip(page) {
  await page.waitForTimeout(100);
  const texts = await page.locator(`${CHART} [aria-label="tip"]`).allTextContents();
  // Plot begins lines with spaces of no width
  return (texts.find((text) => text !== "") ?? "").replaceAll("\u200b", "");
}

/** The pointer over the first pose with an answer reads its values. */
async function pointer(page, data) {
  const at = data.samples.error_m.findIndex(Boolean);
  const mark = page.locator(`${CHART} svg:has([aria-label="tip"])`).first().locator('[aria-label="dot"]').last().locator("> *").nth(at);
  await mark.evaluate((element) => element.scrollIntoView({ block: "center" }));
  const box = await mark.evaluate((element) => {
    const { x, y, width, height } = element.getBoundingClientRect();
    return [x + 0.5 * width, y + 0.5 * height];
  });
  await page.mouse.move(...box);
  const text = await tip(page);
  await page.mouse.move(2, 2);
  // poses behind each other, or turned at one place, share a mark
  const read = data.samples.number.indexOf(Number(/^pose (\d+)commanded/.exec(text)?.[1]));
  return read < 0 ? [`the tip reads "${text}"`] : tipComplaints(text, data, read);
}

async function keyboard(page, data) {
  const drawing = page.locator(`${CHART} svg[tabindex]`).first();
  await drawing.focus();
  await page.keyboard.press("Home");
  const text = await tip(page);
  await drawing.evaluate((element) => element.blur());
  return /^pose \d+commanded/.test(text) ? [] : [`the first pose is not told: "${text}"`];
}

/** What the drawing says is what was chosen, and arrows grow with it. */
async function magnification(page) {
  const select = study(page).getByLabel("Vectors magnified");
  const length = () => page.locator(`${CHART} [aria-description="exact error vectors"] path`).first().evaluate((path) => path.getBBox().width + path.getBBox().height);
  await select.selectOption({ label: "5 ×" });
  const five = await length();
  const words = await study(page).locator(".drawing-words").textContent();
  await select.selectOption({ label: "20 ×" });
  const twenty = await length();
  await select.selectOption({ index: 0 });
  const found = words.includes("magnified 5 ×") ? [] : [`it says "${words}" at 5 ×`];
  if (!(twenty > 2 * five)) found.push(`an arrow has ${five} pixels at 5 × and ${twenty} at 20 ×`);
  return found;
}

async function downloaded(page, name) {
  const waiting = page.waitForEvent("download", { timeout: 10_000 });
  await study(page).getByRole("button", { name }).first().click();
  return readFileSync(await (await waiting).path());
}

async function downloads(page) {
  const found = [];
  const svg = (await downloaded(page, "Save as SVG")).toString();
  const problem = await page.evaluate((text) => new DOMParser().parseFromString(text, "image/svg+xml").querySelector("parsererror")?.textContent ?? "", svg);
  if (problem) found.push(`the SVG is not well-formed: ${problem}`);
  if (!svg.startsWith("<svg") || svg.includes("var(") || !/error vectors (to scale|magnified)/.test(svg)) found.push("the SVG is no drawing of its own that states its magnification");
  const png = await downloaded(page, "Save as PNG");
  if (png.subarray(1, 4).toString() !== "PNG" || png.length < 5000) found.push(`the PNG has ${png.length} bytes`);
  return found;
}
