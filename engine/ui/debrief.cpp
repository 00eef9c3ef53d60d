// What came of a trial: a table in the middle of the picture.

#include <algorithm>

#include "engine/ui/panels.h"
#include "engine/ui/theme.h"

namespace fulcrum::ui {
namespace {

constexpr float kHead = 64.0F;
constexpr float kRow = 23.0F;
constexpr float kFoot = 46.0F;
constexpr float kInset = 26.0F;
constexpr float kColumn = 22.0F;  // between columns

using Row = Debrief::Row;

// Columns: theme units that the widest of each takes.
struct Widths {
  float name = 0.0F, value = 0.0F, points = 0.0F, reason = 0.0F;
};

Widths widths_of(const Canvas& canvas, const std::vector<Row>& rows) {
  const Fonts& fonts = canvas.fonts();
  Widths widths;
  for (const Row& row : rows) {
    widths.name = std::max(widths.name, canvas.measure(fonts.body, row.name).x);
    widths.value = std::max(widths.value, canvas.measure(fonts.strong, row.value).x + kColumn);
    if (row.points)
      widths.points = std::max(widths.points, canvas.measure(fonts.strong, *row.points).x + kColumn);
    if (!row.reason.empty())
      widths.reason = std::max(widths.reason, canvas.measure(fonts.small, row.reason).x + kColumn);
  }
  return widths;
}

// As many as the picture has room for, and one that says how many more there are.
std::vector<Row> shown_rows(const std::vector<Row>& rows, float height) {
  const float room = height - 2.0F * theme::kMargin - kHead - kFoot;
  const auto most = static_cast<std::size_t>(std::max(2.0F, room / kRow));
  if (rows.size() <= most) return rows;
  std::vector<Row> shown(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(most - 1));
  shown.push_back({"and " + std::to_string(rows.size() - shown.size()) + " more", ""});
  return shown;
}

}  // namespace

void draw_debrief(const Canvas& canvas, const OverlayState& state) {
  if (!state.debrief) return;
  const Fonts& fonts = canvas.fonts();
  const float height = canvas.height() - timeline_height(state);
  const std::vector<Row> rows = shown_rows(state.debrief->rows, height);
  Widths widths = widths_of(canvas, rows);
  const float most = canvas.width() - 2.0F * theme::kMargin - 2.0F * kInset;
  // Where all of it is too wide a name that is long is cut, and then a reason.
  const float rest = widths.value + widths.points;
  widths.name = std::min(widths.name, std::max(0.5F * (most - rest), most - rest - widths.reason));
  widths.reason = std::min(widths.reason, std::max(0.0F, most - rest - widths.name));
  const float table = widths.name + rest + widths.reason;
  const float words = std::max(canvas.measure(fonts.number, state.debrief->title).x,
                               canvas.measure(fonts.body, state.debrief->foot).x);
  const ImVec2 size{std::clamp(std::max({table, words, 300.0F}), 0.0F, most) + 2.0F * kInset,
                    kHead + static_cast<float>(rows.size()) * kRow + kFoot};
  const ImVec2 at{(canvas.width() - size.x) / 2.0F, (height - size.y) / 2.0F};
  const float left = at.x + kInset, width = size.x - 2.0F * kInset;
  canvas.box(at, size, IM_COL32(12, 15, 19, 232), theme::kRounding);
  canvas.frame(at, size, theme::kCardEdge, theme::kRounding, 1.0F);
  canvas.text(fonts.number, {left, at.y + 18.0F}, theme::kText,
              canvas.fitted(fonts.number, state.debrief->title, width));
  float y = at.y + kHead;
  for (const Row& row : rows) {
    float x = left + widths.name;
    canvas.text(fonts.body, {left, y}, theme::kSecondary, canvas.fitted(fonts.body, row.name, widths.name));
    x += widths.value;
    canvas.text(fonts.strong, {x, y}, theme::kText, row.value, Align::right);
    x += widths.points;
    if (row.points) canvas.text(fonts.strong, {x, y}, theme::kAccent, *row.points, Align::right);
    if (widths.reason > kColumn)
      canvas.text(fonts.small, {x + kColumn, y + 2.0F}, theme::kSecondary,
                  canvas.fitted(fonts.small, row.reason, widths.reason - kColumn));
    y += kRow;
  }
  canvas.line({left, y + 7.0F}, {left + width, y + 7.0F}, theme::kCardEdge, 1.0F);
  canvas.text(fonts.body, {left, y + 16.0F}, theme::kSecondary,
              canvas.fitted(fonts.body, state.debrief->foot, width));
}

}  // namespace fulcrum::ui
