// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/help/completion.h"

#include <fmt/format.h>

#include <memory>

#include "app/commands/commands.h"
#include "app/messages/print.h"
#include "meshops/error.h"

namespace sherd {

void add_completion(CLI::App& program, Command& chosen) {
    CLI::App* command = program.add_subcommand("completion", "Print the script for completion in a shell");
    auto shell = std::make_shared<std::string>();
    command->add_option("shell", *shell, "The shell")->required()->option_text("bash|zsh");
    command->footer(
        "Installed packages contain these scripts. Without a package:\n"
        "  source <(sherd completion bash)                # in ~/.bashrc\n"
        "  source <(sherd completion zsh)                 # in ~/.zshrc, after compinit");
    command->callback([&chosen, &program, shell] {
        chosen = [&program, shell] {
            if (*shell != "bash" && *shell != "zsh")
                throw Error(fmt::format("completion is for bash and zsh, not for '{}'", *shell));
            print_result("{}", *shell == "bash" ? bash_completion(program) : zsh_completion(program));
            return 0;
        };
    });
}

}  // namespace sherd
