// Cables that events took away.
import type { RunData } from "../data";

/** True after an event that took the cable away. */
export function isBroken(data: RunData, cable: number, time: number): boolean {
  return data.events.some((event) => event.breaks && event.cable === cable && event.time_s < time);
}
