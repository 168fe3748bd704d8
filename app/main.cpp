// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <malloc.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <string_view>

#include "app/commands.h"
#include "app/progress/interruption.h"
#include "app/usage_message.h"
#include "meshops/error.h"

namespace {

constexpr int done = 0, failed = 1, bad_input = 2;

/// Arrays of whole sheets come and go in every step. Given back to the system each time, their pages would
/// have to be cleared and mapped anew, which takes as long as what is done with them.
void keep_freed_memory() {
    constexpr int largest_kept = 1 << 27, most_kept = 1 << 30;  // bytes
    ::mallopt(M_MMAP_THRESHOLD, largest_kept);
    ::mallopt(M_TRIM_THRESHOLD, most_kept);
}

int report(std::string_view message, int exit_code) {
    while (!message.empty()) {
        const std::string_view line = message.substr(0, message.find('\n'));
        fmt::print(stderr, "sherd: error: {}\n", line);
        message.remove_prefix(std::min(line.size() + 1, message.size()));
    }
    return exit_code;
}

int run(const sherd::Command& command) {
    try {
        const int exit_code = command();
        if (std::fflush(stdout) != 0) return report("cannot write to standard output", failed);
        return exit_code;
    } catch (const sherd::Error& error) {
        return report(error.what(), error.fault == sherd::Fault::input ? bad_input : failed);
    } catch (const std::bad_alloc&) {
        return report("there is not enough memory for this", failed);
    } catch (const std::exception& error) {
        return report(error.what(), failed);
    }
}

}  // namespace

// NOLINTNEXTLINE(bugprone-exception-escape): before run() catches them, only a lack of memory could throw.
int main(int argc, char** argv) {
    keep_freed_memory();
    std::signal(SIGXFSZ, SIG_IGN);  // a file size limit is an error like a full disk
    sherd::end_on_interruption();
    CLI::App program(
        "Sherd breaks plates and shells: a scene goes in, fragments and the crack history come out.",
        "sherd");
    program.set_version_flag("--version", "sherd " SHERD_VERSION);
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
    sherd::add_bench(program, chosen);
    sherd::add_converge(program, chosen);
    sherd::add_render(program, chosen);
    sherd::add_plot(program, chosen);
    sherd::add_view(program, chosen);
    sherd::add_mesh(program, chosen);
    sherd::add_scenes(program, chosen);
    sherd::add_completion(program, chosen);
    sherd::add_manual(program, chosen);
    program.require_subcommand(0, 1);
    program.failure_message(sherd::usage_message);
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return program.exit(error) == 0 ? done : bad_input;
    } catch (const sherd::Error& error) {
        return report(error.what(), bad_input);
    }
    if (!chosen) {
        fmt::print(stderr, "{}", program.help());
        return bad_input;
    }
    return run(chosen);
}
