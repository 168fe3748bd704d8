// SPDX-License-Identifier: GPL-3.0-or-later
// energies SCENE.toml: runs a scene and prints its energies after each step.
#include <cstdio>
#include <string>
#include <vector>

#include "app/run/runner.h"
#include "app/scene/read/scene.h"
#include "meshops/error.h"

struct Energies : sherd::RunObserver {
    void stepped(const sherd::StepReport& step, const sherd::CrackEvents& events) override {
        std::printf("%8g s  kinetic %-12g bending %-12g membrane %-12g contact %-12g J, %zu cracked edges\n",
                    step.time, step.kinetic, step.bending, step.membrane, step.contact,
                    events.failures.size());
    }
};

int main(int count, char** arguments) try {
    if (count != 2) throw sherd::Error("usage: energies SCENE.toml");
    const sherd::Scene scene = sherd::read_scene(arguments[1]);
    std::vector<std::string> warnings;
    sherd::Runner runner(scene, sherd::build_scene(scene, warnings));
    for (const std::string& warning : warnings) std::fprintf(stderr, "warning: %s\n", warning.c_str());
    Energies energies;
    runner.add(energies);
    return runner.run().is_complete() ? 0 : 1;
} catch (const sherd::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return error.fault == sherd::Fault::input ? 2 : 1;
}
