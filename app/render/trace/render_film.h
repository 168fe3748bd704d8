// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>

#include "app/files/disk/pending_file.h"

namespace sherd {

/// A film (.mp4, H.264) that the program ffmpeg, a child process, makes from pictures. The file has another
/// name until it is complete, and is removed if it is never completed.
class RenderFilm {
  public:
    /// rate: pictures per second. Throws Error (input) if ffmpeg is not installed, or if the name does not
    /// end with .mp4.
    RenderFilm(std::filesystem::path file, double rate);
    ~RenderFilm();
    RenderFilm(const RenderFilm&) = delete;
    RenderFilm& operator=(const RenderFilm&) = delete;

    /// Adds a picture, the bytes of a PNG file. Throws Error (run) if ffmpeg has ended.
    void add(const std::string& png);
    /// Ends the film and gives the file its name. Throws Error (run) if ffmpeg fails, Error (input) if the
    /// file exists and `replace` is false.
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
