// Paper: light colours, everything unfolded, and the scene as a picture.
import { announce } from "./theme";

/** Prepares the page for print and puts everything back afterwards. */
export function offerPrinting(): void {
  let theme: string | undefined;
  let folded: HTMLDetailsElement[] = [];
  addEventListener("beforeprint", () => {
    theme = document.documentElement.dataset.theme;
    document.documentElement.dataset.theme = "light";
    folded = [...document.querySelectorAll<HTMLDetailsElement>("details:not([open], .notices)")];
    for (const one of folded) one.open = true;
    announce();
  });
  addEventListener("afterprint", () => {
    if (theme) document.documentElement.dataset.theme = theme;
    else delete document.documentElement.dataset.theme;
    for (const one of folded) one.open = false;
    announce();
  });
}
