// A definition a click away: a link to a definition opens it beside the link; the list itself stands at the end of the page.
import { element } from "./controls";

/** Turns links to definitions into small windows that Escape or a click elsewhere closes. */
export function offerDefinitions(): void {
  const popover = element("div", "", "definition");
  if (typeof popover.showPopover !== "function") return; // an old browser follows the link
  popover.popover = "auto";
  popover.setAttribute("role", "note");
  document.body.append(popover);
  document.addEventListener("click", (event) => {
    const link = event.target instanceof Element ? event.target.closest<HTMLAnchorElement>('a[href^="#def-"]') : null;
    const term = link && document.getElementById(link.hash.slice(1));
    if (!link || !term) return;
    event.preventDefault();
    show(popover, link, term);
  });
}

function show(popover: HTMLElement, link: HTMLElement, term: HTMLElement): void {
  popover.replaceChildren(element("strong", term.textContent ?? ""));
  const text = term.nextElementSibling?.cloneNode(true);
  if (text) popover.append(...text.childNodes);
  popover.showPopover();
  const [from, own] = [link.getBoundingClientRect(), popover.getBoundingClientRect()];
  const left = Math.max(8, Math.min(from.left, innerWidth - own.width - 8));
  const below = from.bottom + 6;
  const top = below + own.height < innerHeight ? below : Math.max(8, from.top - own.height - 6);
  popover.style.left = `${left}px`;
  popover.style.top = `${top}px`;
}
