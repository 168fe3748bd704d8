// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/scene/toml/range.h"

namespace sherd {

/// Form of the value of a key. A key may have several forms: they are flags.
enum class Form : unsigned {
    number = 1,
    integer = 2,
    flag = 4,
    text = 8,
    file = 16,     ///< name of a file, relative to the scene's folder
    choice = 32,   ///< a name from a list
    names = 64,    ///< an array of names from a list
    vector = 128,  ///< an array of three numbers
    pair = 256,    ///< an array of two numbers
    rows = 512,    ///< an array of arrays of numbers
    lists_of_rows = 1024,
    table = 2048,
    tables = 4096,  ///< an array of tables
    named = 8192,   ///< a table of tables with names that the user chooses
    name = 16384    ///< a text of name_characters, which does not begin with -
};
/// Characters of names that become a part of the name of a file or a group.
inline constexpr std::string_view name_characters =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";

constexpr Form operator|(Form a, Form b) {
    return static_cast<Form>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}
constexpr bool has_form(Form forms, Form one) {
    return (static_cast<unsigned>(forms) & static_cast<unsigned>(one)) != 0;
}

/// A value that a key could have in earlier versions or, without a name, a key that existed then.
struct Retired {
    std::string_view name = {};
    std::string_view instead = {};  ///< replacement, as advice to the user; empty: nothing is retired
};

/// Rules for the value of a key.
struct KeyRules {
    std::string_view unit = {};  ///< unit of numbers: "m"
    Range range = any_number;    ///< allowed range of numbers
    /// Allowed names, in the order of the enumeration; for a bool, the first means true.
    std::span<const std::string_view> choices = {};
    std::string_view what = {};  ///< description of a text or a file, for messages: "the name of a PNG file"
    bool required = false;
    std::string_view otherwise = {};                ///< default in words, where the struct's own initial
                                                    ///< value is not the default
    std::array<std::string_view, 5> excludes = {};  ///< keys of the same table that conflict with it
    std::size_t least_rows = 1, columns = 2;        ///< least number of rows of an array, and number of
                                                    ///< columns
    std::size_t most_rows = 0;                      ///< largest number of rows; 0: any
    Retired retired = {};
};

/// The part of a Key that does not depend on a Struct: for messages, help, completion and schemas.
struct KeyInfo {
    std::string_view name;
    Form forms = Form::number;
    KeyRules rules = {};
    std::string_view sentence = {};  ///< meaning of the key, in Markdown
};

struct SectionText;

/// A key as the reference documents it.
struct KeyText {
    KeyInfo info;
    std::string fallback;             ///< default, as TOML; empty: there is none, or only KeyRules::otherwise
    std::vector<SectionText> inside;  ///< if the value is a table: the kinds of table that it may be
};

/// A kind of table as the reference documents it.
struct SectionText {
    std::string_view title;
    std::vector<KeyText> keys;
    std::vector<Retired> retired = {};  ///< keys of earlier versions
};

}  // namespace sherd
