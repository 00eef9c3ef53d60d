#pragma once
// The connection to Vulkan, and what the validation layers say.

#include <vulkan/vulkan_core.h>

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "engine/vulkan/result.h"

namespace fulcrum::vulkan {

// Another who has a say in what is drawn with: a headset's runtime knows the card that it shows pictures of,
// and what it has to be able to do.
class Creator {
public:
  virtual ~Creator() = default;
  // As the functions of Vulkan that are called alike.
  virtual VkResult create_instance(const VkInstanceCreateInfo& info, VkInstance* instance) = 0;
  virtual VkResult create_device(VkPhysicalDevice card, const VkDeviceCreateInfo& info, VkDevice* device) = 0;
  // The one to draw with; null: it has none.
  virtual VkPhysicalDevice card(VkInstance instance) = 0;
};

struct InstanceOptions {
  bool validation = false;  // validation and synchronisation validation: slow, finds mistakes in Fulcrum
  std::vector<std::string> extensions;  // what a window system asks for; empty: pictures go to files only
  Creator* creator = nullptr;           // null: nobody else has a say
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
