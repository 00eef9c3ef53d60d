#include "engine/report/page.h"

#include "engine/report/markup.h"

namespace fulcrum::report {
namespace {

// Hues after Okabe and Ito; in the dark the blue and the ink are lighter. Shades: blue to orange, which
// differ in lightness too.
constexpr const char* kStyle = R"(
:root { color-scheme: light dark;
  --paper: #ffffff; --ink: #1b1d21; --soft: #5a606b; --rule: #d9dce1; --wash: #f4f5f7;
  --h0: #0072b2; --h1: #d55e00; --h2: #009e73; --h3: #b0528c; --h4: #b87f00; --h5: #3b9bd0; --h6: #6b6f76;
  --cool4: #3f7fb5; --cool3: #74a5cf; --cool2: #a6c6e2; --cool1: #d3e3f1; --even: #eeeeee;
  --warm1: #fbe3c6; --warm2: #f5c48d; --warm3: #e89c55; --warm4: #cf7426; }
@media (prefers-color-scheme: dark) { :root {
  --paper: #15171b; --ink: #e8eaee; --soft: #a3a9b4; --rule: #363b44; --wash: #1e2127;
  --h0: #5db4ec; --h1: #ff8a3d; --h2: #2fc99a; --h3: #e58bc0; --h4: #f0b429; --h5: #93d1f7; --h6: #a9afb9;
  --cool4: #2f6f9f; --cool3: #295c84; --cool2: #234866; --cool1: #1f3549; --even: #2a2d33;
  --warm1: #45341f; --warm2: #644620; --warm3: #865820; --warm4: #a9691d; } }
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 54rem; padding: 2rem 1.25rem 4rem; background: var(--paper); color: var(--ink);
  font: 16px/1.55 system-ui, "Segoe UI", Roboto, "DejaVu Sans", sans-serif; }
h1 { font-size: 1.7rem; line-height: 1.25; margin: 0 0 1rem; }
h2 { font-size: 1.2rem; margin: 2.4rem 0 .6rem; }
p { margin: .6rem 0; }
pre { background: var(--wash); border: 1px solid var(--rule); border-radius: 6px; padding: .6rem .8rem;
  overflow-x: auto; font: 14px/1.4 ui-monospace, "DejaVu Sans Mono", monospace; }
.note { border-left: 4px solid var(--h1); background: var(--wash); padding: .6rem .9rem; border-radius: 0 6px 6px 0; }
dl { display: grid; grid-template-columns: minmax(9rem, max-content) 1fr; gap: .3rem 1.2rem; font-size: .95rem; }
dt { color: var(--soft); } dd { margin: 0; }
figure { margin: 1.2rem 0; break-inside: avoid; }
figure > b { display: block; margin-bottom: .4rem; }
figcaption { color: var(--soft); font-size: .9rem; margin-top: .3rem; }
.pictures { display: flex; flex-wrap: wrap; gap: .8rem; }
.pictures div { flex: 1 1 24rem; } .pictures img { width: 100%; height: auto; display: block; }
.scroll { overflow-x: auto; margin: 1rem 0; }
table { border-collapse: collapse; font-size: .9rem; font-variant-numeric: tabular-nums; }
th, td { padding: .3rem .9rem .3rem 0; text-align: right; border-bottom: 1px solid var(--rule);
  vertical-align: top; }
th:first-child, td:first-child { text-align: left; }
th { color: var(--soft); font-weight: 600; vertical-align: bottom; }
.reasons td:not(:last-child) { white-space: nowrap; }
.reasons th:last-child, .reasons td:last-child { text-align: left; }
@media print { body { max-width: none; padding: 0; font-size: 11pt; } h2 { break-after: avoid; } tr { break-inside: avoid; } }
svg.plot { width: 100%; height: auto; display: block; font: 12.5px system-ui, "DejaVu Sans", sans-serif; }
.words text { fill: var(--ink); } .words .axis { font-weight: 600; }
.label { fill: var(--ink); stroke: var(--paper); stroke-width: 3.5px; paint-order: stroke; stroke-linejoin: round; }
.grid path { stroke: var(--rule); fill: none; stroke-opacity: .7; }
.frame { stroke: var(--soft); fill: none; }
.line { fill: none; stroke: var(--hue); stroke-width: 2px; stroke-linejoin: round; }
.strong { stroke-width: 3.5px; } .dashed { stroke-dasharray: 8 5; } .dotted { stroke-dasharray: 2 4; }
.line.faint { stroke-width: 1px; stroke-opacity: .45; } .fill.faint { fill-opacity: .6; stroke: none; }
.fill { fill: var(--hue); stroke: var(--paper); stroke-width: 1.2px; }
.stroke { fill: none; stroke: var(--hue); stroke-width: 2.2px; }
.h0 { --hue: var(--h0); } .h1 { --hue: var(--h1); } .h2 { --hue: var(--h2); } .h3 { --hue: var(--h3); }
.h4 { --hue: var(--h4); } .h5 { --hue: var(--h5); } .h6 { --hue: var(--h6); } .ink { --hue: var(--ink); }
.cool4 { fill: var(--cool4); } .cool3 { fill: var(--cool3); } .cool2 { fill: var(--cool2); }
.cool1 { fill: var(--cool1); } .even { fill: var(--even); } .warm1 { fill: var(--warm1); }
.warm2 { fill: var(--warm2); } .warm3 { fill: var(--warm3); } .warm4 { fill: var(--warm4); }
.disc { clip-path: circle(50%) fill-box; }
.key { stroke: var(--soft); stroke-width: .6px; }
)";

std::string row(const std::vector<std::string>& cells, const char* tag) {
  std::string out = "<tr>";
  for (const std::string& cell : cells)
    out.append("<").append(tag).append(">").append(escaped(cell)).append("</").append(tag).append(">");
  return out + "</tr>\n";
}

}  // namespace

void Page::heading(std::string_view text) {
  body_ += "<h2>" + escaped(text) + "</h2>\n";
}

void Page::paragraph(std::string_view text) {
  body_ += "<p>" + escaped(text) + "</p>\n";
}

void Page::note(std::string_view text) {
  body_ += "<p class=\"note\">" + escaped(text) + "</p>\n";
}

void Page::command(std::string_view text) {
  body_ += "<pre>" + escaped(text) + "</pre>\n";
}

void Page::facts(const Facts& facts) {
  body_ += "<dl>\n";
  for (const auto& [name, what] : facts)
    body_ += "<dt>" + escaped(name) + "</dt><dd>" + escaped(what) + "</dd>\n";
  body_ += "</dl>\n";
}

void Page::table(const Table& table) {
  body_ += table.ends_in_words ? "<div class=\"scroll\"><table class=\"reasons\">\n<thead>"
                               : "<div class=\"scroll\"><table>\n<thead>";
  body_ += row(table.head, "th") + "</thead>\n<tbody>";
  for (const std::vector<std::string>& cells : table.rows) body_ += row(cells, "td");
  body_ += "</tbody></table></div>\n";
}

void Page::figure(std::string_view title, std::string_view drawn, std::string_view caption) {
  body_ += "<figure><b>" + escaped(title) + "</b>\n";
  body_ += drawn;
  body_ += "\n<figcaption>" + escaped(caption) + "</figcaption></figure>\n";
}

void Page::plot(const Plot& plot, std::string_view caption) {
  figure(plot.title, svg(plot), caption);
}

void Page::panels(const Panels& panels, std::string_view caption) {
  figure(panels.title, svg(panels), caption);
}

void Page::pictures(const std::vector<NamedPng>& pictures, std::string_view caption) {
  body_ += "<figure><div class=\"pictures\">\n";
  for (const NamedPng& picture : pictures) {
    const std::string name = escaped(picture.name);
    body_.append("<div><b>").append(name).append("</b><img alt=\"").append(name);
    body_.append("\" src=\"data:image/png;base64,").append(base64(picture.bytes)).append("\"/></div>\n");
  }
  body_ += "</div>\n<figcaption>" + escaped(caption) + "</figcaption></figure>\n";
}

std::string Page::html() const {
  const std::string title = escaped(title_);
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head><meta charset=\"utf-8\"/>"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n<title>" +
         title + "</title>\n<style>" + kStyle + "</style></head>\n<body>\n<h1>" + title + "</h1>\n" + body_ +
         "</body>\n</html>\n";
}

}  // namespace fulcrum::report
