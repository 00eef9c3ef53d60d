#include "haptics/contact/contact_set.h"

#include <algorithm>

namespace fulcrum {

bool ContactSet::add(const Contact& contact) noexcept {
  if (contacts_.size() < kMaxContacts) {
    contacts_.push_back(contact);  // within the reserved storage
    return true;
  }
  const auto shallowest =
      std::min_element(contacts_.begin(), contacts_.end(),
                       [](const Contact& a, const Contact& b) { return a.depth < b.depth; });
  if (shallowest->depth < contact.depth) *shallowest = contact;
  return false;
}

double ContactSet::depth_max() const {
  double depth = 0;
  for (const Contact& contact : contacts_) depth = std::max(depth, contact.depth);
  return depth;
}

}  // namespace fulcrum
