// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace sherd {

/// A table of text: the first row has the names of the columns.
using CsvRows = std::vector<std::vector<std::string>>;

/// Returns a table as text: CSV as in RFC 4180, but with "\n" at the ends of lines.
std::string csv_text(const CsvRows& rows);

/// Reads CSV text, with any ends of lines, and with or without a byte order mark. Throws Error (input) with
/// the line when quotes are not closed or a row has another number of cells than the first. `file` is for
/// messages.
CsvRows parse_csv(const std::string& text, const std::filesystem::path& file);

}  // namespace sherd
