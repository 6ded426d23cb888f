// Drawings and pictures as files. They are made from what the page shows; nothing is fetched.

/** A drawing as a file of its own: colours of the page are written into it. */
export function svgText(drawing: SVGSVGElement): string {
  const copy = drawing.cloneNode(true) as SVGSVGElement;
  copy.setAttribute("xmlns", "http://www.w3.org/2000/svg");
  const from = [...drawing.querySelectorAll<SVGElement>("[class]")];
  // what classes say is known only to the page
  [...copy.querySelectorAll<SVGElement>("[class]")].forEach((part, index) => {
    const look = getComputedStyle(from[index] as SVGElement);
    for (const name of ["fill", "stroke", "stroke-width", "stroke-dasharray", "paint-order", "font-weight", "font-size", "text-anchor", "dominant-baseline"]) part.style.setProperty(name, look.getPropertyValue(name));
  });
  for (const tip of copy.querySelectorAll('[aria-label="tip"]')) tip.remove();
  const ground = document.createElementNS("http://www.w3.org/2000/svg", "rect");
  ground.setAttribute("style", "fill: var(--paper)");
  ground.setAttribute("width", "100%");
  ground.setAttribute("height", "100%");
  copy.prepend(ground);
  return coloured(new XMLSerializer().serializeToString(copy));
}

/** Variables of the page replaced by their values. */
function coloured(text: string): string {
  const page = getComputedStyle(document.documentElement);
  return text.replace(/var\((--[\w-]+)\)/g, (whole, name: string) => page.getPropertyValue(name).trim() || whole);
}

export function svg(drawing: SVGSVGElement): Blob {
  return new Blob([svgText(drawing)], { type: "image/svg+xml" });
}

/** An entry of a legend. */
export interface Entry {
  picture: SVGSVGElement;
  words: string;
}

/** All drawings of a place, where they stand, as one drawing with a legend and lines of text below. */
export function sheet(place: HTMLElement, legend: Entry[], words: string[]): string {
  const box = place.getBoundingClientRect();
  const from = (element: Element) => {
    const at = element.getBoundingClientRect();
    return { x: at.left - box.left, y: at.bottom - box.top, top: at.top - box.top };
  };
  const moved = (drawing: SVGSVGElement, x: number, y: number) => svgText(drawing).replace(/^<svg /, `<svg x="${x}" y="${y}" `);
  const text = (line: string, x: number, y: number) => `<text x="${x}" y="${y}" fill="var(--ink)">${escaped(line)}</text>`;
  const drawings = [...place.querySelectorAll("svg")].filter((one) => !one.parentElement?.closest("svg"));
  const parts = drawings.map((one) => moved(one, from(one).x, from(one).top));
  const titles = [...place.querySelectorAll<HTMLElement>(".panel-title")].map((one) => text(one.textContent ?? "", from(one).x, from(one).y - 4));
  let [x, y] = [12, box.height + 24];
  const entries = legend.map((entry) => {
    const width = 60 + 7.5 * entry.words.length;
    if (x > 12 && x + width > box.width) [x, y] = [12, y + 20];
    const drawn = moved(entry.picture, x, y - 11) + text(entry.words, x + 42, y);
    x += width;
    return drawn;
  });
  const lines = words.map((line, index) => text(line, 12, y + 20 * (index + 1)));
  const height = y + 20 * words.length + 12;
  const head = `<svg xmlns="http://www.w3.org/2000/svg" width="${box.width}" height="${height}" viewBox="0 0 ${box.width} ${height}" font-family="system-ui, sans-serif" font-size="13">`;
  return coloured(`${head}<rect width="100%" height="100%" fill="var(--paper)"/>${[...parts, ...titles, ...entries, ...lines].join("")}</svg>`);
}

function escaped(text: string): string {
  return text.replace(/&/g, "&amp;").replace(/</g, "&lt;");
}

/** A drawing as a picture, two dots for every pixel. */
export function picture(text: string): Promise<Blob | null> {
  return new Promise((done) => {
    const image = new Image();
    image.onload = () => {
      const canvas = document.createElement("canvas");
      [canvas.width, canvas.height] = [2 * image.naturalWidth, 2 * image.naturalHeight];
      canvas.getContext("2d")?.drawImage(image, 0, 0, canvas.width, canvas.height);
      canvas.toBlob(done, "image/png");
    };
    image.onerror = () => done(null);
    image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(text)}`;
  });
}

/** Hands a file to the reader. */
export function save(blob: Blob | null, name: string): void {
  if (!blob) return;
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}
