// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "app/export/export.h"
#include "app/messages/split.h"
#include "meshops/error.h"

namespace sherd {

namespace {

/// A selection of frames as text.
struct FrameWords {
    const std::string& text;
    std::int64_t count;  ///< number of frames in the recording

    [[noreturn]] void fail(const std::string& why) const {
        throw Error(
            fmt::format("--frames {}: {}; give last, all, a number, START:STOP:STEP, or several of these, "
                        "separated by commas",
                        text, why));
    }

    std::int64_t number(const std::string& word) const {
        std::int64_t value = 0;
        const char* end = word.data() + word.size();
        const auto [stop, error] = std::from_chars(word.data(), end, value);
        if (word.empty() || stop != end || error != std::errc())
            fail(fmt::format("'{}' is not a frame", word));
        return value;
    }

    /// Index of the frame with this number; negative numbers count from the end.
    std::size_t frame(const std::string& word) const {
        const std::int64_t value = number(word), index = value < 0 ? value + count : value;
        if (index < 0 || index >= count)
            fail(
                fmt::format("there is no frame {}, the recording has {} (0 to {})", value, count, count - 1));
        return static_cast<std::size_t>(index);
    }

    /// Bound of a range, limited to 0 to `count`; the value `otherwise` if the word is empty.
    std::int64_t bound(const std::string& word, std::int64_t otherwise) const {
        if (word.empty()) return otherwise;
        const std::int64_t value = number(word);
        return std::clamp<std::int64_t>(value < 0 ? value + count : value, 0, count);
    }
};

void add_range(const FrameWords& choice, const std::vector<std::string>& words,
               std::vector<std::size_t>& frames) {
    if (words.size() > 3) choice.fail("a range has at most three parts");
    const std::int64_t step = words.size() == 3 && !words[2].empty() ? choice.number(words[2]) : 1;
    if (step < 1) choice.fail("the step of a range must be at least 1");
    const std::int64_t stop = choice.bound(words[1], choice.count);
    for (std::int64_t i = choice.bound(words[0], 0); i < stop; i += std::min(step, choice.count))
        frames.push_back(static_cast<std::size_t>(i));
}

}  // namespace

std::vector<std::size_t> selected_frames(const std::string& text, std::size_t count) {
    const FrameWords choice{text, static_cast<std::int64_t>(count)};
    if (count == 0) choice.fail("the recording has no frame yet");
    std::vector<std::size_t> frames;
    for (const std::string& part : split(text, ',')) {
        const std::vector<std::string> words = split(part == "all" ? ":" : part, ':');
        if (words.size() > 1)
            add_range(choice, words, frames);
        else
            frames.push_back(part == "last" ? count - 1 : choice.frame(part));
    }
    if (frames.empty()) choice.fail("that selects no frame");
    std::ranges::sort(frames);
    frames.erase(std::unique(frames.begin(), frames.end()), frames.end());
    return frames;
}

}  // namespace sherd
