// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/help/completion.h"
#include "app/help/option_value.h"

namespace sherd {
namespace {

/// Escapes text for a description of _arguments or _describe that is within single quotes.
std::string quoted(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '\n') {
            result += ' ';
            continue;
        }
        if (c == '[' || c == ']' || c == ':' || c == '\\') result += '\\';
        result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    }
    return result;
}

/// Returns the action with which _arguments completes a value.
std::string action(const OptionValue& value) {
    switch (value.kind) {
        case OptionValue::Kind::words:
            return fmt::format("({})", fmt::join(value.words, " "));
        case OptionValue::Kind::file:
            if (value.words.empty()) return "_files";
            return fmt::format("_files -g \"*.({})(-.)\"", fmt::join(value.words, "|"));
        case OptionValue::Kind::scene:
            return "_sherd_scenes";
        case OptionValue::Kind::shipped_scene:
            return "_sherd_shipped_scenes";
        case OptionValue::Kind::setting:
            return "_sherd_settings";
        default:
            return " ";
    }
}

/// Returns an option in the form of _arguments: '(-o --output)'{-o,--output}'[description]:FILE:_files'.
std::string option_words(const CLI::Option& option) {
    std::vector<std::string> names = typed_names(option);
    const bool repeatable = option.get_expected_max() > 1;
    std::string value;
    if (const std::string name = value_name(option); !name.empty())
        value = fmt::format(":{}:{}", quoted(name), action(option_value(option)));
    const std::string excluded = fmt::format("'({})'", fmt::join(names, " "));
    for (std::string& name : names)
        // Allows both --option value and --option=value.
        if (name.starts_with("--") && !value.empty()) name += '=';
    const std::string description = fmt::format("[{}]", quoted(option.get_description()));
    if (names.size() == 1)
        return fmt::format("'{}{}{}{}'", repeatable ? "*" : "", names[0], description, value);
    return fmt::format("{}{{{}}}'{}{}'", repeatable ? "'*'" : excluded, fmt::join(names, ","), description,
                       value);
}

std::string option_lines(const CLI::App& command, const std::string& indent) {
    std::string lines;
    for (const CLI::Option* option : shown_options(command, false))
        lines += fmt::format(" \\\n{}{}", indent, option_words(*option));
    return lines;
}

std::string argument_lines(const CLI::App& command, const std::string& indent) {
    std::string lines;
    for (const CLI::Option* argument : shown_options(command, true))
        lines += fmt::format(" \\\n{}'{}:{}:{}'", indent, argument->get_required() ? "" : ":",
                             quoted(value_name(*argument)), action(option_value(*argument)));
    return lines;
}

constexpr const char* scene_functions =
    R"zsh(# The keys of scenes, each with the words that it may be, and with the names of the scene on the line.
_sherd_settings() {
    local -a arguments lines
    local key line
    arguments=(${words[2,-1]:#-*})
    lines=(${(f)"$(_call_program settings sherd scenes --settable ${(q)arguments[1]:--} 2>/dev/null)"})
    if ! compset -P 1 '*='; then
        compadd -S = -- ${lines%% *}
        return
    fi
    key=${${IPREFIX#--set=}%=}
    for line in $lines; do
        [[ ${line%% *} != $key ]] || compadd -- ${=${line#$key}}
    done
}

_sherd_shipped_scenes() {
    local -a names
    names=(${${(f)"$(_call_program scenes sherd scenes 2>/dev/null)"}%% *})
    compadd -a names
}

_sherd_scenes() {
    _alternative 'files:scene file:_files -g "*.toml(-.)"' 'scenes:shipped scene:_sherd_shipped_scenes'
}
)zsh";

constexpr const char* loading = R"zsh(
if [[ $funcstack[1] == _sherd ]]; then
    _sherd "$@" # loaded from the fpath
else
    compdef _sherd sherd # sourced
fi
)zsh";

}  // namespace

std::string zsh_completion(const CLI::App& program) {
    std::string descriptions, cases;
    for (const CLI::App* command : shown_commands(program)) {
        descriptions +=
            fmt::format("                '{}:{}'\n", command->get_name(), quoted(command->get_description()));
        cases += fmt::format(
            "                {})\n                    _arguments -s{}{} && outcome=0\n"
            "                    ;;\n",
            command->get_name(), option_lines(*command, std::string(24, ' ')),
            argument_lines(*command, std::string(24, ' ')));
    }
    return fmt::format(
        "#compdef sherd\n"
        "# Completion of sherd for zsh; 'sherd completion zsh' has made it from the program's own options.\n"
        "{}\n_sherd() {{\n"
        "    local curcontext=$curcontext state line outcome=1\n    local -a commands\n"
        "    typeset -A opt_args\n"
        "    _arguments -C{} \\\n        '1:command:->command' '*::argument:->arguments' && outcome=0\n"
        "    case $state in\n        command)\n            commands=(\n{}            )\n"
        "            _describe command commands && outcome=0\n            ;;\n"
        "        arguments)\n            case $words[1] in\n{}            esac\n            ;;\n    esac\n"
        "    return outcome\n}}\n{}",
        scene_functions, option_lines(program, std::string(8, ' ')), descriptions, cases, loading);
}

}  // namespace sherd
