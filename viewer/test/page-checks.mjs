// What must be true of a report page, asked of the page as a browser shows it.

const CHARTS_OF_EVERY_PAGE = ["residuals", "distribution", "map", "coverage"];

/** Everything wrong with the page, in words. */
export async function checkPage(page, result) {
  const data = JSON.parse(await page.locator("#cdpr-data").textContent());
  const found = [];
  if (result) found.push(...sameNumbers(data.result, result));
  found.push(...(await verdict(page, data)));
  found.push(...(await firstScreen(page, data)));
  found.push(...(await folds(page)));
  found.push(...(await tables(page, data)));
  found.push(...(await charts(page, data)));
  found.push(...(await scene(page, data)));
  found.push(...(await choices(page, data)));
  found.push(...(await tips(page)));
  found.push(...(await definitions(page)));
  found.push(...(await layout(page)));
  found.push(...(await phone(page)));
  found.push(...(await paper(page)));
  return found;
}

/** Green without doubts only, amber with any, red where nobody should trust the model; every warning of the answer is in the list. */
async function verdict(page, data) {
  const found = [];
  const shown = page.locator(".verdict");
  const classes = (await shown.getAttribute("class")).split(" ");
  const { warnings, trusted, recommended, status } = data.result;
  const told = await page.locator("#warnings li").allTextContents();
  const plain = warnings.map((warning) => warning.replaceAll("`", ""));
  if (JSON.stringify(told) !== JSON.stringify(plain)) found.push(`the page warns of ${JSON.stringify(told)}, the answer of ${JSON.stringify(plain)}`);
  if (warnings.length > 0 && !(await page.locator("#warnings li").first().isVisible())) found.push("the first warning is folded");
  const isRefused = !recommended || !trusted || status.startsWith("not-") || (await page.locator(".verdict .broken").count()) > 0;
  const expected = isRefused ? "bad" : status.endsWith("-with-caution") ? "warned" : "good";
  if (!classes.includes(expected)) found.push(`the verdict is ${classes.join(" ")}, not ${expected}`);
  const tint = await shown.evaluate((box) => getComputedStyle(box).backgroundColor.match(/[\d.]+/g).map(Number));
  const isGreen = tint[1] > tint[0];
  if (isGreen !== (expected === "good")) found.push(`a verdict that is ${expected} has the colour ${tint}`);
  return found;
}

/** Verdict, first warning, ladder and map stand on the first screen of 1440 × 900, and the ladder is logarithmic with a shade of what is as good as the best. */
async function firstScreen(page, data) {
  const found = [];
  await page.setViewportSize({ width: 1440, height: 900 });
  await page.waitForTimeout(250);
  const bottom = async (selector) => {
    const box = await page.locator(selector).boundingBox();
    return box ? box.y + box.height : null;
  };
  const parts = [".verdict", 'figure[data-chart="map"] .chart'];
  const isLadder = data.result.candidates.length > 1;
  if (isLadder) parts.push('figure[data-figure="ladder"] .beside');
  for (const part of parts) {
    const end = await bottom(part);
    if (end === null || end > 900) found.push(`${part} ends at ${end}, below the first screen of 900`);
  }
  if (isLadder) {
    const [ladder, map] = [await page.locator('figure[data-figure="ladder"]').boundingBox(), await page.locator('figure[data-chart="map"]').boundingBox()];
    if (ladder.x + ladder.width > map.x) found.push("the map does not stand beside the ladder");
    const drawing = page.locator('figure[data-figure="ladder"] .beside svg');
    // the best's line through every row; a shade beside it where a candidate is compared
    const rows = data.result.candidates.length;
    const compared = data.result.candidates.filter((candidate) => candidate.compared).length;
    if ((await drawing.locator(".limit").count()) !== rows) found.push("the best's line does not go through every row of the ladder");
    if ((await drawing.locator(".as-good").count()) < compared) found.push("a candidate of the ladder has no shade of what is as good as the best");
    if (!(await drawing.textContent()).includes("logarithmic")) found.push("the ladder is not logarithmic");
  }
  return found;
}

