// Elements and text. All text of a report reaches the page through here, as text:
// nothing a report holds is ever read as markup.

/** An element with attributes and children (strings become text nodes). */
function element(tag, attributes = {}, ...children) {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value !== null && value !== undefined) node.setAttribute(name, value);
  }
  node.append(...children.filter((child) => child !== null && child !== undefined));
  return node;
}

/** Text for the drawing library, which would read tags, entities and %{...} in it. */
function drawnText(text) {
  return text
    .replaceAll("&", "&amp;")
    .replaceAll("<", "&lt;")
    .replaceAll(">", "&gt;")
    .replaceAll("%{", "%\u200b{");
}

/** "(mm)"; a dimensionless quantity, unit "1", has "(–)"; no unit, nothing. */
function unitText(unit) {
  if (unit === "") return "";
  return unit === "1" ? "(–)" : `(${unit})`;
}

function axisText(axis) {
  return `${axis.quantity} ${unitText(axis.unit)}`;
}

/** " N", " %" or nothing, to stand behind a number. */
function unitSuffix(unit) {
  return unit === "1" || unit === "" ? "" : ` ${unit}`;
}

/** A box in which what is too wide scrolls, within reach of the keyboard. */
function scrollBox(label, content) {
  return element("div", { class: "scroll", role: "region", tabindex: "0", "aria-label": label }, content);
}

/** Heading and caption around a figure, table or matrix. */
function captioned(kind, record, ...content) {
  const caption = element("figcaption", {}, element("h3", {}, record.title, " ", originTag(record.origin)));
  if (record.caption) caption.append(element("p", {}, record.caption));
  return element("figure", { class: kind }, caption, ...content);
}
