#include "engine/ui/start_page.h"

#include <algorithm>

#include "engine/ui/cue_panel.h"
#include "engine/ui/panels.h"
#include "engine/ui/theme.h"

namespace fulcrum::ui {
namespace {

using Part = StartPage::Part;

constexpr float kListWidth = 310.0F;
constexpr float kListHead = 66.0F;
constexpr float kListRow = 40.0F;
constexpr float kInset = 24.0F;
constexpr float kSheetMost = 600.0F;  // width
constexpr float kSheetLeast = 320.0F;
constexpr float kAboutTop = 58.0F;
constexpr float kAboutLine = 20.0F;
constexpr std::size_t kAboutLines = 3;
constexpr float kFactsTop = kAboutTop + kAboutLine * static_cast<float>(kAboutLines) + 4.0F;
constexpr float kSettingsTop = kFactsTop + 32.0F;
constexpr float kSettingRow = 34.0F;
constexpr float kArrow = 30.0F;  // width of what is pressed
constexpr float kNameWidth = 120.0F;
constexpr float kButton = 38.0F;
constexpr float kButtonWidth = 150.0F;

bool holds(const Area& area, ImVec2 point) {
  return point.x >= area.at.x && point.y >= area.at.y && point.x < area.at.x + area.size.x &&
         point.y < area.at.y + area.size.y;
}

// Where everything is, in theme units: the same for drawing and for the pointer.
class Layout {
public:
  Layout(const StartPage& page, float width, float height) : page_(page), width_(width), height_(height) {}

  Area list() const {
    const float bottom = narrow() ? sheet().at.y : height_;
    return {{theme::kMargin, theme::kMargin}, {list_width(), bottom - 2.0F * theme::kMargin}};
  }

  // As many scenarios as there is room for, those about the chosen one.
  std::size_t first() const {
    const std::size_t most = room();
    if (page_.scenarios.size() <= most) return 0;
    const std::size_t middle = most / 2;
    const std::size_t wanted = page_.chosen > middle ? page_.chosen - middle : 0;
    return std::min(wanted, page_.scenarios.size() - most);
  }
  std::size_t end() const { return std::min(page_.scenarios.size(), first() + room()); }

  Area scenario(std::size_t i) const {
    const float y = list().at.y + kListHead + kListRow * static_cast<float>(i - first());
    return {{list().at.x + 8.0F, y}, {list_width() - 16.0F, kListRow - 4.0F}};
  }

  Area sheet() const {
    const float left = narrow() ? theme::kMargin : 2.0F * theme::kMargin + kListWidth;
    const float wide = std::min(kSheetMost, width_ - left - theme::kMargin);
    const float high =
        kSettingsTop + kSettingRow * static_cast<float>(page_.settings.size()) + kButton + 32.0F;
    return {{left, height_ - theme::kMargin - high}, {wide, high}};
  }

  Area setting(std::size_t i) const {
    const Area in = sheet();
    return {{in.at.x + kInset - 10.0F, in.at.y + kSettingsTop + kSettingRow * static_cast<float>(i)},
            {in.size.x - 2.0F * kInset + 20.0F, kSettingRow - 3.0F}};
  }
  Area arrow(std::size_t i, int side) const {
    const Area row = setting(i);
    const float left = side < 0 ? row.at.x + kNameWidth : row.at.x + row.size.x - kArrow;
    return {{left, row.at.y}, {kArrow, row.size.y}};
  }

  Area button(Part part) const {
    const Area in = sheet();
    const float y = in.at.y + in.size.y - kButton - 18.0F;
    const float left = in.at.x + kInset + (part == Part::start ? 0.0F : kButtonWidth + 12.0F);
    return {{left, y}, {part == Part::start ? kButtonWidth : 100.0F, kButton}};
  }

private:
  // Then the sheet is below the list.
  bool narrow() const { return width_ < kListWidth + kSheetLeast + 3.0F * theme::kMargin; }
  float list_width() const { return narrow() ? width_ - 2.0F * theme::kMargin : kListWidth; }
  std::size_t room() const {
    return static_cast<std::size_t>(std::max(1.0F, (list().size.y - kListHead - 8.0F) / kListRow));
  }

