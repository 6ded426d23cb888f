// Bundles the viewer into the files that are inlined into every page.
import { defineConfig } from "vite";
import { notices } from "./build/notices.js";
import { stamp } from "./build/stamp.js";

const output = process.env.CDPR_VIEWER_OUT ?? "../crates/cdpr-reports/src/html_page/generated";

export default defineConfig({
  logLevel: "warn",
  build: {
    outDir: output,
    emptyOutDir: false,
    target: "es2022",
    modulePreload: false,
    chunkSizeWarningLimit: 1500,
    lib: {
      entry: "src/main.ts",
      formats: ["iife"],
      name: "cdprReport",
      fileName: () => "viewer.js",
      cssFileName: "viewer",
    },
  },
  plugins: [notices(), stamp(output)],
});
