// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/messages/number_list.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <exception>
#include <sstream>

#include "meshops/error.h"

namespace sherd {

std::optional<double> number_of(std::string_view text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.begin(), text.end(), value);
    if (error != std::errc() || end != text.end() || !std::isfinite(value)) return std::nullopt;
    return value;
}

std::vector<double> number_list(const std::string& option, const std::string& text) {
    std::vector<double> numbers;
    std::istringstream stream(text);
    for (std::string word; std::getline(stream, word, ',');) {
        std::size_t used = 0;
        try {
            numbers.push_back(std::stod(word, &used));
        } catch (const std::exception&) {
            used = std::string::npos;
        }
        if (used != word.size() || !std::isfinite(numbers.back()))
            throw Error(fmt::format("{} {}: '{}' is not a number", option, text, word));
    }
    return numbers;
}

}  // namespace sherd