  const StartPage& page_;
  float width_, height_;
};

void draw_scenario(const Canvas& canvas, const Layout& layout, const StartPage& page, std::size_t i) {
  const StartPage::Scenario& scenario = page.scenarios[i];
  const auto [at, size] = layout.scenario(i);
  const bool chosen = i == page.chosen;
  if (chosen) canvas.box(at, size, IM_COL32(84, 164, 255, 46), 6.0F);
  if (chosen && page.focus == Part::scenario) canvas.frame(at, size, theme::kAccent, 6.0F, 2.0F);
  const Fonts& fonts = canvas.fonts();
  const float best = scenario.best.empty() ? 0.0F : canvas.measure(fonts.small, scenario.best).x + 10.0F;
  ImFont* const font = chosen ? fonts.strong : fonts.body;
  const ImU32 colour = !scenario.usable ? theme::kBad : chosen ? theme::kText : theme::kSecondary;
  const float y = at.y + (size.y - canvas.measure(font, "A").y) / 2.0F;
  canvas.text(font, {at.x + 12.0F, y}, colour, canvas.fitted(font, scenario.title, size.x - 24.0F - best));
  canvas.text(fonts.small, {at.x + size.x - 12.0F, y + 2.0F}, theme::kGood, scenario.best, Align::right);
}

void draw_list(const Canvas& canvas, const Layout& layout, const StartPage& page) {
  const auto [at, size] = layout.list();
  canvas.card(at, size);
  canvas.text(canvas.fonts().number, {at.x + 20.0F, at.y + 18.0F}, theme::kText, "Fulcrum");
  for (std::size_t i = layout.first(); i < layout.end(); ++i) draw_scenario(canvas, layout, page, i);
  // More above or below than is seen.
  const float middle = at.x + size.x / 2.0F;
  if (layout.first() > 0) {
    const float y = at.y + kListHead - 8.0F;
    canvas.triangle({middle - 6.0F, y + 4.0F}, {middle + 6.0F, y + 4.0F}, {middle, y - 3.0F},
                    theme::kSecondary);
  }
  if (layout.end() < page.scenarios.size()) {
    const float y = at.y + size.y - 8.0F;
    canvas.triangle({middle - 6.0F, y - 3.0F}, {middle, y + 4.0F}, {middle + 6.0F, y - 3.0F},
                    theme::kSecondary);
  }
}

void draw_arrow(const Canvas& canvas, const Area& area, int side, ImU32 colour) {
  const float x = area.at.x + area.size.x / 2.0F, y = area.at.y + area.size.y / 2.0F;
  const auto direction = static_cast<float>(side);
  canvas.triangle({x + 4.0F * direction, y}, {x - 3.0F * direction, y - 6.0F},
                  {x - 3.0F * direction, y + 6.0F}, colour);
}

void draw_setting(const Canvas& canvas, const Layout& layout, const StartPage& page, std::size_t i) {
  const StartPage::Setting& setting = page.settings[i];
  const auto [at, size] = layout.setting(i);
  const bool focused = page.focus == Part::setting && page.index == i;
  if (focused) canvas.frame(at, size, theme::kAccent, 6.0F, 2.0F);
  const Fonts& fonts = canvas.fonts();
  const float y = at.y + (size.y - canvas.measure(fonts.body, "A").y) / 2.0F;
  canvas.text(fonts.body, {at.x + 10.0F, y}, theme::kSecondary, setting.name);
  const ImU32 colour = focused ? theme::kAccent : theme::kFaint;
  if (!setting.written)
    for (const int side : {-1, 1}) draw_arrow(canvas, layout.arrow(i, side), side, colour);
  const float left = at.x + kNameWidth + kArrow, right = at.x + size.x - kArrow;
  const std::string shown = canvas.fitted(fonts.strong, setting.value, right - left - 8.0F);
  const float middle = (left + right) / 2.0F;
  canvas.text(fonts.strong, {middle, y}, theme::kText, shown, Align::centre);
  if (setting.written) {
    const float caret = middle + canvas.measure(fonts.strong, shown).x / 2.0F + 3.0F;
    canvas.line({caret, at.y + 7.0F}, {caret, at.y + size.y - 7.0F}, theme::kAccent, 2.0F);
  }
}

void draw_button(const Canvas& canvas, const Area& area, const char* word, bool focused, bool leads) {
  canvas.box(area.at, area.size, leads ? IM_COL32(38, 104, 190, 255) : IM_COL32(60, 68, 78, 255), 7.0F);
  if (focused) canvas.frame(area.at, area.size, theme::kText, 7.0F, 2.0F);
  ImFont* const font = canvas.fonts().strong;
  const float y = area.at.y + (area.size.y - canvas.measure(font, "A").y) / 2.0F;
  canvas.text(font, {area.at.x + area.size.x / 2.0F, y}, theme::kText, word, Align::centre);
}

void draw_sheet(const Canvas& canvas, const Layout& layout, const StartPage& page) {
  const auto [at, size] = layout.sheet();
  const Fonts& fonts = canvas.fonts();
  const float left = at.x + kInset, width = size.x - 2.0F * kInset;
  canvas.card(at, size);
  if (page.chosen < page.scenarios.size())
    canvas.text(fonts.number, {left, at.y + 18.0F}, theme::kText,
                canvas.fitted(fonts.number, page.scenarios[page.chosen].title, width));
  float y = at.y + kAboutTop;
  std::vector<std::string> lines = canvas.wrapped(fonts.body, page.about, width);
  if (lines.size() > kAboutLines) {
    lines.resize(kAboutLines);
    lines.back() = canvas.fitted(fonts.body, lines.back() + " ...", width);
  }
  for (const std::string& line : lines) {
    canvas.text(fonts.body, {left, y}, theme::kText, line);
    y += kAboutLine;
  }
  canvas.text(fonts.small, {left, at.y + kFactsTop}, theme::kSecondary,
              canvas.fitted(fonts.small, page.facts, width));
  for (std::size_t i = 0; i < page.settings.size(); ++i) draw_setting(canvas, layout, page, i);
  draw_button(canvas, layout.button(Part::start), "Start", page.focus == Part::start, true);
  const Area end = layout.button(Part::end);
  draw_button(canvas, end, "End", page.focus == Part::end, false);
  const float help = end.at.x + end.size.x + 16.0F;
  if (canvas.measure(fonts.small, page.help).x <= left + width - help)  // half of it would be of no help
    canvas.text(fonts.small, {help, end.at.y + 12.0F}, theme::kFaint, page.help);
}

void draw_note(const Canvas& canvas, const Layout& layout, const StartPage& page) {
  if (page.note.empty()) return;
  const Area sheet = layout.sheet();
  const Fonts& fonts = canvas.fonts();
  const float width = sheet.size.x - 2.0F * kInset;
  const float room = sheet.at.y - 2.0F * theme::kMargin - 20.0F;
  std::vector<std::string> lines = canvas.wrapped(fonts.body, page.note, width);
  const auto most = static_cast<std::size_t>(std::max(1.0F, room / kAboutLine));
  if (lines.size() > most) lines.resize(most);
  const ImVec2 size{sheet.size.x, 20.0F + kAboutLine * static_cast<float>(lines.size())};
  const ImVec2 at{sheet.at.x, sheet.at.y - theme::kMargin / 2.0F - size.y};
  canvas.card(at, size);
  canvas.frame(at, size, theme::kWarn, theme::kRounding, 1.5F);
  float y = at.y + 10.0F;
  for (const std::string& line : lines) {
    canvas.text(fonts.body, {at.x + kInset, y}, theme::kText, line);
    y += kAboutLine;
  }
}

}  // namespace

void draw_start(const Canvas& canvas, const StartPage& page) {
  const Layout layout(page, canvas.width(), canvas.height());
  draw_list(canvas, layout, page);
  draw_sheet(canvas, layout, page);
  draw_note(canvas, layout, page);
}

std::optional<StartHit> start_hit(const StartPage& page, render::Extent picture, double x, double y) {
  const PanelPoint at = panel_point(picture, x, y);
  const float height = static_cast<float>(picture.height) / overlay_scale(picture.height);
  const Layout layout(page, at.width, height);
  const ImVec2 point{at.x, at.y};
  for (std::size_t i = layout.first(); i < layout.end(); ++i)
    if (holds(layout.scenario(i), point)) return StartHit{Part::scenario, i};
  for (std::size_t i = 0; i < page.settings.size(); ++i) {
    for (const int side : {-1, 1})
      if (!page.settings[i].written && holds(layout.arrow(i, side), point))
        return StartHit{Part::setting, i, side};
    if (holds(layout.setting(i), point)) return StartHit{Part::setting, i};
  }
  for (const Part part : {Part::start, Part::end})
    if (holds(layout.button(part), point)) return StartHit{part, 0};
  return std::nullopt;
}

}  // namespace fulcrum::ui
