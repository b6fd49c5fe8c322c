// What the theme leaves out for those who hear the page or have no mouse: names, levels, and a focus for what scrolls.
const name = (selector, attribute, value) =>
  document.querySelectorAll(selector).forEach((one) => one.setAttribute(attribute, value));

function reach() {
  for (const one of document.querySelectorAll("pre, .equation .wide, .table-wrapper")) {
    one.toggleAttribute("tabindex", false);
    if (one.scrollWidth > one.clientWidth) one.setAttribute("tabindex", "0");
  }
}

// F_0 reads as F with a 0 below it wherever it is no code; it stays F_0 in the page's source and in the search
const LETTER = /(?<![\p{L}\d_.])(\p{L}|Delta)_(\p{L}{1,3}|\d)(?![\p{L}\d_])/gu;
const AS_IT_IS = "code, pre, math, script, style, dt, svg, sub, .sig";

function lower(within) {
  const texts = document.createTreeWalker(within, NodeFilter.SHOW_TEXT);
  const found = [];
  while (texts.nextNode())
    if (!texts.currentNode.parentElement.closest(AS_IT_IS) && texts.currentNode.data.search(LETTER) >= 0) found.push(texts.currentNode);
  for (const one of found) {
    const parts = one.data.split(LETTER);  // text, letter, what stands below it, text, ...
    const made = parts.map((part, k) => {
      if (k % 3 < 2) return k % 3 ? part.replace("Delta", "Δ") : part;
      const below = document.createElement("sub");
      below.textContent = part;
      return below;
    });
    one.replaceWith(...made);
  }
}

document.addEventListener("DOMContentLoaded", () => {
  const article = document.querySelector("article");
  if (article && !document.querySelector("h1")) {
    const title = document.createElement("h1");  // the theme's page of the search has none until something is sought
    title.textContent = document.title.split(" - ")[0];
    article.prepend(title);
  }
  document.querySelectorAll("article, .sidebar-tree, .toc-tree").forEach(lower);
  name('.caption[role="heading"]', "aria-level", "2");
  name(".sidebar-drawer", "aria-label", "All pages");
  name(".toc-drawer", "aria-label", "On this page");
  reach();
});
addEventListener("resize", reach);
