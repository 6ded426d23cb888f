// Writes viewer.stamp: hashes of the sources and of what was made from them, so that a stale bundle is found without npm.
import { createHash } from "node:crypto";
import { readFileSync, readdirSync, statSync, writeFileSync } from "node:fs";
import { join } from "node:path";

const SOURCES = ["build", "package-lock.json", "package.json", "src", "tsconfig.json", "vite.config.js"];
const MADE = ["notices.txt", "viewer.css", "viewer.js"];

export function stamp(output) {
  return {
    name: "cdpr-stamp",
    closeBundle() {
      const sources = SOURCES.flatMap(files).map((name) => line(name, name));
      const made = MADE.map((name) => line(`generated/${name}`, join(output, name)));
      writeFileSync(join(output, "viewer.stamp"), [...sources, ...made, ""].join("\n"));
    },
  };
}

function files(path) {
  if (!statSync(path).isDirectory()) return [path];
  return readdirSync(path).sort().flatMap((name) => files(`${path}/${name}`));
}

function line(name, path) {
  return `${createHash("sha256").update(readFileSync(path)).digest("hex")}  ${name}`;
}
