// What the search of the site finds: words in any of their forms, and what is written otherwise.
//   node search_test.js SITE
"use strict";
const fs = require("fs");
const path = require("path");
const vm = require("vm");

const site = path.join(process.argv[2], "site");
if (!fs.existsSync(path.join(site, "search-index.js"))) {
  console.log("skipped: the site was not built");
  process.exit(77);
}
const context = { window: {} };
vm.createContext(context);
for (const name of ["search.js", "search-index.js"])
  vm.runInContext(fs.readFileSync(path.join(site, name), "utf8"), context);
const pages = context.window.sarsimPages;

let failures = 0;
function check(right, message) {
  if (right) return;
  failures += 1;
  console.log(message);
}

// Links of the best hits.
function hits(typed) {
  const words = typed.toLowerCase().split(/\s+/).filter((word) => word.length > 1);
  return pages
    .map((entry) => [context.sarsimRank(entry, words), entry.link])
    .filter((hit) => hit[0] > 0)
    .sort((a, b) => b[0] - a[0])
    .map((hit) => hit[1]);
}

for (const forms of [
  ["quantisation", "quantization", "quantised", "quantise"],
  ["polarization", "polarisation", "polarised"],
  ["migration", "migrations"],
  ["satellite", "satellites"],
])
  for (const form of forms)
    check(context.sarsimStem(form) === context.sarsimStem(forms[0]), `${form} has another stem than ${forms[0]}`);

// A page among the first ten hits, of words that it may not hold as they are typed.
for (const [typed, page] of [
  ["monte carlo", "guide/sweeps.html"],
  ["polarization", "guide/physics.html"],
  ["range ambiguity", "theory/echo-model.html"],
  ["quantization", "guide/commands.html"],
  ["navigation", "theory/"],
  ["satellites", ""],
  ["region of interest", "guide/commands.html"],
  ["slurm cluster", "guide/many-machines.html"],
  ["checkpoint", "guide/"],
  ["apodization", "guide/"],
]) {
  const found = hits(typed);
  check(found.slice(0, 10).some((link) => link.startsWith(page)), `${typed}: ${page} is not among ${found.slice(0, 10)}`);
}
check(hits("xylophone").length === 0, "what is nowhere is found");
check(hits("satellite xylophone").length === 0, "not all words have to be there");
console.log(`${pages.length} sections searched, ${failures} failures`);
process.exit(failures > 0 ? 1 : 0);
