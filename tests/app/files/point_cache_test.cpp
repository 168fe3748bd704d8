// SPDX-License-Identifier: GPL-3.0-or-later
// Caches of other programs must be read exactly. Damaged caches must be reported instead of used, and must
// not take as much memory as their header claims.
#include "app/files/point_cache.h"

#include <gtest/gtest.h>

#include <limits>

#include "meshops/error.h"
#include "tests/support/program/message_thrown_by.h"
#include "tests/support/program/temporary_directory.h"
#include "tests/support/recording/point_caches.h"

namespace sherd::test {
namespace {

std::vector<Positions> two_samples() {
    Positions first(3, 2), second(3, 2);
    first << 0, 1, 2, 3, 4, 5;
    second << -0.5, 1.5, 2, 3, 1e-3, 1e3;
    return {first, second};
}

class PointCacheFile : public ::testing::Test {
  protected:
    PointCache read(const std::string& name, const std::string& bytes, std::size_t points = 2,
                    std::optional<double> rate = {}) const {
        return read_point_cache(directory.write(name, bytes), points, "hand.obj", rate);
    }
    void expect_refused(const std::string& name, const std::string& bytes, const std::string& part,
                        std::size_t points = 2) const {
        const std::string error = message_thrown_by([&] { read(name, bytes, points); });
        EXPECT_NE(error.find(name), std::string::npos) << error;
        EXPECT_NE(error.find(part), std::string::npos) << error;
    }
    static void expect_samples(const PointCache& cache) {
        ASSERT_EQ(cache.samples.size(), 2u);
        for (std::size_t i = 0; i < 2; ++i)
            EXPECT_EQ(cache.samples[i], two_samples()[i].cast<float>()) << "sample " << i;
    }

    TemporaryDirectory directory;
};

TEST_F(PointCacheFile, IsReadFromPc2AtItsFrames) {
    const PointCache cache = read("a.pc2", pc2_of(two_samples(), 3));
    expect_samples(cache);
    EXPECT_EQ(cache.times, (std::vector<double>{0, 3 / 24.0}));
    EXPECT_EQ(read("A.PC2", pc2_of(two_samples(), 3), 2, 100).times[1], 3 / 100.0);
}

TEST_F(PointCacheFile, IsReadFromMddAtItsTimes) {
    const PointCache cache = read("a.mdd", mdd_of(two_samples(), {2.5F, 2.75F}));
    expect_samples(cache);
    EXPECT_EQ(cache.times, (std::vector<double>{0, 0.25})) << "from the first sample on";
    EXPECT_EQ(read("a.mdd", mdd_of(two_samples(), {7, 7}), 2, 50).times[1], 1 / 50.0);
}

TEST_F(PointCacheFile, OfAnotherMeshIsRefused) {
    expect_refused("a.pc2", pc2_of(two_samples()), "holds 2 points, but hand.obj has 3 vertices", 3);
    expect_refused("a.mdd", mdd_of(two_samples(), {0, 1}), "holds 2 points, but hand.obj has 4 vertices", 4);
}

TEST_F(PointCacheFile, OfAnotherKindIsRefused) {
    expect_refused("a.abc", "x", "unknown kind of point cache `.abc`");
    std::string other = pc2_of(two_samples());
    other[0] = 'Q';
    expect_refused("a.pc2", other, "does not begin with POINTCACHE2");
    other = pc2_of(two_samples());
    other[12] = 2;
    expect_refused("a.pc2", other, "version 2");
    expect_refused("a.mdd", pc2_of(two_samples()), "a.mdd");
    EXPECT_NE(message_thrown_by([&] { read_point_cache(directory.path / "no.pc2", 2, ""); }).find("no such"),
              std::string::npos);
    std::filesystem::create_directory(directory.path / "folder.pc2");
    EXPECT_NE(message_thrown_by([&] {
                  read_point_cache(directory.path / "folder.pc2", 2, "");
              }).find("is a folder"),
              std::string::npos);
}

TEST_F(PointCacheFile, ThatEndsTooEarlyIsRefused) {
    const std::string pc2 = pc2_of(two_samples()), mdd = mdd_of(two_samples(), {0, 1});
    for (std::size_t size = 0; size < pc2.size(); ++size)
        expect_refused("a.pc2", pc2.substr(0, size), "ends too early");
    for (std::size_t size = 0; size < mdd.size(); ++size)
        expect_refused("a.mdd", mdd.substr(0, size), "ends too early");
    expect_refused("a.pc2", pc2 + "x", "by its header 80");
    expect_refused("a.mdd", mdd + "x", "by its header 64");
}

TEST_F(PointCacheFile, WithoutSamplesIsRefused) {
    Positions none(3, 2);
    std::string empty = pc2_of({none});
    empty.resize(32);
    empty[28] = 0;
    expect_refused("a.pc2", empty, "holds no samples");
    expect_refused("a.mdd", CacheBytes(true).whole(0).whole(2).text, "holds no samples");
}

// Allocating as many points as the header claims would end the program.
TEST_F(PointCacheFile, OfHugeCountsIsRefusedBeforeItTakesMemory) {
    constexpr std::uint32_t most = 0x7fffffff;
    CacheBytes head(false);
    head.text = std::string("POINTCACHE2\0", 12);
    const std::string begin = head.text;
    head.whole(1).whole(most).real(0).real(1).whole(most);
    expect_refused("a.pc2", head.text, "ends too early", most);
    head.text = begin;
    head.whole(1).whole(0).real(0).real(1).whole(most);
    expect_refused("a.pc2", head.text, "holds 0 points");
    expect_refused("a.mdd", CacheBytes(true).whole(most).whole(2).text, "ends too early");
    expect_refused("a.mdd", CacheBytes(true).whole(0x80000000).whole(2).text, "damaged");
    expect_refused("a.mdd", CacheBytes(true).whole(1).whole(0xffffffff).text, "damaged");
}

TEST_F(PointCacheFile, OfNoNumbersIsRefused) {
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        std::vector<Positions> samples = two_samples();
        samples[1](2, 1) = bad;
        expect_refused("a.pc2", pc2_of(samples), "sample 1: coordinate z of point 1 is NaN or infinite");
        expect_refused("a.mdd", mdd_of(samples, {0, 1}), "sample 1: coordinate z of point 1");
        expect_refused("a.mdd", mdd_of(two_samples(), {0, static_cast<float>(bad)}), "the time of sample 1");
        expect_refused("a.pc2", pc2_of(two_samples(), static_cast<float>(bad)), "frames apart");
    }
    expect_refused("a.mdd", mdd_of(two_samples(), {1, 1}), "later than that of the previous sample");
    expect_refused("a.pc2", pc2_of(two_samples(), 0), "0 frames apart");
}

}  // namespace
}  // namespace sherd::test
