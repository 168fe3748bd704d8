// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <ostream>
#include <span>
#include <string_view>

#include "core/state_visitor.h"

namespace sherd {

/// Returns the CRC-32 of a text that continues a preceding text. sum: CRC-32 of the preceding text; 0: there
/// is none.
std::uint32_t state_sum(std::span<const char> text, std::uint32_t sum = 0);

/// Writes state into a stream, with the name of each class before its data, and computes a checksum of all
/// that it writes.
class StateWriter : public StateVisitor {
  public:
    /// The stream must outlive this object.
    explicit StateWriter(std::ostream& out) : out(out) {}
    bool reads() const override { return false; }
    void bytes(void* data, std::size_t size) override;
    void enter(const char* type) override;

    std::uint64_t size() const { return written; }  ///< number of bytes written
    std::uint32_t sum() const { return summed; }    ///< state_sum() of the bytes written

  private:
    std::ostream& out;
    std::uint64_t written = 0;
    std::uint32_t summed = 0;
};

/// Restores state that a StateWriter of the same program wrote. Throws Error (run) if the state is of other
/// classes, or if it is too short.
class StateReader : public StateVisitor {
  public:
    /// The text must outlive this object.
    explicit StateReader(std::span<const char> text) : rest(text) {}
    bool reads() const override { return true; }
    void bytes(void* data, std::size_t size) override;
    void enter(const char* type) override;
    std::string_view left() const { return {rest.data(), rest.size()}; }
    /// Throws Error (run) if text is left over.
    void finish() const;

  private:
    std::span<const char> rest;
};

}  // namespace sherd
