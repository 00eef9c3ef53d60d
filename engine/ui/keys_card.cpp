// What each key and the mouse do: one below the other, or beside each other in a low picture.

#include <algorithm>

#include "engine/ui/panels.h"
#include "engine/ui/theme.h"

namespace fulcrum::ui {
namespace {

constexpr float kHead = 52.0F;
constexpr float kFoot = 14.0F;
constexpr float kInset = 24.0F;
constexpr float kBetween = 32.0F;     // columns
constexpr float kLine = 18.0F;        // from a line of words to the next
constexpr float kPad = 9.0F;          // that a key's row is higher than its lines
constexpr float kMapping = 21.0F;     // a row of what the mouse does
constexpr float kMostWords = 380.0F;  // wide; what is longer goes on in the next line

struct KeyRow {
  std::string key;
  std::vector<std::string> lines;  // of its meaning
  float height() const { return kPad + kLine * static_cast<float>(lines.size()); }
};

struct KeyTable {
  std::vector<KeyRow> rows;
  float key = 0.0F;      // width of the keys' column
  float words = 0.0F;    // of the meanings'
  float height = 0.0F;   // of both
  float mapping = 0.0F;  // width of what the mouse does
};

KeyTable table_of(const Canvas& canvas, const OverlayState& state) {
  const Fonts& fonts = canvas.fonts();
  KeyTable table;
  for (const KeyLine& line : state.keys) {
    KeyRow row{line.key, canvas.wrapped(fonts.body, line.meaning, kMostWords)};
    table.key = std::max(table.key, canvas.measure(fonts.strong, line.key).x + kInset);
    for (const std::string& words : row.lines)
      table.words = std::max(table.words, canvas.measure(fonts.body, words).x);
    table.height += row.height();
    table.rows.push_back(std::move(row));
  }
  for (const std::string& line : state.mapping)
    table.mapping = std::max(table.mapping, canvas.measure(fonts.body, line).x);
  return table;
}

void draw_keys_of(const Canvas& canvas, ImVec2 at, const KeyTable& table) {
  const Fonts& fonts = canvas.fonts();
  for (const KeyRow& row : table.rows) {
    const ImVec2 key = canvas.measure(fonts.strong, row.key);
    canvas.box(at, {key.x + 16.0F, 22.0F}, theme::kTrack, 4.0F);
    canvas.text(fonts.strong, {at.x + 8.0F, at.y + (22.0F - key.y) / 2.0F}, theme::kText, row.key);
    float y = at.y + (22.0F - key.y) / 2.0F;
    for (const std::string& line : row.lines) {
      canvas.text(fonts.body, {at.x + table.key + 8.0F, y}, theme::kSecondary, line);
      y += kLine;
    }
    at.y += row.height();
  }
}

}  // namespace

void draw_keys(const Canvas& canvas, const OverlayState& state) {
  if (!state.keys_visible) return;
  const Fonts& fonts = canvas.fonts();
  const KeyTable table = table_of(canvas, state);
  const float keys = table.key + 8.0F + table.words;
  const float mapping = static_cast<float>(state.mapping.size()) * kMapping;
  const float below = mapping > 0.0F ? 18.0F + mapping : 0.0F;
  const bool beside =
      mapping > 0.0F && kHead + table.height + below + kFoot > canvas.height() - 2.0F * theme::kMargin;
  const float width = beside ? keys + kBetween + table.mapping : std::max({keys, table.mapping, 252.0F});
  const ImVec2 size{width + 2.0F * kInset,
                    kHead + (beside ? std::max(table.height, mapping) : table.height + below) + kFoot};
  const ImVec2 at{(canvas.width() - size.x) / 2.0F, (canvas.height() - size.y) / 2.0F};
  canvas.box(at, size, IM_COL32(12, 15, 19, 238), theme::kRounding);
  canvas.frame(at, size, theme::kCardEdge, theme::kRounding, 1.0F);
  canvas.text(fonts.strong, {at.x + kInset, at.y + 18.0F}, theme::kText, "Keys");
  canvas.text(fonts.small, {at.x + size.x - kInset, at.y + 20.0F}, theme::kFaint, "F1 closes this",
              Align::right);
  draw_keys_of(canvas, {at.x + kInset, at.y + kHead}, table);
  if (state.mapping.empty()) return;
  ImVec2 line{at.x + kInset, at.y + kHead + table.height};
  if (beside) {
    line = {at.x + kInset + keys + kBetween, at.y + kHead};
    canvas.line({line.x - kBetween / 2.0F, line.y}, {line.x - kBetween / 2.0F, at.y + size.y - kFoot},
                theme::kCardEdge, 1.0F);
  } else {
    canvas.line({line.x, line.y + 6.0F}, {at.x + size.x - kInset, line.y + 6.0F}, theme::kCardEdge, 1.0F);
    line.y += 18.0F;
  }
  for (const std::string& words : state.mapping) {
    canvas.text(fonts.body, line, theme::kSecondary, words);
    line.y += kMapping;
  }
}

}  // namespace fulcrum::ui
