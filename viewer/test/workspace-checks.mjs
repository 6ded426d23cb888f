// What must be true of the page of a workspace: the platform follows mouse, finger and keys, and the table follows the platform.
import { readFileSync } from "node:fs";

/** Everything wrong with the page, in words. */
export async function checkWorkspace(page, layout) {
  const data = JSON.parse(await page.locator("#cdpr-data").textContent());
  const found = [];
  const check = async (what, examine) => {
    for (const complaint of await examine(page, data)) found.push(`${what}: ${complaint}`);
  };
  await check("start", nodesShowWhatWasComputed);
  await check("mouse", data.robot.plane ? mouseOnPlane : mouseInSpace);
  await check("keyboard", data.robot.plane ? keysOnPlane : keysInSpace);
  await check("touch", data.robot.plane ? fingerOnPlane : fingerInSpace);
  await check("sliders", sliders);
  await check("failing pose", failingPose);
  await check("legend", legend);
  await check("drawings", drawings);
  if (!data.robot.plane && data.regions.some((region) => region.triangles.length > 0)) {
    await check("clip plane", clipPlane);
    await check("colours of surfaces", colouring);
  }
  if (data.grid.cable.some((cable) => cable >= 0)) await check("colours of the plane", planeColouring);
  await check("downloads", downloads);
  found.push(...(await layout(page)));
  await backToStart(page, data);
  return found;
}

/** Cells in the colours of cables, each patch with its name, and a legend that names every colour; back to the margin. */
async function planeColouring(page, data) {
  const select = page.getByLabel("Colours of the plane").first();
  await select.selectOption({ label: "limiting cable" });
  const cells = await page.locator('[aria-description="limiting cables"] > *').count();
  const names = await page.locator('[aria-description="names of limiting cables"] text').allTextContents();
  const colours = await page.locator('[aria-description="limiting cables"] > *').evaluateAll((all) => new Set(all.map((one) => one.getAttribute("fill"))).size);
  const legend = await page.getByText(/^limited by cable /).count();
  await select.selectOption({ label: "margin" });
  const found = cells > 100 ? [] : [`${cells} cells are drawn`];
  if (names.length === 0 || names.some((name) => !data.robot.cables.some((cable) => cable.name === name))) found.push(`patches bear the names ${names}`);
  if (legend === 0 || legend > colours) found.push(`${legend} cables in the legend, ${colours} colours`);
  if ((await page.locator('[aria-description="limiting cables"]').count()) > 0) found.push("the margin does not come back");
  return found;
}

/** What the table and the sliders show. */
async function shown(page) {
  return page.evaluate(() => ({
    tensions: [...document.querySelectorAll("table.tensions tbody tr")].map((row) => row.cells[1].textContent),
    coordinates: [...document.querySelectorAll(".position input[type=range]")].map((slider) => slider.valueAsNumber),
    verdict: document.querySelector(".side .verdict .line").textContent,
    reason: document.querySelector(".side .reason").textContent,
    source: document.querySelector(".tension-source").textContent,
  }));
}

/** The node of the grid at coordinates that are one. */
function nodeAt(data, coordinates) {
  let stride = 1;
  return data.grid.axes.reduce((node, axis, k) => {
    const index = axis.step_m > 0 ? Math.round((coordinates[k] - axis.start_m) / axis.step_m) : 0;
    const next = node + index * stride;
    stride *= axis.count;
    return next;
  }, 0);
}

async function setCoordinates(page, coordinates) {
  const numbers = page.locator('.position input[type="number"]');
  for (let k = 0; k < coordinates.length; k += 1) {
    await numbers.nth(k).fill(String(coordinates[k]));
    await numbers.nth(k).press("Tab");
  }
}

async function backToStart(page, data) {
  await setCoordinates(page, data.grid.axes.map((axis) => axis.direction.reduce((sum, part, k) => sum + part * data.start.position_m[k], 0)));
  await page.evaluate(() => document.activeElement?.blur());
  await page.waitForTimeout(150);
}

