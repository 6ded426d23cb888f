// What must be true of the page of a run: it plays, everything follows the slider, and what broke is marked.

/** Everything wrong with the page, in words. */
export async function checkRun(page, layout) {
  const data = JSON.parse(await page.locator("#cdpr-data").textContent());
  const found = [];
  const check = async (what, examine) => {
    for (const complaint of await examine(page, data)) found.push(`${what}: ${complaint}`);
  };
  await check("tensions", tensions);
  await check("playing", playing);
  await check("time line", timeLine);
  await check("figures", figures);
  found.push(...(await layout(page)));
  return found;
}

const SLIDER = "input.scrubber";

async function moveTo(page, share) {
  await page.locator(SLIDER).evaluate((slider, value) => {
    slider.value = String(value);
    slider.dispatchEvent(new Event("input"));
  }, 1000 * share);
}

const numbers = (page) => page.locator(".run-tensions tbody td.number").allTextContents();

/** The table shows the moment of the slider, and names broken cables. */
async function tensions(page, data) {
  const { time_s, tensions_N } = data.moments;
  const found = [];
  for (const share of [0, 0.25, 0.9]) {
    await moveTo(page, share);
    const time = time_s[0] + share * (time_s.at(-1) - time_s[0]);
    const at = time_s.findLastIndex((one) => one <= time + 1e-9);
    const expected = tensions_N[at].map((tension) => tension.toFixed(0));
    const shown = await numbers(page);
    if (shown.join() !== expected.join()) found.push(`at ${time} s the table shows ${shown}, not ${expected}`);
  }
  const breaks = data.events.filter((event) => event.breaks && event.time_s < 0.9 * time_s.at(-1)).length;
  const named = await page.locator(".run-tensions tbody td", { hasText: "broken" }).count();
  if (named !== breaks) found.push(`${named} cables are named broken, not ${breaks}`);
  return found;
}

/** The button lets the time run on, and stops it. */
async function playing(page) {
  await moveTo(page, 0);
  const slider = page.locator(SLIDER);
  await page.getByRole("button", { name: "Play" }).click();
  await page.waitForTimeout(400);
  await page.getByRole("button", { name: "Pause" }).click();
  const reached = Number(await slider.inputValue());
  await page.waitForTimeout(150);
  const later = Number(await slider.inputValue());
  return [...(reached > 0 ? [] : ["the time does not run"]), ...(later === reached ? [] : ["the time does not stop"])];
}

/** Every event and every broken limit has its mark with words. */
async function timeLine(page, data) {
  const found = [];
  for (const [kind, list] of [["event", data.events], ["violation", data.broken_limits]]) {
    const titles = await page.locator(`.time-line .${kind} title`).allTextContents();
    if (titles.length !== list.length) found.push(`${titles.length} marks of ${kind}s, not ${list.length}`);
    if (!list.every(({ words }) => titles.some((title) => title.includes(words)))) found.push(`a mark of ${kind}s lacks its words`);
  }
  return found;
}

/** A click into a figure goes to its time; the line of every figure stands there. */
async function figures(page) {
  const all = page.locator("svg.figure[data-time]");
  const count = await all.count();
  if (count < 2) return [`${count} figures follow the time`];
  const [left, right] = (await all.first().getAttribute("data-time")).split(" ").map(Number);
  await all.first().scrollIntoViewIfNeeded();
  const box = await all.first().boundingBox();
  const width = await all.first().evaluate((svg) => svg.viewBox.baseVal.width);
  await page.mouse.click(box.x + ((left + 0.5 * (right - left)) / width) * box.width, box.y + 0.5 * box.height);
  const share = Number(await page.locator(SLIDER).inputValue()) / 1000;
  const places = await page.locator("svg.figure .now-line").evaluateAll((lines) => lines.map((line) => Number(line.getAttribute("x1"))));
  const found = Math.abs(share - 0.5) < 0.02 ? [] : [`a click into the middle of a figure goes to ${share}`];
  if (!places.every((x) => Math.abs(x - left - 0.5 * (right - left)) < 0.02 * (right - left))) found.push(`the lines stand at ${places}`);
  return found;
}