/** Every part but the robot is folded and says what it comes to; all open at once, and their figures have the width of the page. */
async function folds(page) {
  const found = [];
  const closed = await page.locator("details.part:not([open])").count();
  if (closed < 5) found.push(`only ${closed} parts are folded`);
  const bare = await page.locator("details.part:not(:has(> summary .gist)) h2").allTextContents();
  if (bare.some((title) => title !== "What the figures mean")) found.push(`${bare} do not say what they come to`);
  await page.locator("button[data-fold-button]").click();
  await page.waitForTimeout(500);
  if ((await page.locator("details.part:not([open])").count()) > 0) found.push("a part stays folded when all are opened");
  const narrow = await page.locator('details.part figure[data-chart]:not([hidden])').evaluateAll((all) =>
    all.filter((figure) => (figure.querySelector("svg, canvas")?.getBoundingClientRect().width ?? 0) < 200).map((figure) => figure.dataset.chart));
  if (narrow.length > 0) found.push(`the charts ${narrow} are not drawn when they are unfolded`);
  await page.locator(".warnings details").evaluateAll((all) => all.forEach((one) => { one.open = true; }));
  await page.setViewportSize({ width: 1280, height: 900 });
  return found;
}

/** On a phone nothing sticks out, wide tables say that they scroll, and no mark is cut off at the edge of its drawing. */
export async function phone(page) {
  const found = [];
  await page.setViewportSize({ width: 390, height: 844 });
  await page.waitForTimeout(300);
  const over = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  if (over > 0) found.push(`the page is ${over} pixels wider than a phone`);
  const silent = await page.locator(".scroll").evaluateAll((all) => all.filter((box) => box.checkVisibility() && box.scrollWidth > box.clientWidth + 4 && !box.hasAttribute("data-scrolls")).length);
  if (silent > 0) found.push(`${silent} tables scroll without showing it`);
  if (await page.locator('figure[data-figure="ladder"] .beside').isVisible()) found.push("a phone shows the wide ladder");
  await page.setViewportSize({ width: 1280, height: 900 });
  return found;
}

/** Paper has no controls, everything unfolded, nothing wider than the page, and no labels of the scene upon each other. */
export async function paper(page) {
  const found = [];
  await page.setViewportSize({ width: 688, height: 900 });
  await page.emulateMedia({ media: "print" });
  await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
  await page.waitForTimeout(400);
  const controls = await page.locator("button, select, input, .controls").evaluateAll((all) => all.filter((one) => one.checkVisibility()).length);
  if (controls > 0) found.push(`${controls} controls are printed`);
  const folded = await page.locator("details:not([open], .notices)").count();
  if (folded > 0) found.push(`${folded} parts are printed folded`);
  const wide = await page.locator("svg, canvas, table").evaluateAll((all) => all.filter((one) => one.checkVisibility() && one.getBoundingClientRect().right > innerWidth + 1).length);
  if (wide > 0) found.push(`${wide} tables or figures are cut at the edge of the paper`);
  found.push(...(await labels(page)));
  await page.evaluate(() => dispatchEvent(new Event("afterprint")));
  await page.emulateMedia({ media: "screen" });
  await page.setViewportSize({ width: 1280, height: 900 });
  return found;
}

/** Labels of the scene that overlap each other or reach out of the picture. */
async function labels(page) {
  return page.locator(".stage").evaluateAll((stages) =>
    stages.flatMap((stage) => {
      const outer = stage.getBoundingClientRect();
      const boxes = [...stage.querySelectorAll(".labels span")].filter((one) => one.checkVisibility()).map((one) => ({ words: one.textContent, box: one.getBoundingClientRect() }));
      const overlap = (a, b) => Math.min(a.right, b.right) - Math.max(a.left, b.left) > 3 && Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 3;
      const upon = boxes.flatMap((a, k) => boxes.slice(k + 1).filter((b) => overlap(a.box, b.box)).map((b) => `the labels ${a.words} and ${b.words} lie upon each other`));
      const out = boxes.filter(({ box }) => box.left < outer.left - 1 || box.right > outer.right + 1 || box.top < outer.top - 1).map(({ words }) => `the label ${words} is cut off`);
      return [...(boxes.length === 0 ? ["the scene has no labels"] : []), ...upon, ...out];
    }));
}

