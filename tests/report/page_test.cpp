// A page is HTML and well-formed XML: one test reads it back as the latter.

#include "engine/report/page.h"

#include <gtest/gtest.h>

#include <cctype>
#include <cmath>

#include "engine/report/markup.h"

namespace fulcrum::report {
namespace {

// What is wrong with the nesting, quoting and entities of a document; empty if nothing is.
std::string malformed(const std::string& text) {
  std::vector<std::string> open;
  std::size_t at = text.find("<html");
  while (at < text.size()) {
    if (text[at] == '&') {
      const std::size_t end = text.find(';', at);
      if (end == text.npos || end - at > 6) return "a bare & at " + text.substr(at, 20);
      at = end;
    } else if (text[at] == '<') {
      std::size_t end = at + 1;
      for (bool quoted = false; end < text.size() && (quoted || text[end] != '>'); ++end) {
        if (text[end] == '"') quoted = !quoted;
        if (text[end] == '<') return "a < within " + text.substr(at, 40);
      }
      if (end == text.size()) return "an open tag " + text.substr(at, 40);
      const std::string tag = text.substr(at + 1, end - at - 1);
      const std::string name = tag.substr(0, tag.find_first_of(" /", 1));
      if (tag.front() == '/') {
        if (open.empty() || "/" + open.back() != tag)
          return "</" + tag + " closes " + (open.empty() ? "" : open.back());
        open.pop_back();
      } else if (tag.back() != '/') {
        open.push_back(name);
      }
      at = end;
    }
    ++at;
  }
  return open.empty() ? "" : open.back() + " is not closed";
}

Plot busy_plot() {
  Plot plot;
  plot.title = "Error <& \"work\">";
  plot.x = {"work", "us", Scale::logarithmic, {}, {}};
  plot.y = {"error", "m", Scale::logarithmic, {}, {}};
  const std::vector<Point> points{{1, 1e-3}, {2, 4e-3}, {4, 1e-4}, {8, 1e-5}, {16, 0}, {32, 1e-6}};
  plot.series.push_back({"a < b & c", points, Line::solid, Marker::circle, 0, false});
  plot.series.push_back({"front", pareto_front(points), Line::dashed, Marker::diamond, kInk, true});
  plot.cells = {{1, 4, 32}, {1e-6, 1e-4, 1e-2}, {0, 1, -1, 1}, {{"good", -2}, {"bad", 3}}};
  plot.labels.push_back({{4, 1e-4}, "here & now", Side::above});
  return plot;
}

// Two rows of two discs, each of 2 x 3 cells.
Panels busy_panels() {
  Panels panels;
  panels.title = "Here & there";
  panels.columns = {"a < b", "c"};
  panels.rows = {"one", "two"};
  panels.across = 2;
  panels.down = 3;
  panels.round = true;
  panels.above = "away";
  panels.below = "person";
  panels.bands = {{"less", -2}, {"more", 3}};
  panels.panels = {{0, 0, 1, 1, -1, -1}, {0, 1, 1, 0, 0, 1}, {-1, -1, -1, -1, -1, -1}, {1, 1, 1, 1, 1, 1}};
  return panels;
}

std::string busy_page() {
  Page page("Work & precision <1>");
  page.heading("A \"heading\"");
  page.paragraph("K < 2 b / T & so on\x01");
  page.note("not < to be missed");
  page.command("fulcrum stability --out 'A'");
  page.facts({{"a & b", "<1"}, {"c", "2"}});
  page.table({{"method", "error"}, {{"a & b", "<1"}, {"c", "2"}}});
  page.plot(busy_plot(), "What is > nothing");
  page.panels(busy_panels(), "Seen & drawn");
  return page.html();
}

TEST(Page, IsWellFormed) {
  EXPECT_EQ(malformed(busy_page()), "");
  EXPECT_NE(malformed("<html><p>a & b</p></html>"), "");  // the check can fail
  EXPECT_NE(malformed("<html><p>a</html>"), "");
}

TEST(Page, NeedsNothingElse) {
  const std::string html = busy_page();
  EXPECT_EQ(html.find("<script"), html.npos);
  EXPECT_EQ(html.find("src="), html.npos);
  EXPECT_EQ(html.find("href="), html.npos);
  EXPECT_EQ(html.find("url("), html.npos);
  EXPECT_NE(html.find("prefers-color-scheme: dark"), html.npos);
}

TEST(Page, EscapesText) {
  const std::string html = busy_page();
  EXPECT_NE(html.find("<h1>Work &amp; precision &lt;1&gt;</h1>"), html.npos);
  EXPECT_NE(html.find("a &lt; b &amp; c"), html.npos);
  EXPECT_NE(html.find("here &amp; now"), html.npos);
  EXPECT_EQ(escaped("<a href=\"x\">'&'"), "&lt;a href=&quot;x&quot;&gt;&#39;&amp;&#39;");
  EXPECT_EQ(escaped("\x01"), "\xEF\xBF\xBD");
}

TEST(Plot, AxisTitlesCarryUnits) {
  const std::string picture = svg(busy_plot());
  EXPECT_NE(picture.find(">work (us)</text>"), picture.npos);
  EXPECT_NE(picture.find(">error (m)</text>"), picture.npos);
}

TEST(Page, FactsAreNamesWithWhatThereIsToSay) {
  EXPECT_NE(busy_page().find("<dt>a &amp; b</dt><dd>&lt;1</dd>"), std::string::npos);
}

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t found = 0;
  for (std::size_t at = text.find(what); at != text.npos; at = text.find(what, at + 1)) ++found;
  return found;
}

TEST(Plot, APointThatAnAxisCannotShowInterruptsTheLine) {
  Plot plot;
  plot.y.scale = Scale::logarithmic;
  plot.series.push_back(
      {"", {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, std::nan("")}, {5, 6}}, Line::solid, Marker::none, 0, false});
  const std::string picture = svg(plot);
  const std::size_t at = picture.find("class=\"line h0\"");
  ASSERT_NE(at, picture.npos);
  const std::string path = picture.substr(at, picture.find("/>", at) - at);
  EXPECT_EQ(count(path, "M"), 3u);
  EXPECT_EQ(count(path, "L"), 1u);
  EXPECT_EQ(picture.find("nan"), picture.npos);
  EXPECT_EQ(picture.find("inf"), picture.npos);
}

