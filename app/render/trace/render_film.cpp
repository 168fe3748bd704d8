// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/trace/render_film.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <utility>
#include <vector>

#include "app/machine/exit_code.h"
#include "meshops/error.h"

namespace sherd {
namespace {

std::filesystem::path checked(std::filesystem::path file) {
    if (file.extension() != ".mp4")
        throw Error(fmt::format("--film {}: the name must end with .mp4", file.string()));
    return file;
}

std::vector<std::string> command_line(const std::filesystem::path& file, double rate) {
    return {"ffmpeg", "-loglevel", "error", "-y", "-f", "image2pipe", "-framerate", fmt::format("{}", rate),
            "-c:v", "png", "-i", "pipe:0", "-c:v", "libx264", "-crf", "16",
            // H.264 with colours at half the resolution, which all players support, requires even sizes.
            "-pix_fmt", "yuv420p", "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-movflags", "+faststart", "-f",
            "mp4",
            // The prefix allows names that begin with a dash or have a colon.
            "file:" + file.string()};
}

/// Starts the program arguments[0], with the descriptor `input` as its standard input. Returns 0 or an errno
/// value.
int spawn(std::vector<std::string> arguments, int input, pid_t& child) {
    std::vector<char*> pointers;
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    const int error = posix_spawnp(&child, pointers[0], &actions, nullptr, pointers.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    return error;
}

/// Whether an MP4 file is complete: its boxes (ISO 14496-12) end where the file ends, and include the box
/// "moov", with which players begin. ffmpeg reports success even if the disk was full at the end.
bool is_whole(const std::filesystem::path& film) {
    std::ifstream in(film, std::ios::binary);
    const std::uint64_t size = std::filesystem::file_size(film);
    bool has_movie = false;
    std::uint64_t at = 0;
    while (at < size) {
        std::array<unsigned char, 16> head{};
        in.seekg(static_cast<std::streamoff>(at));
        in.read(reinterpret_cast<char*>(head.data()), head.size());
        const auto number = [&](int from, int bytes) {
            std::uint64_t value = 0;
            for (int i = from; i < from + bytes; ++i) value = value << 8 | head[i];
            return value;
        };
        const std::uint64_t length = number(0, 4) == 1 ? number(8, 8) : number(0, 4);
        if (length < 8 || length > size - at) return false;
        has_movie |= std::memcmp(&head[4], "moov", 4) == 0;
        in.clear();
        at += length;
    }
    return has_movie;
}

}  // namespace

RenderFilm::RenderFilm(std::filesystem::path file_, double rate)
    : file(checked(std::move(file_))), lock(file), pending(lock, Fault::input) {
    std::signal(SIGPIPE, SIG_IGN);  // if the child has ended, write() reports an error
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0)
        throw Error(fmt::format("cannot start ffmpeg: {}", std::strerror(errno)), Fault::run);
    const int error = spawn(command_line(pending.path(), rate), ends[0], child);
    ::close(ends[0]);
    pipe_end = ends[1];
    if (error == 0) return;
    close_pipe();
    child = -1;
    if (error == ENOENT)
        throw Error(fmt::format(
            "--film {}: the program ffmpeg is not installed; install it (Debian: ffmpeg), or leave "
            "out --film",
            file.string()));
    throw Error(fmt::format("cannot start ffmpeg: {}", std::strerror(error)), Fault::run);
}

RenderFilm::~RenderFilm() {
    if (child < 0) return;
    ::kill(child, SIGKILL);
    close_pipe();
    wait();
}

void RenderFilm::close_pipe() {
    if (pipe_end >= 0) ::close(std::exchange(pipe_end, -1));
}

int RenderFilm::wait() {
    int status = 0;
    pid_t ended;
    do ended = ::waitpid(child, &status, 0);
    while (ended < 0 && errno == EINTR);
    child = -1;
    return exit_code_of(status);
}

void RenderFilm::add(const std::string& png) {
    for (std::size_t done = 0; done < png.size();) {
        const ssize_t count = ::write(pipe_end, png.data() + done, png.size() - done);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0)
            throw Error(
                fmt::format("ffmpeg stopped writing the film '{}', for the reason above", file.string()),
                Fault::run);
        done += static_cast<std::size_t>(count);
    }
}

void RenderFilm::publish(bool replace) {
    close_pipe();
    if (const int code = wait())
        throw Error(
            fmt::format("ffmpeg could not make the film '{}' (its exit code: {})", file.string(), code),
            Fault::run);
    if (!is_whole(pending.path()))
        throw Error(
            fmt::format("ffmpeg could not write all of the film '{}'; the disk may be full", file.string()),
            Fault::run);
    pending.publish(replace);
}

}  // namespace sherd
