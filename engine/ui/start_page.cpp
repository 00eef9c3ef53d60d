#include "engine/ui/start_page.h"

#include <algorithm>

#include "engine/ui/cue_panel.h"
#include "engine/ui/menu_widgets.h"
#include "engine/ui/panels.h"
#include "engine/ui/start_layout.h"
#include "engine/ui/theme.h"

namespace fulcrum::ui {
namespace {

using Part = StartPage::Part;

void draw_scenario(const Canvas& canvas, const StartLayout& layout, const StartPage& page, std::size_t i) {
  const StartPage::Scenario& scenario = page.scenarios[i];
  const auto [at, size] = layout.scenario(i);
  const bool chosen = i == page.chosen;
  const Palette& colours = canvas.colours();
  if (chosen) canvas.box(at, size, with_alpha(colours.accent, 46), 6.0F);
  if (chosen && page.focus == Part::scenario) canvas.frame(at, size, colours.accent, 6.0F, 2.0F);
  const Fonts& fonts = canvas.fonts();
  const float best = scenario.best.empty() ? 0.0F : canvas.measure(fonts.small, scenario.best).x + 8.0F;
  const float room = size.x - 20.0F - best;
  // What cannot be used is told by a word, too.
  const std::string title = scenario.usable ? scenario.title : scenario.title + " (faulty)";
  ImFont* const font = canvas.widest({chosen ? fonts.strong : fonts.body, fonts.small}, title, room);
  const ImU32 colour = !scenario.usable ? colours.bad : chosen ? theme::kText : theme::kSecondary;
  const float y = at.y + (size.y - canvas.measure(font, "A").y) / 2.0F;
  canvas.text(font, {at.x + 10.0F, y}, colour, canvas.fitted(font, title, room));
  canvas.text(fonts.small, {at.x + size.x - 10.0F, at.y + (size.y - 14.0F) / 2.0F}, colours.good,
              scenario.best, Align::right);
}

void draw_list(const Canvas& canvas, const StartLayout& layout, const StartPage& page) {
  if (!layout.has_list()) return;
  const auto [at, size] = layout.list();
  canvas.card(at, size);
  canvas.text(canvas.fonts().number, {at.x + 18.0F, at.y + layout.title_top()}, theme::kText, "Fulcrum");
  for (std::size_t i = layout.first(); i < layout.end(); ++i) draw_scenario(canvas, layout, page, i);
  // More above or below than is seen.
  const float middle = at.x + size.x / 2.0F;
  if (layout.first() > 0) {
    const float y = layout.scenario(layout.first()).at.y - 6.0F;
    canvas.triangle({middle - 6.0F, y + 4.0F}, {middle + 6.0F, y + 4.0F}, {middle, y - 3.0F},
                    theme::kSecondary);
  }
  if (layout.end() < page.scenarios.size()) {
    const float y = at.y + size.y - 8.0F;
    canvas.triangle({middle - 6.0F, y - 3.0F}, {middle, y + 4.0F}, {middle + 6.0F, y - 3.0F},
                    theme::kSecondary);
  }
}

// What is to be done; in its place what went wrong, where nothing else has room for that.
void draw_about(const Canvas& canvas, const StartLayout& layout, const StartPage& page) {
  const Fonts& fonts = canvas.fonts();
  const float left = layout.sheet().at.x + layout.inset(),
              width = layout.sheet().size.x - 2.0F * layout.inset();
  const bool wrong = !page.note.empty() && !layout.has_note_above();
  ImFont* const font = layout.is_dense() ? fonts.small : fonts.body;
  const std::size_t most = layout.about_lines() + (wrong && layout.has_facts() ? 1 : 0);
  float y = layout.about_top();
  for (const std::string& line : canvas.lines(font, wrong ? page.note : page.about, width, most)) {
    canvas.text(font, {left, y}, wrong ? canvas.colours().warn : theme::kText, line);
    y += layout.about_line();
  }
  if (layout.has_facts() && !wrong)
    canvas.text(fonts.small, {left, layout.facts_top()}, theme::kSecondary,
                canvas.fitted(fonts.small, page.facts, width));
}

void draw_sheet(const Canvas& canvas, const StartLayout& layout, const StartPage& page) {
  const auto [at, size] = layout.sheet();
  const Fonts& fonts = canvas.fonts();
  const float left = at.x + layout.inset(), width = size.x - 2.0F * layout.inset();
  canvas.card(at, size);
  if (page.chosen < page.scenarios.size()) {
    const std::string& title = page.scenarios[page.chosen].title;
    ImFont* const font = canvas.widest({fonts.number, fonts.strong, fonts.small}, title, width);
    const float below = (canvas.measure(fonts.number, "A").y - canvas.measure(font, "A").y) / 2.0F;
    canvas.text(font, {left, at.y + layout.title_top() + below}, theme::kText,
                canvas.fitted(font, title, width));
  }
  draw_about(canvas, layout, page);
  for (std::size_t i = layout.first_setting(); i < layout.end_setting(); ++i)
    draw_menu_row(canvas, layout.setting(i), page.settings[i],
                  page.focus == Part::setting && page.index == i);
  const auto button = [&](Part part, const char* word) {
    draw_menu_button(canvas, layout.button(part), word, page.focus == part, part == Part::start);
  };
  button(Part::start, "Start");
  button(Part::settings, "Settings");
  button(Part::end, "End");
  // Half of it would be of no help.
  if (layout.has_help() && canvas.measure(fonts.small, page.help).x <= width)
    canvas.text(fonts.small, {left, layout.help_top()}, theme::kFaint, page.help);
}

void draw_note(const Canvas& canvas, const StartLayout& layout, const StartPage& page) {
  if (page.note.empty() || !layout.has_note_above()) return;
  constexpr float line_high = 20.0F;
  const Area sheet = layout.sheet();
  const Fonts& fonts = canvas.fonts();
  const float width = sheet.size.x - 2.0F * layout.inset();
  const float room = sheet.at.y - 2.0F * layout.margin() - 20.0F;
  const std::vector<std::string> lines =
      canvas.lines(fonts.body, page.note, width, static_cast<std::size_t>(room / line_high));
  const ImVec2 size{sheet.size.x, 20.0F + line_high * static_cast<float>(lines.size())};
  const ImVec2 at{sheet.at.x, sheet.at.y - layout.margin() / 2.0F - size.y};
  canvas.card(at, size);
  canvas.frame(at, size, canvas.colours().warn, theme::kRounding, 1.5F);
  float y = at.y + 10.0F;
  for (const std::string& line : lines) {
    canvas.text(fonts.body, {at.x + layout.inset(), y}, theme::kText, line);
    y += line_high;
  }
}

}  // namespace

void draw_start(const Canvas& canvas, const StartPage& page) {
  if (page.tested) {
    draw_device_panel(canvas, *page.tested);
    return;
  }
  const StartLayout layout(page, canvas.width(), canvas.height());
  draw_list(canvas, layout, page);
  draw_sheet(canvas, layout, page);
  draw_note(canvas, layout, page);
}

std::optional<StartHit> start_hit(const StartPage& page, render::Extent picture, const Look& look, double x,
                                  double y) {
  const PanelPoint at = panel_point(picture, look, x, y);
  const StartLayout layout(page, at.width, at.height);
  const ImVec2 point{at.x, at.y};
  if (layout.has_list())
    for (std::size_t i = layout.first(); i < layout.end(); ++i)
      if (holds(layout.scenario(i), point)) return StartHit{Part::scenario, i};
  for (std::size_t i = layout.first_setting(); i < layout.end_setting(); ++i)
    if (const Area row = layout.setting(i); holds(row, point))
      return StartHit{Part::setting, i, page.settings[i].written ? 0 : side_of(row, point)};
  for (const Part part : {Part::start, Part::settings, Part::end})
    if (holds(layout.button(part), point)) return StartHit{part, 0};
  return std::nullopt;
}

}  // namespace fulcrum::ui
