// What must be true of a page that comes drawn, without a block of data: campaign, chain, benchmark.
import { layout, paper, phone } from "./page-checks.mjs";

/** Everything wrong with the page, in words; `result` is result.json where the command writes one. */
export async function checkDrawn(page, result) {
  const found = [];
  if ((await page.locator("#cdpr-data").count()) > 0) found.push("a page that comes drawn has a block of data");
  found.push(...(await verdict(page, result)));
  found.push(...(await tables(page)));
  found.push(...(await figures(page)));
  found.push(...(await layout(page)));
  found.push(...(await phone(page)));
  found.push(...(await paper(page)));
  return found;
}

/** The first screen says what came out, the list of warnings is that of the answer, and no number is broken. */
async function verdict(page, result) {
  const found = [];
  for (const part of ["h1", ".verdict .heading", ".verdict .line"]) {
    const words = page.locator(part);
    if ((await words.count()) !== 1 || !(await words.innerText()).trim()) found.push(`${part} says nothing`);
  }
  const body = await page.locator("main, header").allInnerTexts();
  const broken = body.join(" ").match(/\b(NaN|undefined|inf|None|null)\b/g) ?? [];
  // a list without warnings says so
  if (broken.filter((word) => word !== "None").length > 0) found.push(`the page shows ${broken}`);
  if (!result) return found;
  const told = await page.locator("#warnings ~ ul li").allTextContents();
  const plain = result.warnings.map((warning) => warning.replaceAll("`", ""));
  if (JSON.stringify(told) !== JSON.stringify(plain)) found.push(`the page warns of ${JSON.stringify(told)}, the answer of ${JSON.stringify(plain)}`);
  return found;
}

/** Every table has rows as wide as its heading; numbers and their titles stand on the same side. */
async function tables(page) {
  const found = await page.locator("table").evaluateAll((all) =>
    all.flatMap((table) => {
      const name = table.caption?.textContent ?? "a table";
      const [heading, ...more] = table.tHead.rows;
      const rows = [...table.tBodies].flatMap((body) => [...body.rows]);
      const ragged = rows.filter((row) => row.cells.length !== heading.cells.length).length;
      const side = (cell) => getComputedStyle(cell).textAlign.replace("start", "left");
      const askew = [...heading.cells].filter((title, column) => rows.some((row) => row.cells[column] && side(row.cells[column]) !== side(title))).length;
      return [
        ...(more.length > 0 ? [`${name} has two headings`] : []),
        ...(rows.length === 0 ? [`${name} is empty`] : []),
        ...(ragged > 0 ? [`${name} has ${ragged} ragged rows`] : []),
        ...(askew > 0 ? [`${name}: the titles of ${askew} columns stand on another side than their cells`] : []),
      ];
    }));
  return (await page.locator("table").count()) === 0 ? ["the page has no table"] : found;
}

/** There is a figure, with a name for those who cannot see it, and without broken numbers. */
async function figures(page) {
  const all = page.locator("main figure svg");
  if ((await all.count()) === 0) return ["the page has no figure"];
  return all.evaluateAll((figures) =>
    figures.flatMap((figure) => [
      ...(figure.getAttribute("aria-label") ? [] : ["a figure has no name"]),
      ...(/NaN|undefined/.test(figure.outerHTML) ? ["a figure contains NaN or undefined"] : []),
    ]));
}
