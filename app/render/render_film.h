// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>

#include "app/files/pending_file.h"

namespace sherd {

/// A film (.mp4, H.264) that the program ffmpeg makes from pictures, as a child process without a shell.
/// Under another name until it is complete, and removed if it never is.
class RenderFilm {
  public:
    /// rate: pictures a second. Throws Error (input) when ffmpeg is not installed or the file is no .mp4.
    RenderFilm(std::filesystem::path file, double rate);
    ~RenderFilm();
    RenderFilm(const RenderFilm&) = delete;
    RenderFilm& operator=(const RenderFilm&) = delete;

    /// Adds a picture, the bytes of a PNG file. Throws Error (run) when ffmpeg has given up.
    void add(const std::string& png);
    /// Ends the film and gives it its name. Throws Error (run) when ffmpeg fails.
    void publish(bool replace);

  private:
    void close_pipe();
    /// ffmpeg's exit code; 128 + signal when a signal ended it.
    int wait();

    std::filesystem::path file;
    OutputLock lock;
    PendingFile pending;
    int pipe_end = -1;
    pid_t child = -1;
};

}  // namespace sherd