TEST(Plot, IsAsHighAsItSays) {
  Plot low = busy_plot(), high = busy_plot();
  low.height = 150;
  high.height = 260;
  const auto height = [](const std::string& picture) {
    const std::string box = "viewBox=\"0 0 760 ";
    return std::stod(picture.substr(picture.find(box) + box.size()));
  };
  EXPECT_EQ(height(svg(high)) - height(svg(low)), 110);
}

TEST(Plot, BandsWithoutANameAreNotInTheLegend) {
  Plot plot = busy_plot();
  const std::size_t all = count(svg(plot), "<rect");
  plot.cells.bands[1].name.clear();
  EXPECT_EQ(count(svg(plot), "<rect"), all - 1);
}

TEST(Plot, NothingStandsOutsideThePicture) {
  Plot plot = busy_plot();
  plot.x.low = 2;  // some points lie beyond
  plot.x.high = 20;
  const std::string picture = svg(plot);
  for (std::size_t at = picture.find("<text"); at != picture.npos; at = picture.find("<text", at + 1)) {
    const std::size_t x = picture.find(" x=\"", at);
    if (x > picture.find('>', at)) continue;
    const double place = std::stod(picture.substr(x + 4));
    EXPECT_GE(place, 0);
    EXPECT_LE(place, 760);
  }
}

TEST(Plot, CellsOfOneShadeInARowAreOne) {
  Plot plot;
  plot.cells = {{0, 1, 2, 3, 4}, {0, 1}, {0, 0, 1, 1}, {{"a", -1}, {"b", 1}}};
  const std::string picture = svg(plot);
  EXPECT_EQ(count(picture, "<rect class=\"cool1\""), 1u);
  EXPECT_EQ(count(picture, "<rect class=\"warm1\""), 1u);
}

TEST(Pareto, FrontIsWhatNoOtherBeats) {
  const std::vector<Point> front =
      pareto_front({{4, 1}, {1, 5}, {2, 6}, {3, 2}, {3, 3}, {std::nan(""), 0}, {5, 1}});
  ASSERT_EQ(front.size(), 3u);
  EXPECT_EQ(front[0].x, 1);
  EXPECT_EQ(front[1].x, 3);
  EXPECT_EQ(front[1].y, 2);
  EXPECT_EQ(front[2].x, 4);
}

TEST(Panels, NeighboursOfOneBandAreOneCellAndEmptyOnesNone) {
  const std::string picture = svg(busy_panels());
  EXPECT_EQ(count(picture, "<circle class=\"frame\""), 4u);
  EXPECT_EQ(count(picture, "<rect class=\"cool2\""), 1u + 3u);  // runs of rows: one, then 0|1, 1|0, 0|1
  EXPECT_EQ(count(picture, "<rect class=\"warm3\""), 1u + 3u + 3u);
  EXPECT_EQ(count(picture, ">away</text>"), 1u);
  EXPECT_NE(picture.find(">a &lt; b</text>"), picture.npos);
}

// RFC 4648, section 10.
TEST(Page, PutsBytesIntoAnAddress) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xff\xfe"), "//4=");
}

TEST(Page, HoldsItsPictures) {
  Page page("Pictures");
  page.pictures({{"one & two", "foo"}, {"three", "bar"}}, "below");
  const std::string html = page.html();
  EXPECT_EQ(malformed(html), "");
  EXPECT_NE(html.find("alt=\"one &amp; two\" src=\"data:image/png;base64,Zm9v\""), html.npos);
}

}  // namespace
}  // namespace fulcrum::report
