// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>

#include "app/files/disk/pending_file.h"

namespace sherd {

/// A film (.mp4, H.264) that the program ffmpeg makes from pictures, as a child process without a shell. The
/// file has another name until it is complete, and is removed if it never is.
class RenderFilm {
  public:
    /// rate: pictures a second. Throws Error (input) when ffmpeg is not installed or the file is no .mp4.
    RenderFilm(std::filesystem::path file, double rate);
    ~RenderFilm();
    RenderFilm(const RenderFilm&) = delete;
    RenderFilm& operator=(const RenderFilm&) = delete;

    /// Adds a picture, the bytes of a PNG file. Throws Error (run) if ffmpeg has ended.
    void add(const std::string& png);
    /// Ends the film and gives the file its name. Throws Error (run) if ffmpeg fails.
    void publish(bool replace);

  private:
    void close_pipe();
    /// Waits for the end of ffmpeg. Returns its exit code; 128 + signal if a signal ended it.
    int wait();

    std::filesystem::path file;
    OutputLock lock;
    PendingFile pending;
    int pipe_end = -1;
    pid_t child = -1;
};

}  // namespace sherd
