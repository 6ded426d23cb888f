// Opens pages of the command in headless Chromium and checks what a reader would see. Called by `cargo xtask test --only browser`:
//   node test/browser.mjs CHROMIUM OUTPUT [KIND FOLDER_OF_A_RESULT]…
// The page's body names its kind. Each folder holds report.html, and result.json where the command writes one, or workspace.html. Screenshots go to OUTPUT. Ends with 1 when anything is wrong.
import { existsSync, mkdtempSync, mkdirSync, readFileSync, rmSync, statSync } from "node:fs";
import { tmpdir } from "node:os";
import { basename, join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";
import { checkDrawn } from "./drawn-checks.mjs";
import { checkPage, layout } from "./page-checks.mjs";
import { checkRun } from "./run-checks.mjs";
import { checkStudy } from "./study-checks.mjs";
import { checkWorkspace } from "./workspace-checks.mjs";

const ARGUMENTS = [
  "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
  "--disable-component-update", "--disable-sync", "--enable-unsafe-swiftshader",
];
const LARGEST_BYTES = 2_000_000;
// The aim is 2 s on a quiet machine and is printed; a busy one may take longer, a page that hangs takes for ever.
const LONGEST_MILLISECONDS = 30_000;

/** What must be true of every kind of page. */
const CHECKS = {
  report: checkPage,
  workspace: (page) => checkWorkspace(page, layout),
  study: (page) => checkStudy(page, layout),
  run: (page) => checkRun(page, layout),
  campaign: checkDrawn,
  chain: checkDrawn,
  benchmark: checkDrawn,
  capability: checkDrawn,
  response: checkDrawn,
};

const [executablePath, output, ...pages] = process.argv.slice(2);
mkdirSync(output, { recursive: true });
let complaints = 0;
const waiting = pages.flatMap((kind, k) => (k % 2 === 0 ? [{ kind, folder: pages[k + 1] }] : []));
// two at a time: a browser draws on one core
await Promise.all([examineAll(), examineAll()]);
process.exitCode = complaints > 0 ? 1 : 0;

/** Examines pages until none is left, each in a browser of its own. */
async function examineAll() {
  for (let next = waiting.shift(); next !== undefined; next = waiting.shift()) {
    const { kind, folder } = next;
    const name = basename(folder);
    const profile = mkdtempSync(join(tmpdir(), "cdpr-browser-"));
    const context = await chromium.launchPersistentContext(profile, { executablePath, args: ARGUMENTS, viewport: { width: 1280, height: 900 } });
    try {
      for (const complaint of await examine(context, kind, folder)) {
        complaints += 1;
        console.log(`${name}: ${complaint}`);
      }
    } finally {
      await context.close();
      rmSync(profile, { recursive: true, force: true });
    }
  }
}

async function examine(context, kind, folder) {
  const name = basename(folder);
  const workspace = resolve(folder, "workspace.html");
  const file = existsSync(workspace) ? workspace : resolve(folder, "report.html");
  const json = join(folder, "result.json");
  const result = existsSync(json) ? JSON.parse(readFileSync(json, "utf8")) : null;
  const address = pathToFileURL(file).href;
  const found = [];
  const page = await context.newPage();
  page.on("console", (message) => message.type() === "error" && found.push(`the console says: ${message.text()}`));
  page.on("pageerror", (error) => found.push(`the script failed: ${error.message}`));
  page.on("request", (request) => {
    const url = request.url();
    if (url !== address && !url.startsWith("data:") && !url.startsWith("blob:")) found.push(`the page asks for ${url}`);
  });
  const bytes = statSync(file).size;
  const start = performance.now();
  await page.goto(address);
  await page.waitForSelector("html[data-drawn]");
  const milliseconds = performance.now() - start;
  console.log(`${name}: ${(bytes / 1e6).toFixed(2)} MB, drawn after ${milliseconds.toFixed(0)} ms`);
  if (bytes > LARGEST_BYTES) found.push(`the page has ${bytes} bytes, more than ${LARGEST_BYTES}`);
  if (milliseconds > LONGEST_MILLISECONDS) found.push(`the page took ${milliseconds.toFixed(0)} ms, more than ${LONGEST_MILLISECONDS}`);
  found.push(...(await checks(page, kind, result)));
  await pictures(page, name);
  await page.close();
  return found;
}

/** What is wrong with a page of its kind. */
async function checks(page, kind, result) {
  const own = await page.locator("body").getAttribute("data-page");
  if (own !== kind) return [`the page is of the kind ${own}, not ${kind}`];
  return kind in CHECKS ? CHECKS[kind](page, result) : [`nothing is known of pages of the kind ${kind}`];
}

/** The page wide and narrow, light and dark, and on paper, for people to look at. */
async function pictures(page, name) {
  for (const [width, height, colorScheme] of [[1440, 900, "light"], [1440, 900, "dark"], [390, 844, "light"]]) {
    await page.emulateMedia({ colorScheme });
    await page.setViewportSize({ width, height });
    // as a reader finds it, then with every part open
    await page.reload();
    await page.waitForSelector("html[data-drawn]");
    await page.waitForTimeout(300);
    await page.evaluate(() => scrollTo(0, 0));
    await page.waitForTimeout(100);
    await page.screenshot({ path: join(output, `${name}-${width}-${colorScheme}-first.png`) });
    await page.locator("details.part").evaluateAll((all) => all.forEach((one) => { one.open = true; }));
    await page.waitForTimeout(300);
    await page.screenshot({ path: join(output, `${name}-${width}-${colorScheme}.png`), fullPage: true });
  }
  await page.setViewportSize({ width: 1280, height: 900 });
  await page.emulateMedia({ colorScheme: "dark" });
  await page.pdf({ path: join(output, `${name}.pdf`), preferCSSPageSize: true });
}
