// SPDX-License-Identifier: GPL-3.0-or-later
// Completions and the manual page are derived from the help. If this failed, a shell would offer the wrong
// files for an option, or none.
#include "app/help/option_value.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "app/help/completion.h"
#include "app/help/manual_page.h"

namespace sherd {
namespace {

using Kind = OptionValue::Kind;
using Words = std::vector<std::string>;

/// Program with a command that has each kind of option.
struct SampleProgram {
    SampleProgram() {
        command->add_option("run", file, "A recording")->required()->option_text("RUN.h5");
        command->add_option("-o,--output", file, "Mesh to write (.obj or .ply, in text)")->option_text("OUT");
        command->add_option("--how", file, "How it's done [at 5:3]")->option_text("rigid|morph");
        command->add_option("--size", number, "m, or 1.5 of them")->option_text("SIZE");
        command->add_option("--anything", file, "A file of any kind")->option_text("FILE");
        command->add_option("--untold", file, "Recording (.h5); beside it an index");
        command->add_flag("--force", force, "Replace what is there");
        command->add_option("--hidden", file, "Not shown")->group("");
    }

    OptionValue value(const std::string& name) const { return option_value(*command->get_option(name)); }

    CLI::App program{"Does things.", "sherd"};
    CLI::App* command = program.add_subcommand("act", ".Acts - on 'it'");
    std::filesystem::path file;
    double number = 0;
    bool force = false;
};

TEST(OptionValue, IsWhatTheHelpSays) {
    const SampleProgram sample;
    EXPECT_EQ(sample.value("run").kind, Kind::file);
    EXPECT_EQ(sample.value("run").words, Words{"h5"});
    EXPECT_EQ(sample.value("--output").words, (Words{"obj", "ply"}));
    EXPECT_EQ(sample.value("--how").kind, Kind::words);
    EXPECT_EQ(sample.value("--how").words, (Words{"rigid", "morph"}));
    EXPECT_EQ(sample.value("--size").kind, Kind::anything);
    EXPECT_EQ(sample.value("--anything").kind, Kind::file);
    EXPECT_EQ(sample.value("--anything").words, Words{});
    EXPECT_EQ(sample.value("--untold").words, Words{"h5"});
    EXPECT_EQ(sample.value("--force").kind, Kind::none);
}

TEST(OptionValue, WhatTheHelpDoesNotShowIsNotOffered) {
    const SampleProgram sample;
    for (const std::string& text :
         {bash_completion(sample.program), zsh_completion(sample.program), manual_page(sample.program)}) {
        EXPECT_EQ(text.find("hidden"), std::string::npos) << text;
        EXPECT_NE(text.find("force"), std::string::npos) << text;
    }
}

TEST(ManualPage, NothingInItIsTakenForAMacro) {
    const SampleProgram sample;
    const std::string page = manual_page(sample.program);
    EXPECT_NE(page.find("\n\\&.Acts \\- on \\(aqit\\(aq.\n"), std::string::npos) << page;
    EXPECT_NE(page.find("\\fB\\-o\\fR, \\fB\\-\\-output\\fR \\fIOUT\\fR\n"), std::string::npos) << page;
}

TEST(ZshCompletion, DescriptionsKeepTheirQuotesAndBrackets) {
    const SampleProgram sample;
    const std::string script = zsh_completion(sample.program);
    EXPECT_NE(script.find("'--how=[How it'\\''s done \\[at 5\\:3\\]]:rigid|morph:(rigid morph)'"),
              std::string::npos)
        << script;
}

}  // namespace
}  // namespace sherd
