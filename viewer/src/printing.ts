// Paper: light colours, everything unfolded, charts as wide as the page, and the scene as a picture.
import { announce } from "./theme";

/** Width of the text on A4 with the margins of the style (pixels of CSS). */
export const PAPER_WIDTH = 680;

type Listener = (isPaper: boolean) => void;
const listeners: Listener[] = [];

/** Calls back before the page is printed, when everything is unfolded, and afterwards. */
export function onPrint(listener: Listener): void {
  listeners.push(listener);
}

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
    for (const listener of listeners) listener(true);
  });
  addEventListener("afterprint", () => {
    if (theme) document.documentElement.dataset.theme = theme;
    else delete document.documentElement.dataset.theme;
    for (const one of folded) one.open = false;
    announce();
    for (const listener of listeners) listener(false);
  });
}
