// SPDX-License-Identifier: GPL-3.0-or-later
// After a typing error on the command line the program must name the wrong word, and the word that was
// probably meant.
#include <gtest/gtest.h>

#include "tests/support/program/program.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd::test {
namespace {

void expect_usage_error(const std::vector<std::string>& arguments, const std::vector<std::string>& message) {
    const TemporaryDirectory directory;
    for (const char* scene : {"scene.toml", "a.toml"}) directory.write(scene, "");
    const ProgramResult result = run_sherd(arguments, directory.path);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.out, "");
    for (const std::string& part : message)
        EXPECT_NE(result.err.find(part), std::string::npos) << "no '" << part << "' in: " << result.err;
}

TEST(UsageMessage, TheNearestCommandIsSuggested) {
    expect_usage_error({"rnu", "scene.toml"}, {"sherd: error: 'rnu' is no command; did you mean 'run'?"});
    expect_usage_error({"chekc"}, {"did you mean 'check'?", "Run 'sherd --help' for more information."});
    expect_usage_error({"shatter"}, {"'shatter' is no command\n"});
}

TEST(UsageMessage, TheNearestOptionIsSuggested) {
    expect_usage_error(
        {"run", "scene.toml", "--forse"},
        {"'--forse' is no option of 'sherd run'; did you mean '--force'?", "Run 'sherd run --help'"});
    expect_usage_error({"run", "scene.toml", "--ouput=a.h5"},
                       {"'--ouput' is no option", "did you mean '--output'?"});
    expect_usage_error({"run", "scene.toml", "--colour"}, {"'--colour' is no option of 'sherd run'\n"});
    expect_usage_error({"run", "scene.toml", "-q"}, {"'-q' is no option of 'sherd run'\n"});
    expect_usage_error({"--versoin"}, {"'--versoin' is no option; did you mean '--version'?"});
}

// CLI11 reports that an option is missing, but the cause is that it was misspelt: both must be in the
// message.
TEST(UsageMessage, AMisspeltOptionThatIsMissingIsToldWithIt) {
    expect_usage_error(
        {"cut", "a.obj", "--edges", "cracks.txt", "--ouput", "b.obj"},
        {"--output is required", "'--ouput' is no option of 'sherd cut'; did you mean '--output'?"});
}

TEST(UsageMessage, AnArgumentTooManyIsNamed) {
    expect_usage_error({"run", "a.toml", "b.toml"}, {"'b.toml' is one argument too many of 'sherd run'"});
    expect_usage_error({"run", "--", "a.toml", "-o", "b.h5"},
                       {"is one argument too many: after '--' there are no options"});
}

// The reference of keys has no JSON: without an error, a script would read text as JSON.
TEST(UsageMessage, KeysAreNotPrintedAsJson) {
    expect_usage_error({"scenes", "--keys", "--json"}, {"--json", "excludes", "--keys"});
}

}  // namespace
}  // namespace sherd::test
