// What a page looks like after it is loaded, for site_check.py: sent to the outer page.
addEventListener("load", async () => {
  const root = document.documentElement, images = [...document.images];
  const beyond = [...document.querySelectorAll("body *")].filter((part) =>
    !part.parentElement.closest(".wide") && part.getBoundingClientRect().right > root.clientWidth + 1);
  const scrolling = [...document.querySelectorAll(".wide")].filter((part) => part.scrollWidth > part.clientWidth + 1);
  const result = {
    width: root.clientWidth,
    scroll: root.scrollWidth,
    beyond: beyond.slice(0, 5).map((part) => part.outerHTML.slice(0, 80)),
    scrolling: scrolling.map((part) => part.textContent.trim().slice(0, 60)),
    broken: images.filter((image) => !image.naturalWidth).map((image) => image.alt || image.src.slice(0, 80)),
    silent: images.filter((image) => !image.alt.trim()).map((image) => image.src.slice(0, 80)),
    fetched: performance.getEntriesByType("resource").map((entry) => entry.name).filter((name) => !/^data:/.test(name)),
    barriers: [],
  };
  if (window.axe) {
    const found = (await axe.run(document, { iframes: false })).violations;
    const serious = found.filter((each) => ["serious", "critical"].includes(each.impact));
    result.barriers = serious.map((each) => `${each.help}: ${each.nodes[0].html.slice(0, 80)}`);
  }
  parent.postMessage(JSON.stringify(result), "*");
});
