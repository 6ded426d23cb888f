// Choices above a figure: native selects and buttons, so that they work with the keyboard and with screen readers.

/** An option: what it is called, and what it stands for. */
export interface Option<T> {
  label: string;
  value: T;
}

/** A labelled select; `changed` is called with the value chosen. Nothing is shown for a single option. */
export function choice<T>(into: HTMLElement, label: string, options: Option<T>[], changed: (value: T) => void): () => T {
  let current = 0;
  const value = () => (options[current] as Option<T>).value;
  if (options.length > 1) {
    const select = element("select");
    for (const option of options) select.append(element("option", option.label));
    select.addEventListener("change", () => {
      current = select.selectedIndex;
      changed(value());
    });
    const wrapper = element("label", `${label} `);
    wrapper.append(select);
    into.append(wrapper);
  }
  return value;
}

/** A button. */
export function button(into: HTMLElement, label: string, pressed: () => void): HTMLButtonElement {
  const made = element("button", label);
  made.type = "button";
  made.addEventListener("click", pressed);
  into.append(made);
  return made;
}

/** An element with text. */
export function element<K extends keyof HTMLElementTagNameMap>(
  name: K,
  text = "",
  className = "",
): HTMLElementTagNameMap[K] {
  const made = document.createElement(name);
  if (text) made.textContent = text;
  if (className) made.className = className;
  return made;
}
