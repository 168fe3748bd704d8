// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/number_check.h"

#include <fmt/format.h>

#include <charconv>

#include "app/messages/number_list.h"

namespace sherd {
namespace {

template <class IsRight>
NumberCheck checked(std::string wanted, IsRight is_right) {
    return [wanted = std::move(wanted), is_right](const std::string& text) {
        return is_right(text) ? "" : fmt::format("give {}, not '{}'", wanted, text);
    };
}

template <class IsRight>
NumberCheck checked_number(std::string wanted, IsRight is_right) {
    return checked(std::move(wanted), [is_right](const std::string& text) {
        const std::optional<double> number = number_of(text);
        return number && is_right(*number);
    });
}

}  // namespace

NumberCheck whole_number(std::int64_t least, std::int64_t most) {
    const bool is_open = most == std::numeric_limits<std::int32_t>::max();
    return checked(is_open ? fmt::format("a whole number from {} on", least)
                           : fmt::format("a whole number from {} to {}", least, most),
                   [least, most](const std::string& text) {
                       std::int64_t value = 0;
                       const char* const end = text.data() + text.size();
                       const auto [stop, error] = std::from_chars(text.data(), end, value);
                       return error == std::errc() && stop == end && value >= least && value <= most;
                   });
}

NumberCheck number_within(double least, double most) {
    return checked_number(fmt::format("a number from {:g} to {:g}", least, most),
                          [least, most](double value) { return value >= least && value <= most; });
}

NumberCheck not_negative_number() {
    return checked_number("a number, 0 or more", [](double value) { return value >= 0; });
}

NumberCheck positive_number() {
    return checked_number("a number above 0", [](double value) { return value > 0; });
}

}  // namespace sherd
