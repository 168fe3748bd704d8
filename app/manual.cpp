// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/commands.h"
#include "app/help/manual_page.h"
#include "app/words/print.h"

namespace sherd {

void add_manual(CLI::App& program, Command& chosen) {
    CLI::App* command = program.add_subcommand("manual", "Print the manual page, all of this help in one");
    command->footer(
        "An installed package brings it along (man sherd). Elsewhere:\n"
        "  sherd manual | man -l -");
    command->callback([&chosen, &program] {
        chosen = [&program] {
            print_result("{}", manual_page(program));
            return 0;
        };
    });
}

}  // namespace sherd
