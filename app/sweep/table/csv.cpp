// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sweep/table/csv.h"

#include <fmt/format.h>

#include "meshops/error.h"
#include "meshops/read_write/text_line.h"

namespace sherd {
namespace {

/// Returns a cell, in quotes if necessary. Quotes also protect a cell that begins like a byte order mark.
std::string quoted_cell(const std::string& cell) {
    const bool is_mark = cell.find_first_of("\xEF\xFE\xFF") == 0;
    if (!is_mark && cell.find_first_of("\",\r\n") == std::string::npos) return cell;
    std::string quoted = "\"";
    for (const char c : cell) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

/// Reads the rows of a text one after the other.
class CsvReader {
  public:
    CsvReader(std::string_view text, const std::filesystem::path& file)
        : text(without_byte_order_mark(file, text)), file(file) {}

    CsvRows read() {
        CsvRows rows;
        while (at < text.size()) {
            const std::size_t begin = line;
            rows.push_back(read_row());
            if (rows.back().size() != rows.front().size())
                throw Error(fmt::format("{}:{}: the row has {} cells and the first one has {}", file.string(),
                                        begin, rows.back().size(), rows.front().size()));
        }
        return rows;
    }

  private:
    std::vector<std::string> read_row() {
        std::vector<std::string> row{""};
        for (; at < text.size(); ++at) {
            const char c = text[at];
            if (c == '"' && row.back().empty())
                read_quoted(row.back());
            else if (c == ',')
                row.emplace_back();
            else if (c == '\n' || c == '\r')
                break;
            else
                row.back() += c;
        }
        if (text.compare(at, 2, "\r\n") == 0) ++at;
        ++at, ++line;
        return row;
    }

    /// Reads a cell in quotes, from the quote that begins it to the quote that ends it.
    void read_quoted(std::string& cell) {
        const std::size_t begin = line;
        for (++at; at < text.size(); ++at) {
            if (text[at] == '"' && (at + 1 == text.size() || text[at + 1] != '"')) return;
            if (text[at] == '"') ++at;
            if (text[at] == '\n') ++line;
            cell += text[at];
        }
        throw Error(fmt::format("{}:{}: a quote is not closed", file.string(), begin));
    }

    std::string_view text;
    const std::filesystem::path& file;
    std::size_t at = 0, line = 1;
};

}  // namespace

std::string csv_text(const CsvRows& rows) {
    std::string text;
    for (const std::vector<std::string>& row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i) text += (i > 0 ? "," : "") + quoted_cell(row[i]);
        text += '\n';
    }
    return text;
}

CsvRows parse_csv(const std::string& text, const std::filesystem::path& file) {
    return CsvReader(text, file).read();
}

}  // namespace sherd
