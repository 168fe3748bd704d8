// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace sherd {

/// Lines at the bottom of the terminal of stderr. Each drawing replaces the previous one. Between two
/// drawings the cursor stands at the beginning of the last line, where echoed keys cannot make the line wrap.
class LiveLines {
  public:
    LiveLines();
    /// Leaves the lines in place, and moves the cursor to a new line below them.
    ~LiveLines();
    LiveLines(const LiveLines&) = delete;
    LiveLines& operator=(const LiveLines&) = delete;

    /// Whether stderr is a terminal that can move its cursor; if not, draw(), clear() and leave() do nothing.
    bool possible() const { return terminal; }
    /// Returns the number of columns of the terminal now; 80 if unknown.
    std::size_t columns() const;

    /// Draws lines, each of which must be shorter than columns(). Lines that do not fit into the terminal's
    /// rows are left out.
    void draw(std::vector<std::string> lines);
    /// Removes the lines, so that something else can be printed in their place.
    void clear();
    /// Leaves the lines in place; the next drawing is below them.
    void leave();

  private:
    std::size_t rows() const;
    std::string to_first_line() const;

    bool terminal;
    std::size_t drawn = 0;  ///< number of lines on the terminal
};

}  // namespace sherd
