#include "haptics/contact/contact_set.h"

#include <algorithm>

namespace fulcrum {
namespace {

constexpr unsigned kPatchBits = 4;

void take_in(Contact& kept, const Contact& other) {
  Overlap both = kept.overlap;
  both += other.overlap;
  if (other.depth > kept.depth) kept = other;
  kept.overlap = both;
}

}  // namespace

void ContactSet::add(const Contact& contact) noexcept {
  while (contacts_.size() == kMaxContacts && (complete() || !of_one_run(contacts_.back(), contact.point)))
    lengthen_runs();
  if (!complete() && !contacts_.empty() && of_one_run(contacts_.back(), contact.point))
    take_in(contacts_.back(), contact);
  else
    contacts_.push_back(contact);  // within the reserved storage
}

bool ContactSet::absorb(std::uint32_t point, double depth, const Overlap& overlap) noexcept {
  if (complete() || contacts_.empty()) return false;
  Contact& last = contacts_.back();
  if (!of_one_run(last, point) || depth > last.depth) return false;
  last.overlap += overlap;
  return true;
}

void ContactSet::lengthen_runs() noexcept {
  run_bits_ = complete() ? kPatchBits : run_bits_ + 1;
  std::size_t kept = 0;
  for (std::size_t i = 1; i < contacts_.size(); ++i)
    if (of_one_run(contacts_[kept], contacts_[i].point))
      take_in(contacts_[kept], contacts_[i]);
    else
      contacts_[++kept] = contacts_[i];
  contacts_.resize(kept + 1);
}

double ContactSet::depth_max() const {
  double depth = 0;
  for (const Contact& contact : contacts_) depth = std::max(depth, contact.depth);
  return depth;
}

}  // namespace fulcrum
