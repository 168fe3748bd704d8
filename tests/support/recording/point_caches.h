// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "core/vector.h"

namespace sherd::test {

/// Bytes of numbers, in the byte order of a kind of point cache: PC2 is little-endian, MDD big-endian.
/// Written independently of the program.
class CacheBytes {
  public:
    explicit CacheBytes(bool big_endian) : big_endian(big_endian) {}
    CacheBytes& whole(std::uint32_t number) {
        for (int i = 0; i < 4; ++i)
            text += static_cast<char>(number >> (big_endian ? 24 - 8 * i : 8 * i) & 0xff);
        return *this;
    }
    CacheBytes& real(float number) {
        static_assert(sizeof number == sizeof(std::uint32_t));
        std::uint32_t bits;
        std::memcpy(&bits, &number, sizeof bits);
        return whole(bits);
    }
    CacheBytes& points(const std::vector<Positions>& samples) {
        for (const Positions& sample : samples)
            for (const double coordinate : sample.reshaped()) real(static_cast<float>(coordinate));
        return *this;
    }

    std::string text;

  private:
    bool big_endian;
};

/// Content of a .pc2 file, with `frames` frames between its samples. samples: [3, P] m.
inline std::string pc2_of(const std::vector<Positions>& samples, float frames = 1) {
    CacheBytes bytes(false);
    bytes.text = std::string("POINTCACHE2\0", 12);
    bytes.whole(1).whole(static_cast<std::uint32_t>(samples.empty() ? 0 : samples[0].cols())).real(1);
    bytes.real(frames).whole(static_cast<std::uint32_t>(samples.size())).points(samples);
    return bytes.text;
}

/// Content of an .mdd file. times: s.
inline std::string mdd_of(const std::vector<Positions>& samples, const std::vector<float>& times) {
    CacheBytes bytes(true);
    bytes.whole(static_cast<std::uint32_t>(samples.size()));
    bytes.whole(static_cast<std::uint32_t>(samples.empty() ? 0 : samples[0].cols()));
    for (const float time : times) bytes.real(time);
    return bytes.points(samples).text;
}

}  // namespace sherd::test
