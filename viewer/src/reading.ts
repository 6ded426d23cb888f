// The data block of the page.
import type { PageData } from "./data";

/** The block; null where no candidate could be identified, or the page comes drawn. */
export function readData(): PageData {
  const text = document.getElementById("cdpr-data")?.textContent;
  return text ? (JSON.parse(text) as PageData) : null;
}