/** Arrow keys open the tips of a focused chart. */
async function tips(page) {
  const chart = page.locator('figure[data-chart="map"] svg[tabindex="0"]').first();
  if ((await chart.count()) === 0) return ["the map of errors cannot be focused"];
  await chart.focus();
  let text = "";
  // a busy machine draws late
  for (let tries = 0; tries < 40 && !text.trim(); tries += 1) {
    await page.keyboard.press(tries % 2 === 0 ? "ArrowRight" : "ArrowLeft");
    await page.waitForTimeout(100);
    text = await chart.locator('[aria-label="tip"]').textContent();
  }
  await page.evaluate(() => document.activeElement?.blur());
  const found = text.trim() ? [] : ["an arrow key opens no tip in the map of errors"];
  for (const figure of await page.locator("svg.figure").all()) {
    if (!(await figure.isVisible())) continue;
    await figure.focus();
    await page.keyboard.press("ArrowRight");
    if (!(await page.locator(".tip").innerText()).trim()) found.push(`an arrow key opens no tip in "${await figure.getAttribute("aria-label")}"`);
    await page.evaluate(() => document.activeElement?.blur());
    if (await page.locator(".tip").isVisible()) found.push("a tip stays when its figure is left");
  }
  return found;
}

/** The block of the page is result.json but for wall times and the marks of a JSON answer, which the page says in words. */
function sameNumbers(inPage, inFile) {
  const without = ({ timing, out, program, layout_version, ...rest }) => JSON.stringify(sorted(rest));
  return without(inPage) === without(inFile) ? [] : ["the numbers in the page are not those of result.json"];
}

function sorted(value) {
  if (Array.isArray(value)) return value.map(sorted);
  if (value === null || typeof value !== "object") return value;
  return Object.fromEntries(Object.keys(value).sort().map((key) => [key, sorted(value[key])]));
}

/** Cells as rows of texts, by the heading above the table. */
async function cells(page, heading) {
  return page.locator(`section[aria-labelledby="${heading}"] table`).first().locator("tbody tr").evaluateAll((rows) =>
    rows.map((row) => [...row.cells].map((cell) => cell.textContent.trim())));
}

/** The number that a cell shows; NaN for a dash. */
function numberOf(text) {
  const [mantissa, exponent] = text.replace("−", "-").split(" × 10");
  const power = exponent ? Number([...exponent].map((c) => (c === "⁻" ? "-" : "⁰¹²³⁴⁵⁶⁷⁸⁹".indexOf(c))).join("")) : 0;
  return text === "∞" ? Infinity : Number(mantissa) * 10 ** power;
}

/** True when the cell shows this value to the digits that it has. */
function shows(text, value) {
  if (text === undefined) return false;
  if (value === null || value === undefined) return text === "–" || text === "∞";
  const shown = numberOf(text);
  const decimals = (text.split(" ")[0].split(".")[1] ?? "").length;
  const mantissaUnit = text.includes("×") ? 10 ** (Math.floor(Math.log10(Math.abs(value))) - decimals) : 10 ** -decimals;
  return Math.abs(shown - value) <= 0.51 * mantissaUnit + 1e-9 * Math.abs(value);
}

