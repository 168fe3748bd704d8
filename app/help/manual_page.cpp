// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/help/manual_page.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <sstream>

#include "app/help/option_value.h"

namespace sherd {
namespace {

/// Escapes text for roff, so that no line begins with a macro, and so that hyphens and quotes are printed as
/// ASCII characters, which can be copied.
std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        const bool heads_line = result.empty() || result.back() == '\n';
        if (heads_line && (c == '.' || c == '\'')) result += "\\&";
        switch (c) {
            case '\\':
                result += "\\e";
                break;
            case '-':
                result += "\\-";
                break;
            case '\'':
                result += "\\(aq";
                break;
            case '`':
                result += "\\(ga";
                break;
            case '~':
                result += "\\(ti";
                break;
            case '^':
                result += "\\(ha";
                break;
            default:
                result += c;
        }
    }
    return result;
}

/// Returns the heading of an option: its names in bold, and the placeholder of its value in italics.
std::string option_heading(const CLI::Option& option) {
    std::string heading;
    for (const std::string& name : typed_names(option))
        heading += fmt::format("{}\\fB{}\\fR", heading.empty() ? "" : ", ", escaped(name));
    if (const std::string value = value_name(option); !value.empty())
        heading += fmt::format("{}\\fI{}\\fR", heading.empty() ? "" : " ", escaped(value));
    return heading;
}

std::string option_list(const CLI::App& command, bool positional) {
    std::string list;
    for (const CLI::Option* option : shown_options(command, positional)) {
        // The help option is documented once, for the program.
        if (option == command.get_help_ptr() && command.get_parent() != nullptr) continue;
        const std::string standard = option->get_default_str();
        list += fmt::format(".TP\n{}\n{}{}{}\n", option_heading(*option), escaped(option->get_description()),
                            standard.empty() ? "" : escaped(fmt::format(" (default: {})", standard)),
                            option->get_required() && !positional ? " (required)" : "");
    }
    return list;
}

/// Returns the footer of a command's help in roff. Indented lines are kept; other lines are filled to
/// paragraphs.
std::string footer(const std::string& text) {
    std::string result;
    bool shown = false;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
        const bool indented = line.starts_with("  ");
        if (indented != shown) result += indented ? ".PP\n.RS 4\n.nf\n" : ".fi\n.RE\n";
        if (!indented && !shown) result += ".PP\n";
        shown = indented;
        result += escaped(indented ? line.substr(2) : line) + "\n";
    }
    return result + (shown ? ".fi\n.RE\n" : "");
}

std::string usage(const CLI::App& command) {
    std::string line = fmt::format("sherd {}", command.get_name());
    for (const CLI::Option* option : shown_options(command, false))
        if (option->get_required())
            line += fmt::format(" {} {}", typed_names(*option).back(), value_name(*option));
    line += " [OPTIONS]";
    for (const CLI::Option* argument : shown_options(command, true)) {
        const std::string name = value_name(*argument);
        line += argument->get_required() ? " " + name : fmt::format(" [{}]", name);
    }
    return escaped(line);
}

constexpr const char* last_sections = R"(.SH "EXIT STATUS"
.TP
.B 0
done
.TP
.B 1
the run failed; what was recorded until then is usable
.TP
.B 2
bad usage or bad input; nothing was written
.TP
.B 130
interrupted by Ctrl\-C; what was recorded until then is usable
.TP
.B 143
interrupted by SIGTERM, likewise
.SH FILES
.TP
.I share/sherd/scenes
below the folder of the installation: the scenes that \fBsherd scenes\fR lists
.TP
.I share/sherd/blender/sherd_recording.py
plays a recording in Blender
.TP
.I share/doc/sherd
README.md; in docs, scene.md with every key of a scene, commands.md with every command, and
recording.md with the layout of recordings
.SH "SEE ALSO"
.BR ffmpeg (1),
which joins the pictures of \fBsherd render \-\-film\fR
)";

}  // namespace

std::string manual_page(const CLI::App& program) {
    std::string commands;
    for (const CLI::App* command : shown_commands(program))
        commands += fmt::format(".SS \"{}\"\n{}.\n{}{}{}", usage(*command),
                                escaped(command->get_description()), option_list(*command, true),
                                option_list(*command, false), footer(command->get_footer()));
    return fmt::format(
        ".\\\" Made by 'sherd manual' from the program's own help.\n"
        ".TH SHERD 1 \"\" \"sherd {}\" \"User Commands\"\n"
        ".SH NAME\nsherd \\- breaks plates and shells\n"
        ".SH SYNOPSIS\n\\fBsherd\\fR \\fICOMMAND\\fR [\\fIOPTIONS\\fR] ...\n"
        ".SH DESCRIPTION\n{}\n.PP\nResults go to standard output, everything else to standard error.\n"
        ".SH OPTIONS\n{}.SH COMMANDS\n{}{}",
        SHERD_VERSION, escaped(program.get_description()), option_list(program, false), commands,
        last_sections);
}

}  // namespace sherd
