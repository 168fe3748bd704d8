// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <string_view>

#include "app/commands.h"
#include "app/progress/interruption.h"
#include "app/usage_message.h"
#include "app/words/build_info.h"
#include "app/words/print.h"
#include "meshops/error.h"

namespace {

constexpr int done = 0, failed = 1, bad_input = 2;

/// Arrays of whole sheets come and go in every step. Given back to the system each time, their pages would
/// have to be cleared and mapped again, which takes as long as what is done with them.
void keep_freed_memory() {
    constexpr int largest_kept = 1 << 27, most_kept = 1 << 30;  // bytes
    ::mallopt(M_MMAP_THRESHOLD, largest_kept);
    ::mallopt(M_TRIM_THRESHOLD, most_kept);
}

/// Makes a standard stream that was closed one that cannot be written: no file may get its number.
void keep_standard_streams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (::fcntl(stream, F_GETFD) < 0) ::open("/dev/null", O_RDONLY);
}

int report(std::string_view message, int exit_code) {
    while (!message.empty()) {
        const std::string_view line = message.substr(0, message.find('\n'));
        sherd::print_message("sherd: error: {}\n", line);
        message.remove_prefix(std::min(line.size() + 1, message.size()));
    }
    return exit_code;
}

/// Whether all results could be written; reports an error if not.
bool results_are_written() {
    if (sherd::finish_results()) return true;
    report("cannot write to standard output", failed);
    return false;
}

int run(const sherd::Command& command) {
    try {
        const int exit_code = command();
        return results_are_written() ? exit_code : failed;
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
    keep_standard_streams();
    std::signal(SIGPIPE, SIG_IGN);  // a closed pipe on stdout does not end a run
    std::signal(SIGXFSZ, SIG_IGN);  // a file size limit is an error like a full disk
    sherd::end_on_interruption();
    CLI::App program(
        "Sherd breaks plates and shells: a scene goes in, fragments and the crack history come out.",
        "sherd");
    program.set_version_flag("--version", "sherd " SHERD_VERSION "\n" + sherd::build_info());
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
        if (program.exit(error) != 0) return bad_input;
        return results_are_written() ? done : failed;
    } catch (const sherd::Error& error) {
        return report(error.what(), bad_input);
    }
    if (!chosen) {
        sherd::print_message("{}", program.help());
        return bad_input;
    }
    return run(chosen);
}
