// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace sherd {

/// Lines at the bottom of the terminal that stderr leads to, drawn over themselves. Between two drawings the
/// cursor stands at the beginning of the last one, where what a keyboard echoes cannot make it wrap.
class LiveLines {
  public:
    LiveLines();
    /// Leaves the lines where they are and goes to a line of its own below them.
    ~LiveLines();
    LiveLines(const LiveLines&) = delete;
    LiveLines& operator=(const LiveLines&) = delete;

    /// Whether stderr is a terminal that can do this; where it is not, nothing here does anything.
    bool possible() const { return terminal; }
    /// How many columns the terminal has now; 80 where it does not say.
    std::size_t columns() const;

    /// lines: each shorter than columns(). Those that the terminal has no row for are left out.
    void draw(std::vector<std::string> lines);
    /// Takes them away, so that something else can be printed in their place.
    void clear();
    /// Leaves them standing: what is drawn next comes below.
    void leave();

  private:
    std::size_t rows() const;
    std::string to_first_line() const;

    bool terminal;
    std::size_t drawn = 0;  ///< lines that there are now
};

}  // namespace sherd
