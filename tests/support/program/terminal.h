// SPDX-License-Identifier: GPL-3.0-or-later
// Classes to run a program on a terminal and see its output there.
#pragma once

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace sherd::test {

/// Screen of a terminal after the bytes sent to it, as far as Sherd uses its controls.
class Screen {
  public:
    explicit Screen(std::size_t columns, std::size_t rows = 24) : columns(columns), rows(rows), lines(1) {}

    /// Throws std::runtime_error for an unsupported control.
    void add(const std::string& bytes) {
        for (const char byte : bytes) add(byte);
    }

    /// All text ever shown, from the top, without spaces at the ends of lines.
    std::vector<std::string> text() const {
        std::vector<std::string> result = lines;
        for (std::string& line : result) line.erase(line.find_last_not_of(' ') + 1);
        while (!result.empty() && result.back().empty()) result.pop_back();
        return result;
    }

    std::size_t column = 0;
    std::vector<std::string> wrapped;  ///< lines that were too long, cut at the width of the screen

  private:
    void add(char byte) {
        if (!escape.empty())
            add_to_escape(byte);
        else if (byte == '\x1b')
            escape = byte;
        else if (byte == '\r')
            column = 0;
        else if (byte == '\n')
            column = 0, down();
        else if (static_cast<unsigned char>(byte) < ' ')
            throw std::runtime_error("unknown control character " + std::to_string(byte));
        else
            put(byte);
    }

    void add_to_escape(char byte) {
        escape += byte;
        if (escape.size() < 3 || (byte >= '0' && byte <= '9')) return;
        const std::size_t count = escape.size() > 3 ? std::stoul(escape.substr(2)) : 1;
        if (escape == "\x1b[K") {
            lines[row].resize(column, ' ');
        } else if (escape == "\x1b[J") {
            lines[row].resize(column, ' ');
            lines.resize(row + 1);
        } else if (byte == 'A') {
            const std::size_t top = lines.size() > rows ? lines.size() - rows : 0;
            row = row > top + count ? row - count : top;
        } else {
            throw std::runtime_error("unknown escape " + escape.substr(1));
        }
        escape.clear();
    }

    void put(char byte) {
        if (column == columns) {
            wrapped.push_back(lines[row]);
            column = 0;
            down();
        }
        if (lines[row].size() <= column) lines[row].resize(column + 1, ' ');
        lines[row][column++] = byte;
    }

    void down() {
        if (++row == lines.size()) lines.emplace_back();
    }

    std::size_t columns, rows, row = 0;
    std::vector<std::string> lines;
    std::string escape;
};

/// Opens a pseudo terminal and returns its descriptor; negative on machines without any, for example where
/// /dev/pts is not mounted.
inline int open_pseudo_terminal() {
    const int terminal = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
    if (terminal < 0) return terminal;
    if (grantpt(terminal) == 0 && unlockpt(terminal) == 0) return terminal;
    close(terminal);
    return -1;
}

/// Sherd on a pseudo terminal of the test; the destructor kills the program if it still runs.
class TerminalProgram {
  public:
    TerminalProgram(std::vector<std::string> arguments, const std::filesystem::path& directory,
                    unsigned short columns, const std::string& kind = "xterm")
        : terminal(open_pseudo_terminal()) {
        if (terminal < 0) throw std::runtime_error("cannot make a pseudo terminal");
        resize(columns);
        const std::string name = ptsname(terminal);
        process = fork();
        if (process < 0) throw std::runtime_error("cannot fork");
        if (process == 0) become(arguments, directory, name, kind);
    }
    ~TerminalProgram() {
        if (process > 0) {
            kill(process, SIGKILL);
            waitpid(process, nullptr, 0);
        }
        close(terminal);
    }
    TerminalProgram(const TerminalProgram&) = delete;
    TerminalProgram& operator=(const TerminalProgram&) = delete;

    /// Reads and returns the program's output until `enough` returns true for the output since this call, or
    /// until the program ends. Ends of lines are "\n".
    std::string read_until(const std::function<bool(const std::string&)>& enough) {
        std::string text;
        while (!enough(without_carriage(text)))
            if (!read_some(text)) {
                wait();
                break;
            }
        return without_carriage(text);
    }
    std::string read_to_end() {
        return read_until([](const std::string&) { return false; });
    }

    /// Sends keys as if they were pressed.
    void type(const std::string& keys) const {
        if (write(terminal, keys.data(), keys.size()) != static_cast<ssize_t>(keys.size()))
            throw std::runtime_error("cannot type");
    }

    void resize(unsigned short columns) const {
        const winsize size{24, columns, 0, 0};
        if (ioctl(terminal, TIOCSWINSZ, &size) != 0) throw std::runtime_error("cannot resize the terminal");
    }

    /// Resizes the terminal while the program is stopped, so that all earlier output has the old width.
    /// Returns the part of this output that has not been read yet.
    std::string resize_at_rest(unsigned short columns) {
        kill(process, SIGSTOP);
        waitpid(process, nullptr, WUNTRACED);
        std::string text;
        // On Linux poll() first delivers output that is still in the terminal's buffer.
        for (pollfd waiting{terminal, POLLIN, 0}; poll(&waiting, 1, 0) > 0 && read_some(text);) continue;
        resize(columns);
        kill(process, SIGCONT);
        return without_carriage(text);
    }

    int exit_code = -1;  ///< after the program's end; after a signal 128 + signal

  private:
    [[noreturn]] static void become(std::vector<std::string>& arguments,
                                    const std::filesystem::path& directory, const std::string& name,
                                    const std::string& kind) {
        setsid();
        const int side = open(name.c_str(), O_RDWR);  // becomes the controlling terminal
        for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(side, descriptor);
        std::string program = SHERD_PROGRAM;
        std::vector<char*> pointers{program.data()};
        for (std::string& argument : arguments) pointers.push_back(argument.data());
        pointers.push_back(nullptr);
        setenv("TERM", kind.c_str(), 1);
        if (chdir(directory.c_str()) == 0) execv(pointers[0], pointers.data());
        _exit(127);
    }

    /// Replaces "\r\n" by "\n", since the terminal writes the former.
    static std::string without_carriage(std::string text) {
        for (std::size_t at = text.find("\r\n"); at != std::string::npos; at = text.find("\r\n", at))
            text.erase(at, 1);
        return text;
    }

    /// Adds output to `text`. Returns false when no process has the terminal open any more.
    bool read_some(std::string& text) const {
        std::array<char, 4096> buffer;
        ssize_t count;
        do count = read(terminal, buffer.data(), buffer.size());
        while (count < 0 && errno == EINTR);
        if (count > 0) text.append(buffer.data(), static_cast<std::size_t>(count));
        return count > 0;
    }

    void wait() {
        int status = 0;
        if (process == 0 || waitpid(process, &status, 0) != process) return;
        exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
        process = 0;
    }

    int terminal;  ///< the test's end of the pseudo terminal
    pid_t process = 0;
};

}  // namespace sherd::test
