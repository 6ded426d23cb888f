// Tables and drawings that are wider than their box: they fade where they go on, and their caption says that they scroll.

/** Watches every box that may scroll sideways. */
export function offerScrolling(): void {
  for (const box of document.querySelectorAll<HTMLElement>(".scroll, .chart")) watch(box);
}

function watch(box: HTMLElement): void {
  // what may reach out of its box is not cut, so that nothing is to be scrolled
  if (getComputedStyle(box).overflowX === "visible") return;
  const mark = () => {
    const rest = box.scrollWidth - box.clientWidth;
    box.toggleAttribute("data-scrolls", rest > 4);
    box.toggleAttribute("data-more-left", rest > 4 && box.scrollLeft > 4);
    box.toggleAttribute("data-more-right", rest > 4 && box.scrollLeft < rest - 4);
  };
  box.addEventListener("scroll", mark, { passive: true });
  const sizes = new ResizeObserver(mark);
  sizes.observe(box);
  if (box.firstElementChild) sizes.observe(box.firstElementChild);
  mark();
}
