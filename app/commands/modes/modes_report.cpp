// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <iterator>

#include "app/commands/modes/modes.h"
#include "app/messages/counted.h"

namespace sherd {
namespace {

void add_mode(std::string& text, std::size_t number, const VibrationMode& mode, double out_of_plane) {
    auto out = std::back_inserter(text);
    if (mode.unstable())
        fmt::format_to(out, "{:>4}  {:<43}", number,
                       fmt::format("unstable: grows e-fold in {:.5g} s", 1 / mode.growth_rate()));
    else
        fmt::format_to(out, "{:>4} {:>14.5g} {:>14.5g} {:>14.5g}", number, mode.frequency(),
                       1 / mode.frequency(), mode.angular_frequency());
    fmt::format_to(out, " {:>11.1f} %\n", 100 * out_of_plane);
}

}  // namespace

std::string modes_text(const Scene& scene, const SceneModes& modes) {
    const Vibration& vibration = modes.vibration;
    std::string text;
    auto out = std::back_inserter(text);
    fmt::format_to(out, "scene        {}{}\n", scene.file.string(),
                   scene.variant.empty() ? "" : fmt::format(", variant {}", scene.variant));
    fmt::format_to(out, "mesh         {}, {}; {} coordinates are free\n",
                   counted(modes.vertices, "vertex", "vertices"), counted(modes.faces, "face"),
                   vibration.freedoms);
    if (vibration.rigid > 0)
        fmt::format_to(out, "rigid        {} rigid motions, of frequency 0, not in the table\n",
                       vibration.rigid);
    if (!modes.left_out.empty()) fmt::format_to(out, "left out     {}\n", fmt::join(modes.left_out, "; "));
    if (static_cast<Index>(vibration.modes.size()) == vibration.freedoms - vibration.rigid)
        fmt::format_to(out, "modes        all {} that this mesh has\n", vibration.modes.size());
    fmt::format_to(out, "mode   frequency Hz       period s    angular 1/s  out of plane\n");
    for (std::size_t i = 0; i < vibration.modes.size(); ++i)
        add_mode(text, i + 1, vibration.modes[i], modes.out_of_plane[i]);
    return text;
}

Json modes_json(const Scene& scene, const SceneModes& modes) {
    Json json{{"scene", scene.file.string()},
              {"variant", scene.variant},
              {"vertices", modes.vertices},
              {"faces", modes.faces},
              {"free_coordinates", modes.vibration.freedoms},
              {"rigid", modes.vibration.rigid},
              {"left_out", modes.left_out},
              {"modes", Json::array()}};
    for (std::size_t i = 0; i < modes.vibration.modes.size(); ++i) {
        const VibrationMode& mode = modes.vibration.modes[i];
        json["modes"].push_back({{"frequency", mode.frequency()},
                                 {"angular_frequency", mode.angular_frequency()},
                                 {"growth", mode.growth_rate()},
                                 {"out_of_plane", modes.out_of_plane[i]}});
    }
    return json;
}

}  // namespace sherd
