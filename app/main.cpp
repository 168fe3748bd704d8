// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/commands.h"
#include "app/commands/program.h"
#include "meshops/error.h"

// NOLINTNEXTLINE(bugprone-exception-escape): before run_program(), only a lack of memory could throw.
int main(int argc, char** argv) {
    sherd::prepare_process();
    CLI::App program(
        "Sherd breaks plates and shells: a scene goes in, fragments and the crack history come out.",
        "sherd");
    program.footer("Example:\n  sherd run plate_drop -o plate.h5");
    sherd::Command chosen;
    sherd::add_run(program, chosen);
    sherd::add_sweep(program, chosen);
    sherd::add_check(program, chosen);
    sherd::add_modes(program, chosen);
    sherd::add_info(program, chosen);
    sherd::add_export(program, chosen);
    sherd::add_cut(program, chosen);
    sherd::add_probe(program, chosen);
    sherd::add_converge(program, chosen);
    sherd::add_render(program, chosen);
    sherd::add_plot(program, chosen);
    sherd::add_view(program, chosen);
    sherd::add_mesh(program, chosen);
    sherd::add_scenes(program, chosen);
    sherd::add_completion(program, chosen);
    sherd::add_manual(program, chosen);
    program.add_subcommand("bench")->group("")->prefix_command()->callback(
        [] { throw sherd::Error("bench is a program of its own: sherd-bench, in the build folder"); });
    program.require_subcommand(0, 1);
    return sherd::run_program(program, chosen, argc, argv);
}
