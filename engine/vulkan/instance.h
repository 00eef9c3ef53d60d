#pragma once
// The connection to Vulkan, and what the validation layers say.

#include <vulkan/vulkan_core.h>

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "engine/vulkan/result.h"

namespace fulcrum::vulkan {

struct InstanceOptions {
  bool validation = false;  // validation and synchronisation validation: slow, finds mistakes in Fulcrum
  std::vector<std::string> extensions;  // what a window system asks for; empty: pictures go to files only
};

// Collects warnings and errors of the validation layers. Any thread may write to it.
class MessageLog {
public:
  void add(std::string message);
  std::vector<std::string> messages() const;

private:
  mutable std::mutex mutex_;
  std::vector<std::string> messages_;
};

class Instance {
public:
  // Fails with a sentence where no Vulkan driver is installed, where it is older than 1.3, or where
  // validation is asked for and the layers are not installed.
  static Result<Instance> create(const InstanceOptions& options);

  Instance(Instance&& other) noexcept;
  Instance& operator=(Instance&& other) noexcept;
  ~Instance();

  VkInstance get() const { return instance_; }

  // What the validation layers had to say so far; empty without validation.
  std::vector<std::string> messages() const { return log_->messages(); }

private:
  Instance() = default;

  VkInstance instance_ = VK_NULL_HANDLE;
  VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
  std::unique_ptr<MessageLog> log_ = std::make_unique<MessageLog>();  // the layers keep its address
};

}  // namespace fulcrum::vulkan
