// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/commands/commands.h"
#include "app/help/manual_page.h"
#include "app/messages/print.h"

namespace sherd {

void add_manual(CLI::App& program, Command& chosen) {
    CLI::App* command = program.add_subcommand("manual", "Print the manual page: the help of all commands");
    command->footer(
        "Installed packages contain it (man sherd). Without a package:\n"
        "  sherd manual | man -l -");
    command->callback([&chosen, &program] {
        chosen = [&program] {
            print_result("{}", manual_page(program));
            return 0;
        };
    });
}

}  // namespace sherd
