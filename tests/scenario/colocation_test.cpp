// Where a device stands in a headset's space: written, read again, and refused with a remedy where it cannot
// be.

#include "engine/scenario/colocation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/scenario/example.h"

namespace fulcrum::scenario::test {
namespace {

Colocation standing() {
  return {"touch", "stage", {Quat(0.6, 0.48, -0.64, 0), Vec3(1.0 / 3, 0.8, -0.5)}, {0.001, 0.002, 0.0022}};
}

std::string refusal(const std::string& text, std::string_view device = "touch",
                    std::string_view space = "stage") {
  const Folder folder;
  folder.write("kept.yaml", text);
  const auto read = load_colocation(folder.root() / "kept.yaml", device, space);
  return read ? std::string() : to_text(read.faults());
}

TEST(Colocation, IsReadAsItWasWritten) {
  const Folder folder;
  folder.write("kept.yaml", colocation_text(standing()));
  const auto read = load_colocation(folder.root() / "kept.yaml", "touch", "stage");
  ASSERT_TRUE(read) << to_text(read.faults());
  EXPECT_EQ(read->X_LD.p, standing().X_LD.p);
  EXPECT_LT((read->X_LD.q.coeffs() - standing().X_LD.q.coeffs()).norm(), 1e-15);
  EXPECT_EQ(read->residuals, standing().residuals);
  EXPECT_NEAR(read->rms(), std::sqrt((1 + 4 + 4.84) / 3) * 1e-3, 1e-12);
}

TEST(Colocation, DamageIsSaidWithItsPlaceAndTheRemedy) {
  std::string text = colocation_text(standing());
  const auto with = [&text](const std::string& part, const std::string& other) {
    std::string changed = text;
    return changed.replace(changed.find(part), part.size(), other);
  };
  for (const std::string& damaged :
       {std::string(), text.substr(0, text.size() / 2), std::string("\x01\x02"), with("[0.6", "[0.7"),
        with("[0.6", "[.nan"), with("residuals", "residual"), with("0.8", "80000")}) {
    const std::string said = refusal(damaged);
    EXPECT_NE(said.find("kept.yaml"), std::string::npos) << damaged << said;
    EXPECT_NE(said.find("anew with --colocate, or remove the file"), std::string::npos) << damaged << said;
  }
  EXPECT_NE(refusal(with("residuals", "residual")).find(":6:"), std::string::npos)
      << refusal(with("residuals", "residual"));
  EXPECT_NE(refusal(text, "falcon").find("it is of 'touch' in 'stage' space, and asked for is 'falcon'"),
            std::string::npos)
      << refusal(text, "falcon");
  EXPECT_NE(refusal(text, "touch", "local"), "");
  EXPECT_EQ(refusal(text), "");
}

TEST(Colocation, IsNamedForDeviceAndSpace) {
  EXPECT_EQ(colocation_file("touch", "stage").filename(), "touch.xr-stage.yaml");
}

}  // namespace
}  // namespace fulcrum::scenario::test
