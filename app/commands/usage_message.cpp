// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/usage_message.h"

#include <fmt/format.h>

#include <vector>

#include "app/messages/nearest_name.h"

namespace sherd {
namespace {

std::vector<std::string> all_commands(const CLI::App& program) {
    std::vector<std::string> names;
    for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
        names.push_back(command->get_name());
    return names;
}

std::vector<std::string> all_options(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options())
        for (const std::string& name : option->get_lnames()) names.push_back(name);
    return names;
}

std::string hint(const std::string& nearest) {
    return nearest.empty() ? "" : fmt::format("; did you mean '{}'?", nearest);
}

/// Error for a word that is no command, option or argument, with the nearest known name.
std::string unknown_word(const CLI::App& program, const std::string& word) {
    const std::vector<CLI::App*> chosen = program.get_subcommands();
    const CLI::App& command = chosen.empty() ? program : *chosen.front();
    const std::string of = chosen.empty() ? "" : fmt::format(" of 'sherd {}'", command.get_name());
    if (word.starts_with("--")) {
        const std::string name = word.substr(2, word.find('=') - 2);
        const std::string nearest = nearest_name(name, all_options(command));
        return fmt::format("'--{}' is no option{}{}", name, of, hint(nearest.empty() ? "" : "--" + nearest));
    }
    if (word.starts_with('-')) return fmt::format("'{}' is no option{}", word, of);
    if (!chosen.empty()) return fmt::format("'{}' is one argument too many{}", word, of);
    return fmt::format("'{}' is no command{}", word, hint(nearest_name(word, all_commands(program))));
}

}  // namespace

std::string usage_message(const CLI::App* program, const CLI::Error& error) {
    const std::vector<std::string> left = program->remaining(true);
    std::string text;
    // A missing option may have been misspelt, so both errors are reported.
    if (left.empty() || error.get_exit_code() != static_cast<int>(CLI::ExitCodes::ExtrasError))
        text += fmt::format("sherd: error: {}\n", error.what());
    if (left.size() > 1 && left.front() == "--")
        text += fmt::format("sherd: error: '{}' is one argument too many: after '--' there are no options\n",
                            left[1]);
    else if (!left.empty())
        text += fmt::format("sherd: error: {}\n", unknown_word(*program, left.front()));
    const std::vector<CLI::App*> chosen = program->get_subcommands();
    return text + fmt::format("Run 'sherd {}--help' for more information.\n",
                              chosen.empty() ? "" : chosen.front()->get_name() + " ");
}

}  // namespace sherd
