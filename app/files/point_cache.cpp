// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/point_cache.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <string_view>

#include "meshops/error.h"
#include "meshops/raw_bytes.h"

namespace sherd {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view pc2_name("POINTCACHE2\0", 12);
// Sizes in bytes: a .pc2 header, an .mdd header before its times, a point.
constexpr std::size_t pc2_size = 32, mdd_size = 8, point_size = 12;

/// Header of a point cache.
struct Head {
    std::int32_t points = 0, samples = 0;
    std::vector<double> times;  ///< s, time of each sample
    std::endian order = std::endian::native;
};

/// A point cache that is read sequentially.
class CacheFile {
  public:
    explicit CacheFile(const fs::path& path) : path(path) {
        std::error_code failure;
        const fs::file_status status = fs::status(path, failure);
        if (!fs::exists(status)) throw Error(path.string() + ": no such point cache");
        if (fs::is_directory(status)) throw Error(path.string() + ": is a folder, a point cache is needed");
        bytes = fs::file_size(path, failure);
        stream.open(path, std::ios::binary);
        if (failure || !stream) throw Error(path.string() + ": the point cache cannot be read");
    }
    std::string read(std::size_t count) {
        std::string text(count, '\0');
        stream.read(text.data(), static_cast<std::streamsize>(count));
        if (!stream) throw Error(path.string() + ": the point cache cannot be read to its end");
        return text;
    }
    /// Throws Error if the file has fewer than `least` bytes. what: the part of the file that ends there, for
    /// the message.
    void require(double least, std::string_view what) const {
        if (static_cast<double>(bytes) < least)
            throw Error(
                fmt::format("{}: ends too early (truncated?): it has {} bytes of the {:.0f} of its {}",
                            path.string(), bytes, least, what));
    }
    void require_end(double expected, std::string_view kind) const {
        require(expected, "samples");
        if (static_cast<double>(bytes) > expected)
            throw Error(
                fmt::format("{}: is no {} file, or a damaged one: it has {} bytes, but by its header {:.0f}",
                            path.string(), kind, bytes, expected));
    }

