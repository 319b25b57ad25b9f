// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/result.h"
#include "training/compose.h"

namespace yorb {

/// Opens packs as one set of pictures with the classes of `table`.
Result<std::shared_ptr<const Composer>> OpenPacks(const std::vector<std::string>& paths, const ClassTable& table);

}  // namespace yorb
