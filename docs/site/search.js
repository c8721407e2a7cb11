// Searches the headings and texts of all pages, whose list (search-index.js) is loaded when the field is first used. A script
// and not a request, because pages that are opened from a disk may load no other files.

// The part of an English word that its forms have alike: "quantised", "quantization" and "quantising" are "quant".
function sarsimStem(word) {
  const root = word
    .replace(/(is|iz)(e|ed|es|er|ers|ing|ation|ations)$/, "")
    .replace(/(ations|ation|itional|ities|ity|ous|ings|ing|ers|ies|ied|ed|es|er|al|s|e|y)$/, "");
  return root.length >= 3 ? root : word;
}

// How well an entry of the list answers some words: all of them have to be somewhere, in any of their forms. A word in
// the heading counts more than one in the text, one as it was typed more than another form, and one that is written
// otherwise there (docs/site/synonyms.toml) as much as one in the text.
function sarsimRank(entry, words) {
  const title = (entry.page + " " + entry.heading).toLowerCase();
  const text = entry.text.toLowerCase();
  const also = entry.also || "";
  const phrase = words.join(" ");
  let sum = words.length > 1 && (title.includes(phrase) || text.includes(phrase) || also.includes(phrase)) ? 20 : 0;
  for (const word of words) {
    const stem = sarsimStem(word);
    if (title.includes(word)) sum += 10;
    else if (title.includes(stem)) sum += 8;
    else if (text.includes(word)) sum += 2;
    else if (text.includes(stem) || also.includes(stem)) sum += 1;
    else return 0;
  }
  return sum;
}

(function () {
  "use strict";
  if (typeof document === "undefined") return;  // A test asks for the functions above alone.
  const root = document.body.dataset.root;
  const field = document.getElementById("search");
  const list = document.getElementById("found");
  let asked = false;

  function load() {
    if (asked) return;
    asked = true;
    const script = document.createElement("script");
    script.src = root + "site/search-index.js";
    script.onload = show;
    document.head.appendChild(script);
  }

  function excerpt(text, word) {
    const small = text.toLowerCase();
    const found = small.indexOf(word) >= 0 ? small.indexOf(word) : small.indexOf(sarsimStem(word));
    const at = Math.max(0, found - 40);
    return (at > 0 ? "… " : "") + text.slice(at, at + 120);
  }

  function show() {
    const words = field.value.toLowerCase().split(/\s+/).filter((word) => word.length > 1);
    list.replaceChildren();
    list.hidden = words.length === 0 || !window.sarsimPages;
    if (list.hidden) return;
    const hits = window.sarsimPages.map((entry) => [sarsimRank(entry, words), entry]).filter((hit) => hit[0] > 0);
    hits.sort((a, b) => b[0] - a[0]);
    for (const [, entry] of hits.slice(0, 20)) {
      const line = document.createElement("a");
      line.href = root + entry.link;
      line.textContent = entry.heading === entry.page ? entry.page : entry.page + ": " + entry.heading;
      const small = document.createElement("small");
      small.textContent = excerpt(entry.text, words[0]);
      line.appendChild(small);
      const item = document.createElement("li");
      item.appendChild(line);
      list.appendChild(item);
    }
    if (hits.length === 0) list.textContent = "Nothing found";
  }

  field.addEventListener("focus", load);
  field.addEventListener("input", show);
  document.addEventListener("keydown", function (event) {
    if (event.key === "Escape") list.hidden = true;
    if (event.key === "/" && document.activeElement !== field) {
      event.preventDefault();
      field.focus();
    }
  });
  document.addEventListener("click", function (event) {
    if (!event.target.closest("form")) list.hidden = true;
  });
  const here = document.querySelector("nav [aria-current]");
  if (here) here.scrollIntoView({ block: "nearest" });
})();