  private:
    fs::path path;
    std::uintmax_t bytes = 0;
    std::ifstream stream;
};

/// Expected number of points, and the file of the mesh that has as many vertices.
struct Expected {
    std::size_t points;
    const fs::path& mesh;
};

void require_counts(const fs::path& path, const Head& head, const Expected& expected) {
    if (head.points < 0 || head.samples < 0)
        throw Error(
            fmt::format("{}: is damaged, or another kind of file: its header has {} points and {} samples",
                        path.string(), head.points, head.samples));
    if (head.samples == 0) throw Error(path.string() + ": holds no samples: export it once more");
    if (static_cast<std::size_t>(head.points) != expected.points)
        throw Error(fmt::format(
            "{}: holds {} points, but {} has {} vertices: export both from one mesh, without modifiers that "
            "add vertices to one of them, the mesh as .obj (.ply may split vertices)",
            path.string(), head.points, expected.mesh.string(), expected.points));
}

double size_of_samples(const Head& head) {
    return static_cast<double>(point_size) * head.points * head.samples;
}

Head read_pc2_head(CacheFile& file, const fs::path& path, const Expected& expected, double frame_rate) {
    file.require(pc2_size, "head");
    const std::string text = file.read(pc2_size);
    if (!text.starts_with(pc2_name))
        throw Error(path.string() + ": is no .pc2 file: it does not begin with POINTCACHE2");
    const auto whole = [&](int at) { return sherd::number_at<std::int32_t>(text.data() + at, pc2_order); };
    if (whole(12) != 1)
        throw Error(fmt::format("{}: is of version {} of .pc2, known is 1", path.string(), whole(12)));
    Head head{.points = whole(16), .samples = whole(28), .times = {}, .order = pc2_order};
    require_counts(path, head, expected);
    file.require_end(pc2_size + size_of_samples(head), ".pc2");
    const double frames = sherd::number_at<float>(text.data() + 24, pc2_order);
    if (!(frames > 0 && std::isfinite(frames)))
        throw Error(fmt::format("{}: its samples are {} frames apart, which must be more than 0",
                                path.string(), frames));
    for (std::int32_t i = 0; i < head.samples; ++i) head.times.push_back(i * frames / frame_rate);
    return head;
}

Head read_mdd_head(CacheFile& file, const fs::path& path, const Expected& expected,
                   std::optional<double> frame_rate) {
    file.require(mdd_size, "head");
    const std::string counts = file.read(mdd_size);
    Head head{.points = sherd::number_at<std::int32_t>(counts.data() + 4, mdd_order),
              .samples = sherd::number_at<std::int32_t>(counts.data(), mdd_order),
              .times = {},
              .order = mdd_order};
    require_counts(path, head, expected);
    const double whole = mdd_size + sizeof(float) * static_cast<double>(head.samples);
    file.require_end(whole + size_of_samples(head), ".mdd");
    const std::string times = file.read(sizeof(float) * static_cast<std::size_t>(head.samples));
    const auto time = [&](std::int32_t i) -> double {
        return sherd::number_at<float>(times.data() + sizeof(float) * static_cast<std::size_t>(i), mdd_order);
    };
    for (std::int32_t i = 0; i < head.samples; ++i) {
        if (!frame_rate && !(std::isfinite(time(i)) && (i == 0 || time(i) > time(i - 1))))
            throw Error(
                fmt::format("{}: the time of sample {}, {} s, must be a number and later than that of the "
                            "previous sample; `fps` replaces such times",
                            path.string(), i, time(i)));
        head.times.push_back(frame_rate ? i / *frame_rate : time(i) - time(0));
    }
    return head;
}

Eigen::Matrix3Xf read_sample(CacheFile& file, const fs::path& path, const Head& head, std::size_t number) {
    Eigen::Matrix3Xf sample(3, head.points);
    const std::string text = file.read(point_size * static_cast<std::size_t>(head.points));
    for (Eigen::Index i = 0; i < sample.size(); ++i) {
        sample.data()[i] = sherd::number_at<float>(text.data() + sizeof(float) * i, head.order);
        if (!std::isfinite(sample.data()[i]))
            throw Error(fmt::format("{}: sample {}: coordinate {} of point {} is NaN or infinite",
                                    path.string(), number, "xyz"[i % 3], i / 3));
    }
    return sample;
}

}  // namespace

std::string pc2_head(std::size_t points, std::size_t samples) {
    std::string bytes(pc2_name);
    append_number(bytes, std::int32_t{1}, pc2_order);
    append_number(bytes, static_cast<std::int32_t>(points), pc2_order);
    append_number(bytes, 0.0F, pc2_order);
    append_number(bytes, 1.0F, pc2_order);
    append_number(bytes, static_cast<std::int32_t>(samples), pc2_order);
    return bytes;
}

std::string mdd_head(std::size_t points, std::span<const double> times) {
    std::string bytes;
    append_number(bytes, static_cast<std::int32_t>(times.size()), mdd_order);
    append_number(bytes, static_cast<std::int32_t>(points), mdd_order);
    for (const double time : times) append_number(bytes, static_cast<float>(time), mdd_order);
    return bytes;
}

PointCache read_point_cache(const fs::path& path, std::size_t points, const fs::path& mesh,
                            std::optional<double> frame_rate) {
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
    if (extension != ".pc2" && extension != ".mdd")
        throw Error(fmt::format("{}: unknown kind of point cache `{}`; known are .pc2 and .mdd",
                                path.string(), extension));
    CacheFile file(path);
    const Expected expected{points, mesh};
    const Head head = extension == ".pc2"
                          ? read_pc2_head(file, path, expected, frame_rate.value_or(default_frame_rate))
                          : read_mdd_head(file, path, expected, frame_rate);
    PointCache cache{head.times, {}};
    for (std::size_t i = 0; i < head.times.size(); ++i)
        cache.samples.push_back(read_sample(file, path, head, i));
    return cache;
}

}  // namespace sherd
