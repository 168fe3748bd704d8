// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/help/completion.h"
#include "app/help/option_value.h"

namespace sherd {
namespace {

/// Returns a value as arguments of the script's function _sherd_offer: the kind of value, then its words.
std::string value_text(const OptionValue& value) {
    switch (value.kind) {
        case OptionValue::Kind::words:
            return fmt::format("words {}", fmt::join(value.words, " "));
        case OptionValue::Kind::file:
            return fmt::format("file {}", fmt::join(value.words, " "));
        case OptionValue::Kind::scene:
            return "scene";
        case OptionValue::Kind::shipped_scene:
            return "shipped_scene";
        case OptionValue::Kind::setting:
            return "setting";
        default:
            return "anything";
    }
}

std::string command_words(const CLI::App& program) {
    std::vector<std::string> names;
    for (const CLI::App* command : shown_commands(program)) names.push_back(command->get_name());
    return fmt::format("{}", fmt::join(names, " "));
}

std::string option_words(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : shown_options(command, false))
        for (const std::string& name : typed_names(*option)) names.push_back(name);
    return fmt::format("{}", fmt::join(names, " "));
}

/// Adds the options and arguments of `command` to `table`, the cases of the script's function _sherd_value: a
/// line for each option that has a value, and a line for each argument by its number.
void add_values(std::string& table, const CLI::App& command) {
    const auto add = [&](const std::string& name, const CLI::Option& option) {
        table += fmt::format("        '{} {}') echo '{}' ;;\n", command.get_name(), name,
                             value_text(option_value(option)));
    };
    for (const CLI::Option* option : shown_options(command, false))
        if (!value_name(*option).empty())
            for (const std::string& name : typed_names(*option)) add(name, *option);
    int number = 0;
    for (const CLI::Option* argument : shown_options(command, true)) add(std::to_string(++number), *argument);
}

constexpr const char* functions = R"bash(
# The files and folders that begin with $1, of the extensions that follow, or all.
_sherd_files() {
    local start=$1 extension
    shift
    if (($# == 0)); then
        compgen -f -- "$start"
        return
    fi
    compgen -d -- "$start"
    for extension; do
        compgen -f -X "!*.$extension" -- "$start"
    done
}

# The keys of scenes, each with the words that it may be, and with the names of the scene in $1.
_sherd_settings() { "${COMP_WORDS[0]}" scenes --settable "$1" 2>/dev/null; }

# $1 KIND WORD...: what a value that begins with $1 may be.
_sherd_offer() {
    local start=$1 kind=$2
    shift 2
    case $kind in
        words) compgen -W "$*" -- "$start" ;;
        file) _sherd_files "$start" "$@" ;;
        scene)
            _sherd_files "$start" toml
            _sherd_offer "$start" shipped_scene
            ;;
        setting) compgen -S = -W "$(_sherd_settings "$1" | sed 's/ .*//')" -- "$start" ;;
        value) compgen -W "$(_sherd_settings "$1" | sed -n "s/^$2 //p")" -- "$start" ;;
        shipped_scene) compgen -W "$("${COMP_WORDS[0]}" scenes 2>/dev/null | sed 's/ .*//')" -- "$start" ;;
    esac
}

_sherd() {
    local current=${COMP_WORDS[COMP_CWORD]} command='' expects='' arguments=0 at word scene='' key=''
    COMPREPLY=()
    for ((at = 1; at < COMP_CWORD; ++at)); do
        word=${COMP_WORDS[at]}
        if [[ $word == = ]]; then # bash makes three words of --option=value and of KEY=VALUE
            [[ -z $key ]] || expects="value $key"
            continue
        fi
        key=''
        if [[ -n $expects ]]; then
            [[ $expects != setting ]] || key=$word
            expects=''
        elif [[ $word == -* ]]; then
            expects=$(_sherd_value "$command $word")
        elif [[ -z $command ]]; then
            command=$word
        else
            ((++arguments))
            [[ -n $scene ]] || scene=$word
        fi
    done
    [[ $current != = || -z $key ]] || expects="value $key"
    [[ $expects != setting && $expects != value* ]] || expects="${expects%% *} ${scene:--} ${expects#* }"
    [[ $current != = ]] || current=''
    if [[ -z $expects && $current == -* ]]; then
        expects="words $(_sherd_options "$command")"
    elif [[ -z $expects && -z $command ]]; then
        expects="words $_sherd_commands"
    elif [[ -z $expects ]]; then
        expects=$(_sherd_value "$command $((arguments + 1))")
    fi
    [[ -n $expects ]] || expects="words $(_sherd_options "$command")"
    [[ $expects != file* && $expects != scene ]] || compopt -o filenames
    [[ $expects != setting* ]] || compopt -o nospace
    mapfile -t COMPREPLY < <(_sherd_offer "$current" $expects)
}

complete -F _sherd sherd
)bash";

}  // namespace

std::string bash_completion(const CLI::App& program) {
    std::string options, values;
    for (const CLI::App* command : shown_commands(program)) {
        options += fmt::format("        {}) echo '{}' ;;\n", command->get_name(), option_words(*command));
        add_values(values, *command);
    }
    return fmt::format(
        "# Completion of sherd for bash; 'sherd completion bash' has made it from the program's own "
        "options.\n"
        "_sherd_commands='{}'\n\n"
        "# The options of a command.\n"
        "_sherd_options() {{\n    case $1 in\n        '') echo '{}' ;;\n{}    esac\n}}\n\n"
        "# \"COMMAND --option\" or \"COMMAND number_of_argument\": what its value may be; nothing for a "
        "flag.\n"
        "_sherd_value() {{\n    case $1 in\n{}    esac\n}}\n{}",
        command_words(program), option_words(program), options, values, functions);
}

}  // namespace sherd
