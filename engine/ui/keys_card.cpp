// What each key and the mouse do: one below the other, in columns where the picture is low, and on pages
// where that does not do.

#include <algorithm>

#include "engine/ui/columns.h"
#include "engine/ui/panels.h"
#include "engine/ui/theme.h"

namespace fulcrum::ui {
namespace {

constexpr float kHead = 48.0F;
constexpr float kFoot = 14.0F;
constexpr float kBetween = 32.0F;      // columns
constexpr float kLine = 18.0F;         // from a line of words to the next
constexpr float kPad = 9.0F;           // that a key's row is higher than its lines
constexpr float kMostWords = 380.0F;   // wide; what is longer goes on in the next line
constexpr float kLeastWords = 170.0F;  // narrower than this, there is one column less
constexpr std::size_t kMostColumns = 3;

// A key and its meaning, or without a key a line about the mouse.
struct Item {
  std::string key;
  std::vector<std::string> lines;
  float height() const { return kPad + kLine * static_cast<float>(lines.size()); }
};

// Items, in columns of one height, so many columns on a page.
struct Layout {
  std::vector<Item> items;
  std::vector<std::size_t> starts;  // of each column, an index into items
  std::size_t columns = 1;          // on a page
  float key = 0.0F, words = 0.0F;   // width of the keys', and of what they mean
  float height = 0.0F;              // of the highest column
  std::size_t pages() const { return (starts.size() + columns - 1) / columns; }
  float column() const { return key + words; }
};

std::vector<Item> items_of(const Canvas& canvas, const OverlayState& state, float key, float words) {
  std::vector<Item> items;
  ImFont* const font = canvas.fonts().body;
  for (const KeyLine& line : state.keys)
    items.push_back({line.key, canvas.wrapped(font, line.meaning, words)});
  for (const std::string& line : state.mapping)
    items.push_back({"", canvas.wrapped(font, line, key + words)});
  return items;
}

Layout lay_out(const Canvas& canvas, const OverlayState& state, std::size_t columns, const ImVec2& room) {
  const Fonts& fonts = canvas.fonts();
  Layout layout;
  layout.columns = columns;
  for (const KeyLine& line : state.keys)
    layout.key = std::max(layout.key, canvas.measure(fonts.strong, line.key).x + 26.0F);
  const auto n = static_cast<float>(columns);
  const float each = (room.x - (n - 1.0F) * kBetween) / n;
  layout.items = items_of(canvas, state, layout.key, std::min(kMostWords, each - layout.key));
  float height = room.y;  // of the column so far: the first item begins one
  for (std::size_t i = 0; i < layout.items.size(); ++i) {
    const Item& item = layout.items[i];
    // What the mouse does begins a column of its own where there is one more.
    const bool begins = i == state.keys.size() && layout.starts.size() % columns != 0;
    if (height + item.height() > room.y || layout.starts.empty() || begins) {
      layout.starts.push_back(i);
      height = 0.0F;
    }
    height += item.height();
    layout.height = std::max(layout.height, height);
    for (const std::string& line : item.lines)
      layout.words =
          std::max(layout.words, canvas.measure(fonts.body, line).x - (item.key.empty() ? layout.key : 0.0F));
  }
  return layout;
}

struct Card {
  Layout layout;
  float inset = 24.0F;
  Area area;
};

// In the fewest columns that do without pages; else in those with the fewest pages.
Card card_of(const Canvas& canvas, const OverlayState& state) {
  Card card;
  if (!state.keys_visible) return card;
  const float margin = margin_of(canvas.height());
  const Area band = columns_of(state, canvas.width(), canvas.height()).band;
  const float top = margin + std::max(0.0F, band.at.y + band.size.y);
  card.inset = canvas.width() < 700.0F ? 16.0F : 24.0F;
  const ImVec2 room{canvas.width() - 2.0F * margin - 2.0F * card.inset,
                    canvas.height() - margin - top - kHead - kFoot};
  for (std::size_t columns = 1; columns <= kMostColumns; ++columns) {
    Layout layout = lay_out(canvas, state, columns, room);
    const float words = room.x / static_cast<float>(columns) - kBetween - layout.key;
    if (columns > 1 && words < kLeastWords) break;
    if (columns == 1 || layout.pages() < card.layout.pages()) card.layout = std::move(layout);
    if (card.layout.pages() <= 1) break;
  }
  const Layout& layout = card.layout;
  const auto shown = static_cast<float>(std::min(layout.columns, layout.starts.size()));
  const float width = std::max(252.0F, shown * layout.column() + (shown - 1.0F) * kBetween);
  const ImVec2 size{std::min(width, room.x) + 2.0F * card.inset, kHead + layout.height + kFoot};
  const float middle = (top + canvas.height() - margin) / 2.0F;
  card.area = {{(canvas.width() - size.x) / 2.0F, std::max(top, middle - size.y / 2.0F)}, size};
  return card;
}

void draw_item(const Canvas& canvas, ImVec2 at, const Item& item, float key_width) {
  const Fonts& fonts = canvas.fonts();
  float left = at.x, y = at.y + 3.0F;
  if (!item.key.empty()) {
    const ImVec2 key = canvas.measure(fonts.strong, item.key);
    canvas.box(at, {key.x + 16.0F, 22.0F}, theme::kTrack, 4.0F);
    canvas.text(fonts.strong, {at.x + 8.0F, at.y + (22.0F - key.y) / 2.0F}, theme::kText, item.key);
    left += key_width;
  }
  for (const std::string& line : item.lines) {
    canvas.text(fonts.body, {left, y}, theme::kSecondary, line);
    y += kLine;
  }
}

}  // namespace

Area keys_area(const Canvas& canvas, const OverlayState& state) {
  return card_of(canvas, state).area;
}

std::size_t keys_pages(const Canvas& canvas, const OverlayState& state) {
  return state.keys_visible ? card_of(canvas, state).layout.pages() : 0;
}

void draw_keys(const Canvas& canvas, const OverlayState& state) {
  if (!state.keys_visible) return;
  const Fonts& fonts = canvas.fonts();
  const auto [layout, inset, area] = card_of(canvas, state);
  const auto [at, size] = area;
  const std::size_t pages = std::max<std::size_t>(layout.pages(), 1);
  const std::size_t page = std::min(state.keys_page, pages - 1);
  canvas.card(at, size, theme::kModal);
  canvas.text(fonts.strong, {at.x + inset, at.y + 16.0F}, theme::kText, "Keys");
  const std::string note =
      page + 1 < pages ? "F1: more (" + std::to_string(page + 1) + " of " + std::to_string(pages) + ")"
                       : "F1 closes this";
  canvas.text(fonts.small, {at.x + size.x - inset, at.y + 18.0F}, theme::kSecondary, note, Align::right);
  for (std::size_t column = 0; column < layout.columns; ++column) {
    const std::size_t start = page * layout.columns + column;
    if (start >= layout.starts.size()) break;
    const std::size_t end = start + 1 < layout.starts.size() ? layout.starts[start + 1] : layout.items.size();
    ImVec2 place{at.x + inset + static_cast<float>(column) * (layout.column() + kBetween), at.y + kHead};
    if (column > 0)
      canvas.line({place.x - kBetween / 2.0F, place.y}, {place.x - kBetween / 2.0F, at.y + size.y - kFoot},
                  theme::kCardEdge, 1.0F);
    for (std::size_t i = layout.starts[start]; i < end; ++i) {
      draw_item(canvas, place, layout.items[i], layout.key);
      place.y += layout.items[i].height();
    }
  }
}

}  // namespace fulcrum::ui
