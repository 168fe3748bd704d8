// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/build/start_fault.h"

#include <fmt/format.h>

#include "app/words/place_words.h"

namespace sherd {

std::string fault_words(const StartFault& fault, const Scene& scene) {
    return fmt::format("face {} of sheet.{} at {}", fault.face, scene.sheets[fault.sheet].name,
                       place_words(fault.at));
}

}  // namespace sherd
