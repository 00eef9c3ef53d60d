// Where a device stands, and what is said where that cannot be kept.

#include "engine/headset/colocated.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "engine/app/cli/terminal.h"
#include "engine/scenario/colocation.h"
#include "tests/files/size_limit.h"
#include "tests/files/temporary_folder.h"

namespace fulcrum::headset {
namespace {

// Three places with both tips, and the button that keeps them.
void touch_three_places(Colocated& colocated) {
  double time = 0;
  const auto show = [&](bool holds, bool stops, const Vec3& p) {
    TickEvent event;
    event.sample.connected = true;
    event.sample.X_DH.p = p;
    colocated.note(event);
    std::array<xr::Hand, xr::kHands> hands;
    hands[1] = {std::nullopt, p, holds, stops};
    hands[1].is_known = true;
    colocated.touch(time, hands);
    time += 1.0 / 90;
  };
  for (const Vec3& place : {Vec3(-0.06, -0.02, 0.02), Vec3(0.07, 0, 0), Vec3(0, 0.05, -0.04)})
    for (int i = 0; i < 41; ++i) show(i > 2 && i < 40, false, place);
  show(false, true, Vec3::Zero());
}

// NOLINTBEGIN(concurrency-mt-unsafe): no thread runs.
TEST(Colocated, WhyItIsKnownForOneRunAloneIsSaid) {
  const test::TemporaryFolder folder;
  const char* const before = std::getenv("XDG_CONFIG_HOME");
  const std::string kept = before == nullptr ? "" : before;
  ::setenv("XDG_CONFIG_HOME", (folder / "").c_str(), 1);
  const app::HeadsetOptions options{.asked = true, .colocate = true};
  Colocated colocated(options, "touch", MappingDesc());
  app::KeptComplaints complaints;
  {
    const test::SizeLimit none(0);
    touch_three_places(colocated);
  }
  EXPECT_FALSE(colocated.is_asked());
  EXPECT_TRUE(colocated.placement());
  EXPECT_EQ(complaints.take(), "where the device stands is known for this run alone. Cannot write " +
                                   scenario::colocation_file("touch", "local").string() +
                                   ": the file would grow beyond the allowed size. Raise the limit (ulimit "
                                   "-f).");
  if (before == nullptr)
    ::unsetenv("XDG_CONFIG_HOME");
  else
    ::setenv("XDG_CONFIG_HOME", kept.c_str(), 1);
}
// NOLINTEND(concurrency-mt-unsafe)

}  // namespace
}  // namespace fulcrum::headset
