#pragma once
// The connection to a headset's runtime, which has a say in what Vulkan draws with.

#include <array>
#include <memory>
#include <string>

#include "engine/vulkan/instance.h"
#include "engine/xr/result.h"

namespace fulcrum::xr {

class Instance final : public vulkan::Creator {
public:
  // hands: without controllers are asked for, too. Fails with a sentence where no runtime is active, where it
  // cannot draw with Vulkan, where it has no headset, or where that tracks no hands and is asked to.
  static Result<std::unique_ptr<Instance>> create(bool hands);
  ~Instance() override;
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;

  XrInstance get() const { return instance_; }
  XrSystemId system() const { return system_; }
  const std::string& runtime() const { return runtime_; }  // "Monado 21.0.0"
  const std::string& headset() const { return headset_; }  // as the runtime calls it

  // After a session was lost: looks for the headset again. False: it is not there, or not yet. Throws Failure
  // where the runtime itself is gone.
  bool find_headset();

  // Pixels of one eye's picture, as large as the runtime would have it now; smaller where two of them would
  // be wider than its pictures can be. Throws Failure, such as where that is no size.
  VkExtent2D recommended_eye() const;

  // How a picture goes with the room around: in its stead where the headset can, else as the runtime prefers.
  // Throws Failure.
  XrEnvironmentBlendMode blend_mode() const;

  // Of an extension that was asked for. Throws Failure.
  template <class Function>
  Function function(const char* name) const {
    return reinterpret_cast<Function>(find(name));
  }
  // The path of that name, such as "/user/hand/left". Throws Failure.
  XrPath path(const char* name) const;

  VkResult create_instance(const VkInstanceCreateInfo& info, VkInstance* instance) override;
  VkResult create_device(VkPhysicalDevice card, const VkDeviceCreateInfo& info, VkDevice* device) override;
  VkPhysicalDevice card(VkInstance instance) override;

private:
  Instance() = default;
  XrResult ask_for_system();
  PFN_xrVoidFunction find(const char* name) const;

  XrInstance instance_ = XR_NULL_HANDLE;
  XrSystemId system_ = XR_NULL_SYSTEM_ID;
  std::string runtime_, headset_;
  VkExtent2D largest_{};  // pixels of a picture; 0: the runtime does not say
};

}  // namespace fulcrum::xr
