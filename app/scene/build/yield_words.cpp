// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/build/yield_words.h"

#include <fmt/format.h>

#include "app/words/place_words.h"

namespace sherd {

std::string yield_words(double ratio, const YieldPlace& place, const Scene& scene) {
    return fmt::format("{:.3g} times the yield stress, in sheet.{} at {} at rest", ratio,
                       scene.sheets[place.sheet].name, place_words(place.rest));
}

}  // namespace sherd
