// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "training/open_packs.h"

namespace yorb {

Result<std::shared_ptr<const Composer>> OpenPacks(const std::vector<std::string>& paths, const ClassTable& table) {
  std::vector<std::shared_ptr<const Pack>> packs;
  for (const std::string& path : paths) {
    auto pack = Pack::Open(path);
    if (!pack) return pack.error();
    packs.push_back(*pack);
  }
  return std::shared_ptr<const Composer>(std::make_shared<Composer>(std::move(packs), table));
}

}  // namespace yorb
