// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

namespace yorb {

/// Where a folder of ours such as "configs" or "models" lies, found from the running program's own place: in
/// PREFIX/share/yorb of an installation, or in the checkout that the program was built in. Never looks at the current
/// folder. Nothing when there is none.
std::optional<std::string> InstalledFolder(const std::string& name);

/// The same, beginning at a folder of choice instead of the program's.
std::optional<std::string> InstalledFolderFrom(const std::string& start, const std::string& name);

/// A module that the program loads at need, such as "yorb_codecs.so": in PREFIX/lib/yorb of an installation, or in
/// lib/yorb of the build folder that the program is in. Nothing when there is none.
std::optional<std::string> InstalledModule(const std::string& file);

/// The same, beginning at a folder of choice instead of the program's.
std::optional<std::string> InstalledModuleFrom(const std::string& start, const std::string& file);

}  // namespace yorb
