// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/scene/toml/range.h"

namespace sherd {

/// How the value of a key may be written. A key may have several forms: they are flags.
enum class Form : unsigned {
    number = 1,
    integer = 2,
    flag = 4,
    text = 8,
    file = 16,     ///< text that names a file, as seen from the scene's folder
    choice = 32,   ///< one of some names
    names = 64,    ///< an array of some of these names
    vector = 128,  ///< an array of three numbers
    pair = 256,    ///< an array of two numbers
    rows = 512,    ///< an array of arrays of numbers
    lists_of_rows = 1024,
    table = 2048,
    tables = 4096,  ///< an array of tables
    named = 8192    ///< a table of tables, whose keys are names of the user's own
};
constexpr Form operator|(Form a, Form b) {
    return static_cast<Form>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}
constexpr bool has_form(Form forms, Form one) {
    return (static_cast<unsigned>(forms) & static_cast<unsigned>(one)) != 0;
}

/// A choice that a key had once; without a name, the key itself, which its table had.
struct Retired {
    std::string_view name = {};
    std::string_view instead =
        {};  ///< what to use: "\"bdf2\" is of second order, too"; empty: nothing is retired
};

/// What the value of a key may be.
struct KeyRules {
    std::string_view unit = {};  ///< of numbers: "m"
    Range range = any_number;    ///< of numbers
    /// In the order of the enumeration that they stand for; of a bool, the first for true.
    std::span<const std::string_view> choices = {};
    std::string_view what = {};  ///< of text: "the name of a PNG file"
    bool required = false;
    std::string_view otherwise = {};  ///< what holds without the key, where that is no value of its struct
    std::array<std::string_view, 5> excludes = {};  ///< keys of the same table that conflict with it
    std::size_t least_rows = 1, columns = 2;        ///< of rows
    Retired retired = {};
};

/// What is known of a key without the struct that it is read into: for messages, help, completion and
/// schemas.
struct KeyInfo {
    std::string_view name;
    Form forms = Form::number;
    KeyRules rules = {};
    std::string_view sentence = {};  ///< what the key means, in Markdown
};

struct SectionText;

/// A key as its reference tells it.
struct KeyText {
    KeyInfo info;
    std::string fallback;             ///< as TOML: what holds without the key; empty: nothing that is a value
    std::vector<SectionText> inside;  ///< of a table: its keys, for each kind of table that it may be
};

/// A kind of table as its reference tells it.
struct SectionText {
    std::string_view title;
    std::vector<KeyText> keys;
};

}  // namespace sherd
