// Folded parts of a page: all at once by a button, and the one that a link leads into.

/** Makes the button that the frame of the page has hidden for readers without scripts, and lets links unfold what they lead to. */
export function offerFolding(): void {
  const parts = [...document.querySelectorAll<HTMLDetailsElement>("details.part")];
  const button = document.querySelector<HTMLButtonElement>("button[data-fold-button]");
  if (button && parts.length > 0) {
    const isAllOpen = () => parts.every((part) => part.open);
    const label = () => {
      button.textContent = isAllOpen() ? "Close all" : "Open all";
    };
    button.hidden = false;
    button.addEventListener("click", () => {
      const open = !isAllOpen();
      for (const part of parts) part.open = open;
    });
    for (const part of parts) part.addEventListener("toggle", label);
    label();
  }
  addEventListener("hashchange", unfoldTarget);
  unfoldTarget();
}

/** Opens whatever holds the element of the address. */
function unfoldTarget(): void {
  const target = location.hash ? document.getElementById(decodeURIComponent(location.hash.slice(1))) : null;
  if (!target) return;
  for (let fold = target.closest("details"); fold; fold = fold.parentElement?.closest("details") ?? null) fold.open = true;
  target.scrollIntoView();
}