async function tables(page, data) {
  const found = [];
  const { factor } = data.criterion;
  const ladder = await cells(page, "candidates");
  if (ladder.length !== data.result.candidates.length) found.push(`${ladder.length} candidates in the table, ${data.result.candidates.length} in result.json`);
  data.result.candidates.forEach((candidate, index) => {
    const row = ladder[index] ?? [];
    if (row[1] !== candidate.name) found.push(`candidate ${index + 1} is called ${row[1]}, not ${candidate.name}`);
    if (candidate.failure) return;
    const expected = [[2, candidate.parameter_count], [4, scaled(candidate.criterion, factor)], [5, scaled(candidate.standard_error, factor)]];
    for (const [column, value] of expected) if (!shows(row[column], value)) found.push(`candidate ${index + 1}: the table shows ${row[column]} for ${value}`);
  });
  const shown = data.result.candidates[data.shown];
  const parameters = shown.parameter_count > 0 ? await cells(page, "parameters") : [];
  if (parameters.length !== shown.parameter_count) found.push(`${parameters.length} parameters in the table, ${shown.parameter_count} in result.json`);
  shown.parameters.forEach((estimate, index) => {
    const row = parameters[index] ?? [];
    const by = { m: 1e3, "1/N": 1e9 }[estimate.unit] ?? 1;
    const columns = { nominal: 2, start: 3, value: 4, sigma: 5, change: 7 };
    if (row[0] !== estimate.name) found.push(`parameter ${index + 1} is called ${row[0]}, not ${estimate.name}`);
    for (const [key, column] of Object.entries(columns)) {
      const value = estimate[key];
      const text = row[column]?.replace("+", "");
      if (!shows(text, value === null ? null : by * value)) found.push(`${estimate.name}: the table shows ${row[column]} for the ${key} ${by * value}`);
    }
  });
  const errors = await cells(page, "errors");
  for (const value of [shown.train.position_error_m.mean, shown.validation.position_error_m.max]) {
    if (!errors.some((row) => row.some((text) => shows(text, 1e3 * value)))) found.push(`no row before and after shows ${1e3 * value} mm`);
  }
  return found;
}

function scaled(value, factor) {
  return value === null ? null : factor * value;
}

/** Marks of a chart: circles, bars, and the dots that a path of specks stands for. */
async function marks(page, name) {
  return page.locator(`figure[data-chart="${name}"]`).evaluateAll((figures) =>
    figures.reduce((sum, figure) => {
      if (figure.hidden) return sum;
      const single = figure.querySelectorAll("svg g[aria-label] > :is(circle, rect, path, line)").length;
      const specks = [...figure.querySelectorAll("path.specks")].reduce((count, path) => count + Number(path.dataset.points), 0);
      return sum + single + specks;
    }, 0));
}

/** Marks of a figure that comes drawn in the page, of its first drawing: circles, and cells that stand side by side in one rectangle. */
async function drawnMarks(page, name) {
  return page.locator(`figure[data-figure="${name}"] .chart:first-child svg`).evaluateAll((figures) =>
    figures.reduce((sum, figure) => {
      const side = Number((figure.dataset.cells ?? "").split(" ")[2]);
      const widths = [...figure.querySelectorAll("path.cell")].flatMap((path) => [...path.getAttribute("d").matchAll(/h([\d.]+)v/g)].map((match) => Number(match[1])));
      return sum + figure.querySelectorAll("circle").length + widths.reduce((cells, width) => cells + Math.round(width / side), 0);
    }, 0));
}

async function charts(page, data) {
  const found = [];
  const samples = data.samples.number.length;
  const cables = data.robot.cables.length;
  const shown = data.result.candidates[data.shown];
  const least = { residuals: samples * cables, distribution: 20, map: samples, coverage: data.result.coverage.ranges.length };
  const figures = {};
  if (shown.parameter_count > 0) figures.spectrum = shown.singular_values.filter((value) => value > 0).length;
  if (shown.history.length > 1) figures.convergence = Math.min(200, shown.history.length);
  if (data.correlation?.length > 1) figures.correlation = (data.correlation.length * (data.correlation.length + 1)) / 2;
  if (data.result.candidates.length > 1) figures.ladder = data.result.candidates.filter((candidate) => Number.isFinite(candidate.criterion)).length;
  for (const [name, count] of Object.entries(figures)) {
    const drawn = await drawnMarks(page, name);
    if (drawn < 0.95 * count) found.push(`the figure ${name} has ${drawn} marks, not ${count}`);
  }
  for (const name of CHARTS_OF_EVERY_PAGE) if (!(name in least)) found.push(`nothing is known of the chart ${name}`);
  for (const [name, count] of Object.entries(least)) {
    const drawn = await marks(page, name);
    if (drawn < 0.95 * count) found.push(`the chart ${name} has ${drawn} marks, not ${count}`);
  }
  const broken = await page.locator("figure:is([data-chart], [data-figure]) svg").evaluateAll((all) => all.filter((svg) => /NaN|undefined/.test(svg.outerHTML)).length);
  if (broken > 0) found.push(`${broken} charts contain NaN or undefined`);
  return found;
}

