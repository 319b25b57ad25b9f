// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace yorb {

/// The style sheet of report.html: light and dark by the reader's own setting, light on paper.
const char* ReportStyle();

/// One titled part of the page; empty content gives an empty text.
std::string ReportSection(const std::string& title, const std::string& content);

/// One figure in a frame of its own.
std::string ReportCard(const std::string& label, const std::string& value);

/// The page around its content; the texts are escaped here, the content is HTML already.
std::string ReportPage(const std::string& title, const std::string& subtitle, const std::string& content,
                       const std::string& footer);

}  // namespace yorb