/** Kept to the grid, the table shows the computed tensions of that grid point. */
async function nodesShowWhatWasComputed(page, data) {
  const box = page.locator('.position input[type="checkbox"]');
  await box.check();
  const now = await shown(page);
  const expected = data.grid.tensions_N[nodeAt(data, now.coordinates)];
  await box.uncheck();
  const texts = expected ? expected.map((tension) => tension.toFixed(0)) : data.robot.cables.map(() => "–");
  return String(texts) === String(now.tensions) ? [] : [`the table shows ${now.tensions} where ${texts} was computed`];
}

/** True complaint unless coordinates and tensions both changed. */
function moved(before, after) {
  const found = [];
  if (String(before.coordinates) === String(after.coordinates)) found.push("the platform did not move");
  if (String(before.tensions) === String(after.tensions)) found.push(`the tensions stayed ${after.tensions}`);
  return found;
}

/** The middle of the platform's handle in pixels of the window. */
async function handle(page) {
  const grip = page.locator(".workspace .handle .grip");
  await grip.scrollIntoViewIfNeeded();
  const box = await grip.boundingBox();
  return [box.x + 0.5 * box.width, box.y + 0.5 * box.height];
}

async function mouseOnPlane(page) {
  const before = await shown(page);
  const [x, y] = await handle(page);
  await dragMouse(page, [x, y], [x + 70, y - 40]);
  const after = await shown(page);
  const [left, top] = await handle(page);
  const found = moved(before, after);
  if (Math.hypot(left - x - 70, top - y + 40) > 2) found.push(`the platform is ${left - x}, ${top - y} pixels away, not 70, −40`);
  return found;
}

async function dragMouse(page, [x, y], [right, down]) {
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(0.5 * (x + right), 0.5 * (y + down), { steps: 4 });
  await page.mouse.move(right, down, { steps: 4 });
  await page.mouse.up();
  await page.waitForTimeout(150);
}

/** Where in the scene the pointer can take hold of the platform: it says so by its cursor. */
async function gripInSpace(page) {
  const canvas = page.locator(".workspace .stage canvas");
  await canvas.scrollIntoViewIfNeeded();
  const box = await canvas.boundingBox();
  for (let ring = 0; ring < 20; ring += 1) {
    for (let turn = 0; turn < 6 * ring + 1; turn += 1) {
      const angle = (2 * Math.PI * turn) / (6 * ring + 1);
      const at = [box.x + 0.5 * box.width + 14 * ring * Math.cos(angle), box.y + 0.5 * box.height + 14 * ring * Math.sin(angle)];
      await page.mouse.move(...at);
      if ((await canvas.evaluate((element) => element.style.cursor)) === "grab") return at;
    }
  }
  return null;
}

async function mouseInSpace(page) {
  const grip = await gripInSpace(page);
  if (!grip) return ["the pointer finds no platform in the scene"];
  const before = await shown(page);
  await dragMouse(page, grip, [grip[0] + 40, grip[1] - 25]);
  return moved(before, await shown(page));
}

/** An arrow key moves by a tenth of the grid's step. */
async function keysOnPlane(page, data) {
  const before = await shown(page);
  await page.locator(".workspace .handle").focus();
  await page.keyboard.press("ArrowLeft");
  const after = await shown(page);
  const step = (before.coordinates[0] - after.coordinates[0]) / data.grid.axes[0].step_m;
  await page.keyboard.press("Shift+ArrowDown");
  return [...moved(before, await shown(page)), ...(Math.abs(step - 0.1) < 1e-6 ? [] : [`ArrowLeft moved by ${step} steps of the grid`])];
}

async function keysInSpace(page) {
  const before = await shown(page);
  await page.locator(".workspace .stage canvas").focus();
  await page.keyboard.press("Shift+ArrowLeft");
  const across = await shown(page);
  await page.keyboard.press("PageUp");
  const up = await shown(page);
  const found = moved(before, up);
  if (!(across.coordinates[0] < before.coordinates[0])) found.push("Shift and ArrowLeft do not lower x");
  if (!(up.coordinates[2] > across.coordinates[2])) found.push("Page Up does not raise z");
  return found;
}

