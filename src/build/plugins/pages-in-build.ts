import type { Plugin, Rolldown } from "vite";
import { type Assets, ENTRIES, type PageAssets } from "../assets.ts";
import { coverageText } from "../coverage.ts";
import { type Characters, gatherCharacters } from "../fonts/characters.ts";
import { emitFonts, type FontSheet } from "../fonts/emit-fonts.ts";
import { FACES } from "../fonts/faces.ts";
import { licencesText, packagesOf } from "../licences.ts";
import { sitemap } from "../pages/sitemap.ts";
import { problemsText } from "../problem.ts";
import type { Site } from "../site.ts";
import { buildWorkshop, type Workshop } from "../workshop.ts";

/** Writes the pages of the site into the bundle. Problems of the lessons stop the build before anything is bundled. */
export function pagesInBuild(): Plugin {
  let root = "";
  let workshop: Workshop | null = null;
  let site: Site | null = null;
  let say: (text: string) => void = () => {};
  return {
    name: "straklatte:pages",
    apply: "build",
    enforce: "post",
    config: () => ({
      build: {
        rolldownOptions: {
          input: { ...ENTRIES },
          checks: { pluginTimings: false },
          output: {
            entryFileNames: ({ name }) => (name === "embed-js" ? "embed.js" : "assets/[name]-[hash].js"),
          },
        },
      },
    }),
    configResolved(config) {
      root = config.root;
      say = (text) => config.logger.info(text);
    },
    async buildStart() {
      workshop = await buildWorkshop(root);
      const { openSite } = await workshop.load<typeof import("../site.ts")>("/src/build/site.ts");
      site = await openSite({ root, policy: true, siteUrl: siteUrl() });
      if (site.problems.length > 0) {
        // Where in the build the mistake was noticed helps nobody.
        const message = problemsText(site.problems);
        this.error({ message, stack: "" });
      }
      say(coverageText(site.coverage));
    },
    async generateBundle(_, bundle) {
      const bare: Assets = { page: assetsOf(bundle, "page"), embed: assetsOf(bundle, "embed") };
      const fonts = await emitFonts(this, root, charactersOf(site!, bare, bundle));
      const assets: Assets = {
        page: withFonts(bare.page, fonts.page),
        embed: withFonts(bare.embed, fonts.embed),
      };
      for (const page of site!.pages) {
        const source = site!.render(page, assets);
        this.emitFile({ type: "asset", fileName: `${page.path}index.html`, source });
      }
      const home = siteUrl();
      const add = (fileName: string, source: string) => this.emitFile({ type: "asset", fileName, source });
      add("404.html", site!.notFound({ policy: true, siteUrl: home }));
      add("licences.txt", licencesText(root, packagesOf([...modulesOf(bundle), ...FONT_FILES])));
      if (home !== null) add("sitemap.xml", sitemap(site!.pages, home));
    },
    async closeBundle() {
      await workshop?.close();
    },
  };
}

/** Files of packages that reach the site other than by a script. */
const FONT_FILES = FACES.map(({ file }) => `node_modules/${file}`);

function modulesOf(bundle: Rolldown.OutputBundle): string[] {
  return Object.values(bundle).flatMap((one) => (one.type === "chunk" ? one.moduleIds : []));
}

/** `SITE_URL` with one slash at its end; null if it is not set. */
function siteUrl(): string | null {
  const given = process.env.SITE_URL;
  if (!given) return null;
  if (!URL.canParse(given))
    throw new Error(`SITE_URL is no address: ${given}; write https://example.org/folder/`);
  return `${given.replace(/\/+$/, "")}/`;
}

/** Script and style sheets of an entry, with those of what it imports. */
function assetsOf(bundle: Rolldown.OutputBundle, name: string): PageAssets {
  const chunks = Object.values(bundle).filter((one) => one.type === "chunk");
  const entry = chunks.find((chunk) => chunk.isEntry && chunk.name === name);
  if (!entry) throw new Error(`the bundle has no entry "${name}"`);
  const needed = [entry, ...chunks.filter((chunk) => entry.imports.includes(chunk.fileName))];
  const styles = needed.flatMap((chunk) => [...(chunk.viteMetadata?.importedCss ?? [])]);
  return { styles: [...new Set(styles)], scripts: [entry.fileName], fonts: [] };
}

function withFonts({ styles, scripts }: PageAssets, { sheet, first }: FontSheet): PageAssets {
  return { styles: [sheet, ...styles], scripts, fonts: first };
}

/** What the fonts must hold. Pages are made once without fonts, to see what stands in them. */
function charactersOf(site: Site, assets: Assets, bundle: Rolldown.OutputBundle): Characters {
  const pages = site.pages.map((page) => site.render(page, assets));
  const scripts = Object.values(bundle).flatMap((one) => (one.type === "chunk" ? [one.code] : []));
  return gatherCharacters(pages, scripts);
}
