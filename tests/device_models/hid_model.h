#pragma once
// A device that speaks HID, on no bus in particular: what it says, what it hears and its feature reports. A
// bus asks it from a thread of its own while a test moves it and looks at what it heard.

#include <cstdint>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "drivers/hid/hid_id.h"
#include "tests/device_models/usb_model.h"

namespace fulcrum::test {

struct HidFacts {
  hid::HidId id;
  std::string maker, name;
  Bytes descriptor;               // of its reports
  std::vector<Bytes> features{};  // each begins with its number; any other it does not have
};

class HidModel {
public:
  explicit HidModel(HidFacts facts) : facts_(std::move(facts)) {}
  virtual ~HidModel() = default;
  HidModel(const HidModel&) = delete;
  HidModel& operator=(const HidModel&) = delete;

  const HidFacts& facts() const { return facts_; }

  // The bus: what it says when it is asked, once in its interval; none: nothing now.
  virtual std::optional<Bytes> say() = 0;
  // The bus: it is plugged in, and knows nothing of what was before.
  virtual void begin() {}
  void hear(std::span<const std::uint8_t> report);
  std::optional<Bytes> feature(std::uint8_t number);

  // The test: reports that it was told, and numbers of feature reports that it was asked for, in order.
  std::vector<Bytes> heard() const;
  Bytes asked() const;

protected:
  mutable std::mutex mutex_;

private:
  const HidFacts facts_;
  std::vector<Bytes> heard_;
  Bytes asked_;
};

}  // namespace fulcrum::test
