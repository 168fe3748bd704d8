// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace sherd {

/// Collects the mistakes of several variants, or their warnings. A line that several variants share is listed
/// once.
class VariantRemarks {
  public:
    /// Adds the lines of a variant, such as the message of an Error; empty if there are none.
    void add(const std::string& variant, const std::string& lines);
    /// Returns each line, with the names of its variants unless all have it.
    std::vector<std::string> lines() const;
    /// Throws Error with all lines.
    void throw_if_any() const;

  private:
    std::size_t variants = 0;
    std::vector<std::pair<std::string, std::vector<std::string>>> remarks;  ///< line and its variants
};

}  // namespace sherd