async function dragFinger(page, [x, y], [right, down]) {
  const session = await page.context().newCDPSession(page);
  const send = (type, points) => session.send("Input.dispatchTouchEvent", { type, touchPoints: points });
  await send("touchStart", [{ x, y }]);
  for (let step = 1; step <= 5; step += 1) await send("touchMove", [{ x: x + (step * (right - x)) / 5, y: y + (step * (down - y)) / 5 }]);
  await send("touchEnd", []);
  await session.detach();
  await page.waitForTimeout(150);
}

async function fingerOnPlane(page) {
  const before = await shown(page);
  const [x, y] = await handle(page);
  await dragFinger(page, [x, y], [x - 50, y + 30]);
  return moved(before, await shown(page));
}

async function fingerInSpace(page) {
  const grip = await gripInSpace(page);
  if (!grip) return ["the pointer finds no platform in the scene"];
  const before = await shown(page);
  await dragFinger(page, grip, [grip[0] - 35, grip[1] + 20]);
  return moved(before, await shown(page));
}

async function sliders(page, data) {
  const slider = page.locator('.position input[type="range"]').last();
  const before = await shown(page);
  await slider.focus();
  for (let k = 0; k < 5; k += 1) await page.keyboard.press("ArrowRight");
  const after = await shown(page);
  const axis = data.grid.axes.at(-1);
  const step = (after.coordinates.at(-1) - before.coordinates.at(-1)) / axis.step_m;
  return [...moved(before, after), ...(Math.abs(step - 0.5) < 1e-6 ? [] : [`five keys moved by ${step} steps of the grid, not by half of one`])];
}

/** At a grid point that fails the page says so and repeats the reason, number by number. */
async function failingPose(page, data) {
  const node = data.grid.reason.findIndex((reason, k) => reason >= 0 && data.grid.tensions_N[k] === null);
  if (node < 0) return ["the grid of this page has no failing point: take a larger box"];
  let rest = node;
  const coordinates = data.grid.axes.map((axis) => {
    const index = rest % axis.count;
    rest = Math.floor(rest / axis.count);
    return axis.start_m + index * axis.step_m;
  });
  await setCoordinates(page, coordinates);
  const now = await shown(page);
  const numbers = data.grid.numbers[node].split(" ");
  const reason = data.grid.sentences[data.grid.reason[node]].replace(/§/g, () => numbers.shift());
  const found = [];
  if (!now.verdict.includes("fails")) found.push(`the verdict is "${now.verdict}"`);
  if (!now.reason.endsWith(reason)) found.push(`the reason is "${now.reason}", not "${reason}"`);
  if (now.tensions.some((text) => text !== "–")) found.push(`tensions are shown where there are none: ${now.tensions}`);
  await backToStart(page, data);
  return found;
}

/** Ranges of tension stand in figures, and lines differ in width or dashes as well as in colour. */
async function legend(page) {
  const entries = await page.locator('.legend[aria-label="Cables by tension"] li').evaluateAll((items) =>
    items.map((item) => ({ words: item.textContent, width: item.querySelector("line").getAttribute("stroke-width"), dashes: item.querySelector("line").getAttribute("stroke-dasharray") })));
  const looks = new Set(entries.map(({ width, dashes }) => `${width} ${dashes}`));
  const found = looks.size === entries.length ? [] : ["two entries differ in colour alone"];
  if (entries.filter(({ words }) => /\d.*–.*\d.* N/.test(words)).length < 5) found.push(`ranges are missing: ${entries.map(({ words }) => words)}`);
  return found;
}

async function drawings(page, data) {
  const broken = await page.locator(".canvas svg").evaluateAll((all) => all.filter((svg) => /NaN|undefined|Infinity/.test(svg.outerHTML)).length);
  const found = broken > 0 ? [`${broken} drawings contain NaN, undefined or Infinity`] : [];
  const contours = await page.locator('.canvas svg [aria-label="contour"] path').count();
  if (contours < 3) found.push(`only ${contours} contours`);
  const outlines = data.regions.reduce((sum, region) => sum + region.outlines_m.length, 0);
  if ((await page.locator('.canvas svg [aria-label="line"] path').count()) < outlines) found.push(`fewer than ${outlines} outlines of areas`);
  return found;
}

