// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace yorb {

/// A picture's file (PNG or JPEG) with a line of text in it by which a later run knows its own work again. `source`
/// says what the picture was made of. Viewers and decoders pass the line over.
std::string SignedPicture(const std::string& file, const std::string& source);

/// Whether a file is, to the last bit, a picture that was made of `source` and signed. One that was edited since is
/// not.
bool IsSignedPicture(const std::string& file, const std::string& source);

}  // namespace yorb
