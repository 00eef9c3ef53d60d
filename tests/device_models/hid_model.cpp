#include "tests/device_models/hid_model.h"

#include <algorithm>

namespace fulcrum::test {

void HidModel::hear(std::span<const std::uint8_t> report) {
  const std::lock_guard lock(mutex_);
  heard_.emplace_back(report.begin(), report.end());
}

std::optional<Bytes> HidModel::feature(std::uint8_t number) {
  const std::lock_guard lock(mutex_);
  asked_.push_back(number);
  const auto found =
      std::ranges::find(facts_.features, number, [](const Bytes& feature) { return feature.front(); });
  return found == facts_.features.end() ? std::nullopt : std::optional(*found);
}

std::vector<Bytes> HidModel::heard() const {
  const std::lock_guard lock(mutex_);
  return heard_;
}

Bytes HidModel::asked() const {
  const std::lock_guard lock(mutex_);
  return asked_;
}

}  // namespace fulcrum::test
