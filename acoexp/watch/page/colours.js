// Colours: two ramps whose lightness alone tells the order, and Okabe and Ito's for the colonies.

const RAMPS = {
  // ColorBrewer's YlGnBu, from white
  light: ["#fdfdf8", "#edf8b1", "#c7e9b4", "#7fcdbb", "#41b6c4", "#1d91c0", "#225ea8", "#253494", "#081d58"],
  // mako of seaborn, from nearly black
  dark: ["#0d1114", "#231b33", "#382a54", "#40498e", "#357ba3", "#38aaac", "#79d6ae", "#b9ead0", "#def5e5"],
};
const SERIES = { light: ["#0072b2", "#d55e00", "#009e73", "#cc79a7"], dark: ["#56b4e9", "#e69f00", "#2fc39a", "#e8a5c8"] };
const DASHES = ["", "7 3", "2 3", "9 3 2 3"];

const theme = {
  get name() { return document.documentElement.dataset.theme; },
  set name(name) { document.documentElement.dataset.theme = name; },
  toggle() { this.name = this.name === "dark" ? "light" : "dark"; },
  colour(variable) { return getComputedStyle(document.documentElement).getPropertyValue(variable).trim(); },
  series(place) { return SERIES[this.name][place]; },
};

function parsed(colour) {
  return [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16));
}

/** A colour as a word of an image's buffer. */
function word([red, green, blue], opacity = 255) {
  return (opacity << 24) | (blue << 16) | (green << 8) | red;
}

/** 256 colours as words, interpolated between a ramp's own. */
function rampOf(name) {
  const anchors = RAMPS[name].map(parsed), last = anchors.length - 1;
  return Int32Array.from({ length: 256 }, (_, byte) => {
    const at = (byte / 255) * last, low = Math.min(Math.floor(at), last - 1), share = at - low;
    return word(anchors[low].map((from, i) => Math.round(from + share * (anchors[low + 1][i] - from))));
  });
}

/** Draw the legend's scale. */
function drawScale(canvas, ramp) {
  const image = new ImageData(256, 1);
  new Int32Array(image.data.buffer).set(ramp);
  canvas.getContext("2d").putImageData(image, 0, 0);
}
