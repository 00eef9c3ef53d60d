// What came of a trial: a table in the middle of the picture. In a low one its rows are closer, then in two
// columns and without reasons.

#include <algorithm>
#include <span>

#include "engine/ui/columns.h"
#include "engine/ui/panels.h"
#include "engine/ui/theme.h"

namespace fulcrum::ui {
namespace {

using Row = Debrief::Row;

constexpr float kBetween = 20.0F;  // between tables
constexpr float kLeastTable = 190.0F;

// How the rows are set.
struct Form {
  bool dense, reasons;
  std::size_t tables;

  float head() const { return dense ? 44.0F : 64.0F; }
  float row() const { return dense ? 18.0F : 23.0F; }
  float foot() const { return dense ? 32.0F : 46.0F; }
  float inset() const { return dense ? 14.0F : 26.0F; }
  float gutter() const { return reasons ? 18.0F : 9.0F; }  // between columns
};

constexpr Form kForms[] = {{false, true, 1}, {true, true, 1}, {true, false, 2}};
constexpr Form kNarrow = {true, false, 1};

// Columns: theme units that the widest of each takes.
struct Widths {
  float name = 0.0F, value = 0.0F, points = 0.0F, reason = 0.0F;
  float whole() const { return name + value + points + reason; }
};

// All that is laid out.
struct Table {
  Form form{};
  std::vector<Row> rows;
  std::size_t rows_each = 0;   // of a table
  std::vector<Widths> widths;  // of each table
  Area area;
};

ImFont* name_font(const Canvas& canvas, const Form& form) {
  return form.dense ? canvas.fonts().small : canvas.fonts().body;
}
ImFont* value_font(const Canvas& canvas, const Form& form) {
  return form.dense ? canvas.fonts().small : canvas.fonts().strong;
}

// Without what explains it, where there is no room for reasons either.
std::string name_of(const Row& row, const Form& form) {
  return form.reasons ? row.name : row.name.substr(0, row.name.find(" ("));
}

Widths widths_of(const Canvas& canvas, std::span<const Row> rows, const Form& form) {
  ImFont* const value = value_font(canvas, form);
  const float gutter = form.gutter();
  Widths widths;
  for (const Row& row : rows) {
    widths.name = std::max(widths.name, canvas.measure(name_font(canvas, form), name_of(row, form)).x);
    widths.value = std::max(widths.value, canvas.measure(value, row.value).x + gutter);
    if (row.points) widths.points = std::max(widths.points, canvas.measure(value, *row.points).x + gutter);
    if (form.reasons && !row.reason.empty())
      widths.reason = std::max(widths.reason, canvas.measure(canvas.fonts().small, row.reason).x + gutter);
  }
  return widths;
}

// As many as there is room for, and one that says how many more there are.
std::vector<Row> shown_rows(const std::vector<Row>& rows, std::size_t most) {
  if (rows.size() <= most) return rows;
  std::vector<Row> shown(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(most - 1));
  shown.push_back({"and " + std::to_string(rows.size() - shown.size()) + " more", ""});
  return shown;
}

float all_wide(const Table& table) {
  float wide = (static_cast<float>(table.widths.size()) - 1.0F) * kBetween;
  for (const Widths& widths : table.widths) wide += widths.whole();
  return wide;
}

// Into a room; false: not all of it fits.
bool lay_out(Table& table, const Canvas& canvas, const std::vector<Row>& rows, const Form& form,
             const ImVec2& room) {
  table.form = form;
  const float high = room.y - form.head() - form.foot();
  const auto most = static_cast<std::size_t>(std::max(1.0F, high / form.row())) * form.tables;
  table.rows = shown_rows(rows, std::max<std::size_t>(most, 2));
  table.rows_each = (table.rows.size() + form.tables - 1) / form.tables;
  table.widths.clear();
  const std::span<const Row> all = table.rows;
  for (std::size_t first = 0; first < all.size(); first += table.rows_each)
    table.widths.push_back(
        widths_of(canvas, all.subspan(first, std::min(table.rows_each, all.size() - first)), form));
  return table.rows.size() == rows.size() && all_wide(table) <= room.x - 2.0F * form.inset();
}

// Where all of it is too wide a name that is long is cut, and then a reason.
void narrow(Widths& widths, float most) {
  const float rest = widths.value + widths.points;
  widths.name = std::min(widths.name, std::max(0.5F * (most - rest), most - rest - widths.reason));
  widths.reason = std::min(widths.reason, std::max(0.0F, most - rest - widths.name));
}

Table table_of(const Canvas& canvas, const OverlayState& state) {
  Table table;
  if (!state.debrief) return table;
  const float margin = margin_of(canvas.height());
  const Area timeline = columns_of(state, canvas.width(), canvas.height()).timeline;
  const float bottom = timeline.size.x > 0.0F ? timeline.at.y - kPanelGap : canvas.height() - margin;
  const ImVec2 room{canvas.width() - 2.0F * margin, bottom - margin};
  bool fits = false;
  for (const Form& form : kForms) {
    fits = lay_out(table, canvas, state.debrief->rows, form, room);
    if (fits) break;
  }
  const bool two_fit = room.x - 2.0F * table.form.inset() >= 2.0F * kLeastTable + kBetween;
  if (!fits && !two_fit) lay_out(table, canvas, state.debrief->rows, kNarrow, room);
  const Form& form = table.form;
  const float most = room.x - 2.0F * form.inset();
  const auto tables = static_cast<float>(form.tables);
  if (all_wide(table) > most)
    for (Widths& widths : table.widths) narrow(widths, (most - (tables - 1.0F) * kBetween) / tables);
  const Fonts& fonts = canvas.fonts();
  const float words =
      std::max(canvas.measure(form.dense ? fonts.strong : fonts.number, state.debrief->title).x,
               canvas.measure(form.dense ? fonts.small : fonts.body, state.debrief->foot).x);
  const ImVec2 size{std::clamp(std::max({all_wide(table), words, 300.0F}), 0.0F, most) + 2.0F * form.inset(),
                    form.head() + static_cast<float>(table.rows_each) * form.row() + form.foot()};
  table.area = {{(canvas.width() - size.x) / 2.0F, std::max(0.0F, margin + (room.y - size.y) / 2.0F)}, size};
  return table;
}

void draw_row(const Canvas& canvas, ImVec2 at, const Row& row, const Form& form, const Widths& widths) {
  ImFont* const name = name_font(canvas, form);
  ImFont* const value = value_font(canvas, form);
  float x = at.x + widths.name;
  canvas.text(name, at, theme::kSecondary, canvas.fitted(name, name_of(row, form), widths.name));
  x += widths.value;
  canvas.text(value, {x, at.y}, theme::kText, row.value, Align::right);
  x += widths.points;
  if (row.points) canvas.text(value, {x, at.y}, canvas.colours().accent, *row.points, Align::right);
  ImFont* const small = canvas.fonts().small;
  if (widths.reason > form.gutter())
    canvas.text(small, {x + form.gutter(), at.y + (form.dense ? 0.0F : 2.0F)}, theme::kSecondary,
                canvas.fitted(small, row.reason, widths.reason - form.gutter()));
}

}  // namespace

Area debrief_area(const Canvas& canvas, const OverlayState& state) {
  return table_of(canvas, state).area;
}

void draw_debrief(const Canvas& canvas, const OverlayState& state) {
  if (!state.debrief) return;
  const Fonts& fonts = canvas.fonts();
  const Table table = table_of(canvas, state);
  const Form& form = table.form;
  const auto [at, size] = table.area;
  const float left = at.x + form.inset(), width = size.x - 2.0F * form.inset();
  canvas.card(at, size, theme::kModal);
  ImFont* const title = canvas.widest({fonts.number, fonts.strong, fonts.small}, state.debrief->title, width);
  canvas.text(title, {left, at.y + (form.head() - 10.0F - canvas.measure(title, "A").y) / 2.0F}, theme::kText,
              canvas.fitted(title, state.debrief->title, width));
  ImVec2 place{left, at.y + form.head()};
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const Widths& widths = table.widths[i / table.rows_each];
    draw_row(canvas, place, table.rows[i], form, widths);
    place.y += form.row();
    if ((i + 1) % table.rows_each == 0) place = {place.x + widths.whole() + kBetween, at.y + form.head()};
  }
  const float y = at.y + size.y - form.foot() + (form.dense ? 4.0F : 7.0F);
  canvas.line({left, y}, {left + width, y}, theme::kCardEdge, 1.0F);
  ImFont* const foot =
      canvas.widest({form.dense ? fonts.small : fonts.body, fonts.small}, state.debrief->foot, width);
  canvas.text(foot, {left, y + (form.dense ? 6.0F : 9.0F)}, theme::kSecondary,
              canvas.fitted(foot, state.debrief->foot, width));
}

}  // namespace fulcrum::ui
