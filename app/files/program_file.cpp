// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/program_file.h"

#include <fstream>
#include <iterator>

namespace sherd {
namespace {

namespace fs = std::filesystem;

constexpr const char* this_process = "/proc/self/exe";

std::optional<BundledProgram> this_bundled_program() {
    return bundled_program(fs::read_symlink(this_process));
}

}  // namespace

std::optional<BundledProgram> bundled_program(const fs::path& running) {
    fs::path code = running;
    code += ".program";
    std::error_code unreadable;  // an error means that this is no bundle
    if (!fs::is_regular_file(code, unreadable)) return std::nullopt;
    return BundledProgram{code, running.parent_path().parent_path() / "bin" / running.filename()};
}

fs::path program_file() {
    const std::optional<BundledProgram> bundled = this_bundled_program();
    return bundled ? bundled->code : fs::path(this_process);
}

fs::path program_to_start() {
    const std::optional<BundledProgram> bundled = this_bundled_program();
    return bundled ? bundled->launcher : fs::path(this_process);
}

std::string python_to_start() {
    if (const std::optional<BundledProgram> bundled = this_bundled_program()) {
        fs::path python = bundled->launcher.parent_path() / "sherd-python";
        std::error_code unreadable;  // an error means that the file does not exist
        if (fs::exists(python, unreadable)) return python.string();
    }
    return "python3";
}

std::string command_words() {
    std::ifstream stream("/proc/self/cmdline", std::ios::binary);
    std::string words(std::istreambuf_iterator<char>(stream), {});
    const std::optional<BundledProgram> bundled = this_bundled_program();
    if (!bundled) return words;
    const std::size_t code = words.find('\0' + bundled->code.string() + '\0');
    if (code == std::string::npos) return words;
    return bundled->launcher.string() + words.substr(code + 1 + bundled->code.string().size());
}

}  // namespace sherd
