// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "runs/version.h"

namespace yorb {

const char* Version() { return YORB_VERSION; }

}  // namespace yorb
