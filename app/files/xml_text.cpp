// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/xml_text.h"

#include "meshops/read_write/obj_name.h"

namespace sherd {

std::string xml_escaped(const std::string& text) {
    std::string result;
    for (const char c : utf8_name(text)) {
        if (c == '&')
            result += "&amp;";
        else if (c == '<')
            result += "&lt;";
        else if (c == '>')
            result += "&gt;";
        else if (c == '"')
            result += "&quot;";
        else if (c == '\t' || c == '\n' || c == '\r')
            result += "&#" + std::to_string(static_cast<int>(c)) + ";";  // unescaped, it is read as a blank
        else if (static_cast<unsigned char>(c) < ' ')
            result += '_';  // XML excludes such characters
        else
            result += c;
    }
    return result;
}

}  // namespace sherd
