// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/disk/disk_space.h"

#include <gtest/gtest.h>

#include <cerrno>

#include "meshops/error.h"

namespace sherd::test {
namespace {

std::string message_of(std::size_t bytes) {
    try {
        throw_no_space("run.h5", bytes, ENOSPC);
    } catch (const Error& error) {
        EXPECT_EQ(error.fault, Fault::run);
        return error.what();
    }
}

// "0.0 MB more" would say that nothing is lacking.
TEST(DiskSpace, NamesWhatIsLackingInAUnitThatItReaches) {
    EXPECT_TRUE(message_of(999).starts_with("no room for 999 B more in 'run.h5': ")) << message_of(999);
    EXPECT_TRUE(message_of(4096).starts_with("no room for 4.1 kB more in ")) << message_of(4096);
    EXPECT_TRUE(message_of(37'000'000).starts_with("no room for 37.0 MB more in ")) << message_of(37'000'000);
    EXPECT_TRUE(message_of(0).starts_with("no room for more in ")) << message_of(0);
}

}  // namespace
}  // namespace sherd::test
