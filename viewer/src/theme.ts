// Light or dark: as the system says until the reader chooses. Charts follow by CSS; the scene is told.

type Listener = () => void;
const listeners: Listener[] = [];

/** Calls back whenever the colours of the page change. */
export function onThemeChange(listener: Listener): void {
  listeners.push(listener);
}

/** True while the page is dark. */
export function isDark(): boolean {
  const chosen = document.documentElement.dataset.theme;
  return chosen ? chosen === "dark" : matchMedia("(prefers-color-scheme: dark)").matches;
}

/** Calls every listener, e.g. before the page is printed in light colours. */
export function announce(): void {
  for (const listener of listeners) listener();
}

/** Makes the button that the frame of the page has hidden for readers without scripts. */
export function offerTheme(): void {
  const button = document.querySelector<HTMLButtonElement>("button[data-theme-button]");
  if (!button) return;
  const label = () => {
    button.textContent = isDark() ? "Light colours" : "Dark colours";
  };
  button.hidden = false;
  button.addEventListener("click", () => {
    document.documentElement.dataset.theme = isDark() ? "light" : "dark";
    label();
    announce();
  });
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
    label();
    announce();
  });
  label();
}

/** A colour of the page as the browser computes it. */
export function colour(name: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}
