// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/state_visitor.h"

namespace sherd {

/// Writes state into a text, with the name of each class in front of what it has.
class StateWriter : public StateVisitor {
  public:
    bool reads() const override { return false; }
    void bytes(void* data, std::size_t size) override { text.append(static_cast<const char*>(data), size); }
    void enter(const char* type) override;

    std::string text;
};

/// How long the text of a StateWriter will be, so that it need not grow.
class StateSize : public StateVisitor {
  public:
    bool reads() const override { return false; }
    void bytes(void* /*data*/, std::size_t size) override { count += size; }
    void enter(const char* type) override;

    std::size_t count = 0;
};

/// Puts state back that a StateWriter of the same program wrote. Throws Error (run) where it is of other
/// classes, or too short.
class StateReader : public StateVisitor {
  public:
    /// The text must outlive this object.
    explicit StateReader(std::span<const char> text) : rest(text) {}
    bool reads() const override { return true; }
    void bytes(void* data, std::size_t size) override;
    void enter(const char* type) override;
    std::string_view left() const { return {rest.data(), rest.size()}; }
    /// Throws Error (run) when there is more.
    void finish() const;

  private:
    std::span<const char> rest;
};

}  // namespace sherd
