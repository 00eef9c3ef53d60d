#include "engine/ui/canvas.h"

#include <cmath>
#include <sstream>

namespace fulcrum::ui {

void Canvas::card(ImVec2 at, ImVec2 size, ImU32 colour) const {
  if (log_ != nullptr) log_->cards.push_back({at, size});
  box(at, size, colour, theme::kRounding);
  frame(at, size, theme::kCardEdge, theme::kRounding, 1.0F);
}

void Canvas::box(ImVec2 at, ImVec2 size, ImU32 colour, float rounding) const {
  list_.AddRectFilled(px(at), px({at.x + size.x, at.y + size.y}), colour, rounding * scale_);
}

void Canvas::frame(ImVec2 at, ImVec2 size, ImU32 colour, float rounding, float width) const {
  list_.AddRect(px(at), px({at.x + size.x, at.y + size.y}), colour, rounding * scale_, 0, width * scale_);
}

void Canvas::line(ImVec2 from, ImVec2 to, ImU32 colour, float width) const {
  list_.AddLine(px(from), px(to), colour, width * scale_);
}

void Canvas::arc(ImVec2 middle, float radius, float from_rad, float to_rad, ImU32 colour, float width) const {
  const int segments = 4 + static_cast<int>(std::abs(to_rad - from_rad) * 14.0F);
  list_.PathArcTo(px(middle), radius * scale_, from_rad, to_rad, segments);
  list_.PathStroke(colour, 0, width * scale_);
}

void Canvas::disc(ImVec2 middle, float radius, ImU32 colour) const {
  list_.AddCircleFilled(px(middle), radius * scale_, colour, 32);
}

void Canvas::circle(ImVec2 middle, float radius, ImU32 colour, float width) const {
  list_.AddCircle(px(middle), radius * scale_, colour, 32, width * scale_);
}

void Canvas::triangle(ImVec2 a, ImVec2 b, ImVec2 c, ImU32 colour) const {
  list_.AddTriangleFilled(px(a), px(b), px(c), colour);
}

void Canvas::text(ImFont* font, ImVec2 at, ImU32 colour, const std::string& words, Align align) const {
  const float width = align == Align::left ? 0.0F : measure(font, words).x;
  at.x -= align == Align::centre ? width / 2.0F : width;
  if (log_ != nullptr && !words.empty())
    log_->words.push_back({{at, measure(font, words)}, words, log_->cards.size()});
  const ImVec2 corner = px(at);
  // On whole pixels: glyphs are rasterised for them and blur between them.
  list_.AddText(font, font->FontSize, {std::round(corner.x), std::round(corner.y)}, colour, words.c_str());
}

ImVec2 Canvas::measure(ImFont* font, const std::string& words) const {
  const ImVec2 size = font->CalcTextSizeA(font->FontSize, 1e6F, 0.0F, words.c_str());
  return {size.x / scale_, size.y / scale_};
}

std::string Canvas::fitted(ImFont* font, const std::string& words, float width) const {
  if (measure(font, words).x <= width) return words;
  if (log_ != nullptr) log_->cut.push_back(words);
  std::string shorter = words;
  while (!shorter.empty() && measure(font, shorter + "...").x > width) {
    // A whole UTF-8 character at a time: continuation bytes are 10xxxxxx.
    while (shorter.size() > 1 && (static_cast<unsigned char>(shorter.back()) & 0xC0U) == 0x80U)
      shorter.pop_back();
    shorter.pop_back();
  }
  return shorter + "...";
}

std::vector<std::string> Canvas::wrapped(ImFont* font, const std::string& words, float width) const {
  std::vector<std::string> lines;
  std::istringstream sentences(words);
  for (std::string sentence; std::getline(sentences, sentence);) {
    bool begins = true;
    std::istringstream rest(sentence);
    for (std::string word; rest >> word; begins = false) {
      const std::string longer = begins ? word : lines.back() + " " + word;
      if (!begins && measure(font, longer).x <= width)
        lines.back() = longer;
      else
        lines.push_back(fitted(font, word, width));
    }
  }
  return lines;
}

std::vector<std::string> Canvas::lines(ImFont* font, const std::string& words, float width,
                                       std::size_t most) const {
  std::vector<std::string> all = wrapped(font, words, width);
  if (all.size() <= most) return all;
  if (log_ != nullptr) log_->cut.push_back(words);
  all.resize(most);
  if (most > 0) all.back() = fitted(font, all.back() + " ...", width);
  return all;
}

ImFont* Canvas::widest(std::initializer_list<ImFont*> fonts, const std::string& words, float width) const {
  ImFont* last = nullptr;
  for (ImFont* const font : fonts) {
    last = font;
    if (measure(font, words).x <= width) break;
  }
  return last;
}

}  // namespace fulcrum::ui