/** The canvas is not of one colour, and turning the robot changes it. */
async function scene(page, data) {
  if (data.samples.number.length === 0) return [];
  const canvas = page.locator('figure[data-chart="scene"] canvas');
  if ((await canvas.count()) !== 1) return ["there is no scene"];
  const pixels = () =>
    canvas.evaluate((shown) => {
      const copy = document.createElement("canvas");
      [copy.width, copy.height] = [shown.width, shown.height];
      const context = copy.getContext("2d");
      context.drawImage(shown, 0, 0);
      const { data: bytes } = context.getImageData(0, 0, copy.width, copy.height);
      const colours = new Set();
      let drawn = 0;
      let sum = 0;
      for (let k = 0; k < bytes.length; k += 4) {
        if (bytes[k + 3] === 0) continue;
        drawn += 1;
        sum = (sum * 31 + k) % 1000003;
        colours.add((bytes[k] << 16) | (bytes[k + 1] << 8) | bytes[k + 2]);
      }
      return { share: drawn / (bytes.length / 4), colours: colours.size, sum };
    });
  const before = await pixels();
  if (before.share < 0.002 || before.colours < 4) return [`the scene is blank: ${JSON.stringify(before)}`];
  await canvas.focus();
  await page.keyboard.press("ArrowLeft");
  await page.waitForTimeout(200);
  const after = await pixels();
  await page.getByRole("button", { name: "Reset view" }).click();
  return after.sum === before.sum ? ["the arrow keys do not turn the scene"] : [];
}

/** Every option of every choice draws without an error; elastic models alone offer tensions. */
async function choices(page, data) {
  const found = [];
  const selects = page.locator("figure[data-chart] select");
  for (let k = 0; k < (await selects.count()); k += 1) {
    const select = selects.nth(k);
    const options = await select.locator("option").allTextContents();
    for (let index = 0; index < options.length; index += 1) await select.selectOption({ index });
    await select.selectOption({ index: 0 });
  }
  const tensions = await page.locator("figure[data-chart] option", { hasText: "tension" }).count();
  const knows = data.samples.calibrated.tension_error_N !== null;
  if (tensions > 0 !== knows) found.push(knows ? "tensions cannot be chosen" : "tensions are offered, but nobody knows them");
  return found;
}

/** Every link to a definition opens it, with the keyboard too. */
async function definitions(page) {
  const links = page.locator('thead a[href^="#def-"]');
  const link = links.first();
  await link.focus();
  await page.keyboard.press("Enter");
  const shown = await page.locator(".definition").isVisible();
  await page.keyboard.press("Escape");
  await page.evaluate(() => document.activeElement?.blur());
  const columns = await page.locator("thead th.number").count();
  const explained = await page.locator("thead th.number a").count();
  const found = shown ? [] : ["Enter on a column's title does not open its definition"];
  if (explained < 0.8 * columns) found.push(`only ${explained} of ${columns} columns of numbers have a definition`);
  return found;
}

/** Nothing sticks out sideways, wide or narrow. */
export async function layout(page) {
  const found = [];
  for (const width of [1440, 1280, 600, 390]) {
    await page.setViewportSize({ width, height: 900 });
    await page.waitForTimeout(250);
    const over = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    if (over > 0) found.push(`the page is ${over} pixels wider than a window of ${width}`);
  }
  await page.setViewportSize({ width: 1280, height: 900 });
  return found;
}
