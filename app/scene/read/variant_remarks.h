// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace sherd {

/// Collects the mistakes in several variants of a scene, or warnings about them. A line that several variants
/// share is listed once.
class VariantRemarks {
  public:
    /// Adds the mistakes or warnings of a variant, one a line, such as the message of an Error; "" if there
    /// are none. Must be called for each variant.
    void add(const std::string& variant, const std::string& lines);
    /// Returns each different line, followed by the names of its variants unless all variants have it.
    std::vector<std::string> lines() const;
    /// Throws Error with all lines if there are any.
    void throw_if_any() const;

  private:
    std::size_t variants = 0;
    std::vector<std::pair<std::string, std::vector<std::string>>> remarks;  ///< lines, and their variants
};

}  // namespace sherd
