// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/result.h"
#include "places/places_options.h"
#include "places/vocabulary.h"

namespace yorb {

/// The vocabulary that is named, else models/vocabulary.yvoc of this installation; null, with a line in the log, where
/// none is named and none installed. Bad input names the file, what is wrong with it, and the remedy.
Result<VocabularyPtr> FindVocabulary(const PlacesOptions& options);

}  // namespace yorb
