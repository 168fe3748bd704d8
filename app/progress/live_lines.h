// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace sherd {

/// Lines at the bottom of the terminal of stderr, which are drawn over themselves. Between two drawings the
/// cursor stands at the beginning of the last line, where echoed keys cannot wrap it.
class LiveLines {
  public:
    LiveLines();
    /// Leaves the lines in place and moves to a line of its own below them.
    ~LiveLines();
    LiveLines(const LiveLines&) = delete;
    LiveLines& operator=(const LiveLines&) = delete;

    /// Whether stderr is a terminal that can do this; otherwise all members do nothing.
    bool possible() const { return terminal; }
    /// Number of columns of the terminal now; 80 if unknown.
    std::size_t columns() const;

    /// lines: each shorter than columns(). Lines that do not fit into the terminal's rows are left out.
    void draw(std::vector<std::string> lines);
    /// Removes the lines, so that something else can be printed in their place.
    void clear();
    /// Leaves the lines in place: the next ones are drawn below them.
    void leave();

  private:
    std::size_t rows() const;
    std::string to_first_line() const;

    bool terminal;
    std::size_t drawn = 0;  ///< number of lines on the terminal
};

}  // namespace sherd
