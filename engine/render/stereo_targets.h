#pragma once
// What a picture for two eyes needs beside that for one: the right eye's view of the scene, both eyes'
// finished pictures, and a layer of what lies at the screen.

#include <array>

#include "engine/render/view.h"

namespace fulcrum::render {

struct StereoTargets {
  // Of a plan for two eyes. Throws vulkan::Failure.
  StereoTargets(vulkan::Device& device, const RenderPlan& plan, const SharedParts& shared);

  View right;
  std::array<vulkan::Image, 2> eyes;  // left, right
  vulkan::Image screen;               // as large as the picture; premultiplied; empty where the plan has none
  vulkan::DescriptorSet set;          // of these three
};

}  // namespace fulcrum::render
