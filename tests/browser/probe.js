// Looks at every frame and writes what is wrong with it into #found, a line each; the first line is their number.
(() => {
  const found = [];
  const luminance = ([r, g, b]) => {
    const part = (c) => ((c /= 255) <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
    return 0.2126 * part(r) + 0.7152 * part(g) + 0.0722 * part(b);
  };
  const numbers = (colour) => (colour.match(/[\d.]+/g) || [0, 0, 0, 0]).map(Number);
  const name = (element) =>
    (element.getAttribute("aria-label") || element.getAttribute("title") || element.textContent || "").trim();
  const look = (frame) => {
    const say = (text) => found.push(frame.title + ": " + text);
    const page = frame.contentDocument;
    const view = frame.contentWindow;
    const style = (element) => view.getComputedStyle(element);
    if (frame.errors.length) frame.errors.forEach((error) => say("script error: " + error));
    if (!page.title.trim()) say("no title");
    if (!page.documentElement.lang) say("no language");
    if (page.querySelectorAll("main").length !== 1) say("not one main part");
    if (page.querySelectorAll("h1").length < 1) say("no heading");
    const over = page.documentElement.scrollWidth - view.innerWidth;
    if (over > 0) say("overflows by " + over);
    const ids = [...page.querySelectorAll("[id]")].map((element) => element.id);
    ids.filter((id, at) => ids.indexOf(id) !== at).forEach((id) => say("the id " + id + " twice"));
    page.querySelectorAll("a[href^='#']").forEach((link) => {
      if (!ids.includes(decodeURIComponent(link.getAttribute("href").slice(1)))) say("a link to nothing: " + link.getAttribute("href"));
    });
    page.querySelectorAll("a, button, summary, [tabindex], th").forEach((element) => {
      if (!name(element)) say("no name: " + element.outerHTML.slice(0, 80));
    });
    page.querySelectorAll("[tabindex]").forEach((element) => {
      if (!element.getAttribute("aria-label")) say("no name for what the keyboard reaches: " + element.outerHTML.slice(0, 80));
    });
    page.querySelectorAll(".equation").forEach((equation) => {
      const isPlain = equation.querySelector("blockquote, .untypeset");
      if (!isPlain && !equation.querySelector("math")) say("no MathML in " + (equation.id || equation.textContent.slice(0, 40)));
    });
    page.querySelectorAll("details").forEach((details) => (details.open = true));
    const seen = new Set();
    page.querySelectorAll("body *").forEach((element) => {
      const own = [...element.childNodes].some((node) => node.nodeType === 3 && node.textContent.trim());
      if (!own || ["SCRIPT", "STYLE", "style", "title"].includes(element.tagName)) return;
      let behind = [255, 255, 255];
      for (let at = element; at; at = at.parentElement) {
        const [r, g, b, a] = numbers(style(at).backgroundColor);
        if (a === undefined || a > 0.99) { behind = [r, g, b]; break; }
      }
      const colour = element.namespaceURI.endsWith("svg") ? style(element).fill : style(element).color;
      const [a, b] = [luminance(numbers(colour)), luminance(behind)].sort((x, y) => y - x);
      const contrast = (a + 0.05) / (b + 0.05);
      const key = colour + behind;
      if (contrast < 4.5 && !seen.has(key)) {
        seen.add(key);
        say("contrast " + contrast.toFixed(2) + ": " + element.textContent.trim().slice(0, 40));
      }
    });
  };
  const frames = [...document.querySelectorAll("iframe")];
  frames.forEach((frame) => {
    frame.errors = [];
    const scripts = () => frame.contentDocument && [...frame.contentDocument.querySelectorAll("script")];
    frame.addEventListener("load", () => {
      // A page has no script, so one that is there is run again here to see whether it fails.
      (scripts() || []).forEach((script) => {
        try { frame.contentWindow.eval(script.textContent); } catch (error) { frame.errors.push(error.message); }
      });
    });
  });
  // What the checker of accessibility says of a frame, where its script was put into the page.
  const ask = async (frame) => {
    const axe = frame.contentWindow.axe;
    if (!axe) return;
    const { violations } = await axe.run(frame.contentDocument, { iframes: false, resultTypes: ["violations"] });
    violations.forEach((rule) => {
      const where = rule.nodes.slice(0, 3).map((node) => node.target + " " + node.html.slice(0, 120));
      found.push(`${frame.title}: ${rule.id}, ${rule.nodes.length} times: ${rule.help}: ${where.join(" | ")}`);
    });
  };
  window.addEventListener("load", async () => {
    frames.forEach(look);
    for (const frame of frames) await ask(frame);
    document.getElementById("found").textContent = [frames.length + " frames", ...found].join("\n");
    frames.forEach((frame) => frame.remove());
  });
})();
