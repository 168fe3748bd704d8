// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/base64.h"

#include <gtest/gtest.h>

namespace sherd::test {
namespace {

std::string coded(const std::string& text) {
    return base64({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

/// Test vectors of RFC 4648, section 10.
TEST(Base64, GivesTheTestVectors) {
    EXPECT_EQ(coded(""), "");
    EXPECT_EQ(coded("f"), "Zg==");
    EXPECT_EQ(coded("fo"), "Zm8=");
    EXPECT_EQ(coded("foo"), "Zm9v");
    EXPECT_EQ(coded("foobar"), "Zm9vYmFy");
    EXPECT_EQ(coded("\xff\xfe\xfb"), "//77");
}

}  // namespace
}  // namespace sherd::test
