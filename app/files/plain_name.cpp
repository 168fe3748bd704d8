// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/plain_name.h"

#include <cctype>

namespace sherd {

std::string plain_name(std::string name, std::set<std::string>& used) {
    for (char& letter : name) {
        const auto code = static_cast<unsigned char>(letter);
        if (code < 0x80 && !std::isalnum(code) && letter != '-' && letter != '.') letter = '_';
    }
    std::string found = name;
    for (int number = 2; !used.insert(found).second; ++number) found = name + "_" + std::to_string(number);
    return found;
}

}  // namespace sherd