/** A number that changes with the picture. */
async function picture(page) {
  await page.waitForTimeout(200);
  return page.locator(".workspace .stage canvas").evaluate((shown) => shown.toDataURL());
}

async function clipPlane(page) {
  const select = page.locator("label", { hasText: "Clip plane" }).locator("select");
  const whole = await picture(page);
  await select.selectOption({ index: 1 });
  const cut = await picture(page);
  await page.getByLabel("show the other side").check();
  const other = await picture(page);
  await page.getByLabel("show the other side").uncheck();
  await select.selectOption({ index: 0 });
  const found = cut === whole ? ["it cuts nothing"] : [];
  if (other === cut) found.push("both sides look alike");
  if ((await picture(page)) !== whole) found.push("the whole does not come back");
  return found;
}

/** Coloured by limiting cable, the surface bears the names of cables, the legend lists them all, and both go with the colours. */
async function colouring(page, data) {
  const select = page.getByLabel("Colour of surfaces");
  const opacity = page.getByLabel("Opacity of surfaces");
  const [plain, before] = [await picture(page), await opacity.inputValue()];
  const known = data.regions.filter((region) => region.triangles.length > 0);
  const numbers = [...new Set(known.flatMap((region) => region.limiting_cable))].sort((a, b) => a - b);
  const names = numbers.map((number) => (number === 0 ? "none" : data.robot.cables[number - 1].name));
  await select.selectOption({ label: "by limiting cable" });
  const found = (await picture(page)) === plain ? ["by limiting cable it looks as before"] : [];
  const listed = await page.locator(".legend.colours li span").allTextContents();
  if (String(listed.map((text) => text.split(": ")[0])) !== String(names)) found.push(`the legend lists ${listed} for the cables ${names}`);
  const shares = listed.reduce((sum, text) => sum + Number(/([\d.]+) %$/.exec(text)?.[1]), 0);
  if (!(Math.abs(shares - 100) < 2)) found.push(`the shares of the legend make ${shares} %`);
  const labels = await page.locator(".labels .patch:not([hidden])").allTextContents();
  if (labels.length < 2) found.push(`the surface bears only the names ${labels}`);
  const letters = known.length > 1 ? /^[A-Z] / : /^/;
  if (labels.some((text) => !letters.test(text) || !names.includes(text.replace(letters, "")))) found.push(`the surface bears ${labels}`);
  const png = await downloaded(page, "Save as PNG");
  if (png.length < 5000) found.push(`the PNG has ${png.length} bytes`);
  await select.selectOption({ label: "by margin" });
  if (!(await page.locator(".legend.colours").textContent()).startsWith("Margin")) found.push("the margin has no legend");
  await select.selectOption({ label: "by result" });
  if ((await page.locator(".legend.colours, .labels .patch").count()) > 0) found.push("names and legend stay when the colours go");
  if ((await opacity.inputValue()) !== before || (await picture(page)) !== plain) found.push("the colours of the results do not come back");
  return found;
}

async function downloaded(page, name) {
  const waiting = page.waitForEvent("download", { timeout: 10_000 });
  await page.getByRole("button", { name }).first().click();
  return readFileSync(await (await waiting).path());
}

async function downloads(page, data) {
  const found = [];
  const svg = (await downloaded(page, "Save as SVG")).toString();
  if (!svg.startsWith("<svg") || svg.includes("var(") || !svg.includes("xmlns=")) found.push("the SVG is no drawing of its own");
  if (data.robot.plane) return found;
  const png = await downloaded(page, "Save as PNG");
  if (png.subarray(1, 4).toString() !== "PNG" || png.length < 5000) found.push(`the PNG has ${png.length} bytes`);
  const hull = data.regions.find((region) => region.triangles.length > 0);
  if (!hull) return found;
  const stl = await downloaded(page, /as STL/);
  const triangles = hull.triangles.length / 3;
  if (stl.length !== 84 + 50 * triangles || stl.readUInt32LE(80) !== triangles) found.push(`the STL has ${stl.length} bytes for ${triangles} triangles`);
  return found;
}
