// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/program.h"

#include <fcntl.h>
#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <string_view>

#include "app/commands/usage_message.h"
#include "app/messages/build_info.h"
#include "app/messages/print.h"
#include "app/progress/interruption.h"
#include "meshops/error.h"

namespace sherd {
namespace {

constexpr int done = 0, failed = 1, bad_input = 2;

/// Makes malloc() keep freed memory. Every step allocates and frees arrays as long as the sheets. If they
/// were given back to the system each time, their pages would have to be cleared and mapped again, which
/// takes as long as the computations with them.
void keep_freed_memory() {
    constexpr int largest_kept = 1 << 27, most_kept = 1 << 30;  // bytes
    ::mallopt(M_MMAP_THRESHOLD, largest_kept);
    ::mallopt(M_TRIM_THRESHOLD, most_kept);
}

/// Opens closed standard streams on /dev/null, so that no other file gets their descriptors.
void keep_standard_streams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (::fcntl(stream, F_GETFD) < 0) ::open("/dev/null", O_RDONLY);
}

int report(const std::string& name, std::string_view message, int exit_code) {
    while (!message.empty()) {
        const std::string_view line = message.substr(0, message.find('\n'));
        print_message("{}: error: {}\n", name, line);
        message.remove_prefix(std::min(line.size() + 1, message.size()));
    }
    return exit_code;
}

/// Whether all results could be written; reports an error if not.
bool results_are_written(const std::string& name) {
    if (finish_results()) return true;
    report(name, "cannot write to standard output", failed);
    return false;
}

int run(const std::string& name, const Command& command) {
    try {
        const int exit_code = command();
        return results_are_written(name) ? exit_code : failed;
    } catch (const Error& error) {
        return report(name, error.what(), error.fault == Fault::input ? bad_input : failed);
    } catch (const std::bad_alloc&) {
        return report(name, "there is not enough memory", failed);
    } catch (const std::exception& error) {
        return report(name, error.what(), failed);
    }
}

}  // namespace

void prepare_process() {
    keep_freed_memory();
    keep_standard_streams();
    std::signal(SIGPIPE, SIG_IGN);  // a closed pipe on stdout does not end a run
    std::signal(SIGXFSZ, SIG_IGN);  // a file size limit is an error like a full disk
    end_on_interruption();
}

int run_program(CLI::App& program, const Command& chosen, int argc, char** argv) {
    const std::string name = program.get_name();
    program.set_version_flag("--version", "sherd " SHERD_VERSION "\n" + build_info());
    program.failure_message(usage_message);
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (program.exit(error) != 0) return bad_input;
        return results_are_written(name) ? done : failed;
    } catch (const Error& error) {
        return report(name, error.what(), bad_input);
    }
    if (!chosen) {
        print_message("{}", program.help());
        return bad_input;
    }
    return run(name, chosen);
}

}  // namespace sherd
