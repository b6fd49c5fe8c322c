// What the theme leaves out for those who hear the page or have no mouse: names, levels, and a focus for what scrolls.
const name = (selector, attribute, value) =>
  document.querySelectorAll(selector).forEach((one) => one.setAttribute(attribute, value));

function reach() {
  for (const one of document.querySelectorAll("pre, .equation .wide, .table-wrapper")) {
    one.toggleAttribute("tabindex", false);
    if (one.scrollWidth > one.clientWidth) one.setAttribute("tabindex", "0");
  }
}

document.addEventListener("DOMContentLoaded", () => {
  name('.caption[role="heading"]', "aria-level", "2");
  name(".sidebar-drawer", "aria-label", "All pages");
  name(".toc-drawer", "aria-label", "On this page");
  reach();
});
addEventListener("resize", reach);
