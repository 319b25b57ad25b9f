// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "runs/unreadable.h"

namespace yorb {
namespace {

constexpr size_t kMostNamed = 3;

}  // namespace

void Unreadable::Add(const Error& error) {
  if (++count_ <= kMostNamed) first_.push_back(error.message);
}

void Unreadable::Add(const Unreadable& others) {
  count_ += others.count_;
  first_.insert(first_.end(), others.first_.begin(), others.first_.end());
  if (first_.size() > kMostNamed) first_.resize(kMostNamed);
}

Status Unreadable::Told() const {
  if (count_ == 0) return Status::Ok();
  if (count_ == 1) return BadInput(first_.front());
  std::string text = std::to_string(count_) + " pictures or sources cannot be read: ";
  for (size_t i = 0; i < first_.size(); ++i) text += (i > 0 ? "; " : "") + first_[i];
  if (count_ > first_.size()) text += "; and " + std::to_string(count_ - first_.size()) + " more";
  return BadInput(text);
}

}  // namespace yorb
