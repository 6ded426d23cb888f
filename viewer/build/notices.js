// Writes notices.txt: the licences of everything that went into the bundle, equal texts once.
import { existsSync, readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";

export function notices() {
  return {
    name: "cdpr-notices",
    generateBundle(_options, bundle) {
      const modules = Object.values(bundle).flatMap((file) => (file.type === "chunk" ? Object.keys(file.modules) : []));
      this.emitFile({ type: "asset", fileName: "notices.txt", source: text(packagesOf(modules)) });
    },
  };
}

/** Folders of the packages that the modules are from, sorted. */
function packagesOf(modules) {
  const folders = modules.flatMap((id) => /^\0?(.*\/node_modules\/(?:@[^/]+\/)?[^/]+)\//.exec(id)?.[1] ?? []);
  return [...new Set(folders)].sort();
}

function text(folders) {
  const byLicence = new Map();
  for (const folder of folders) {
    const { name, version, license } = JSON.parse(readFileSync(join(folder, "package.json"), "utf8"));
    const file = readdirSync(folder).find((entry) => /^licen[cs]e/i.test(entry));
    if (!file || !existsSync(join(folder, file))) throw new Error(`${name} has no licence file`);
    const licence = readFileSync(join(folder, file), "utf8").replace(/\r/g, "").trim();
    byLicence.set(licence, [...(byLicence.get(licence) ?? []), `${name} ${version} (${license})`]);
  }
  const parts = [...byLicence].map(([licence, names]) => `${names.join("\n")}\n\n${licence}\n`);
  return `This page contains the following software.\n\n${parts.join(`\n${"-".repeat(72)}\n\n`)}`;
}
