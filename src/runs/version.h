// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace yorb {

/// The project's version, "0.1.0".
const char* Version();

}  // namespace yorb
