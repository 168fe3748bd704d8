// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sweep/run/python_measure.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/files/program_file.h"
#include "app/json/json.h"
#include "app/process/child_run.h"
#include "app/sweep/study/study_measures.h"
#include "meshops/error.h"

namespace sherd {
namespace {

/// Arguments: folder of the package, Python file, recording. Without a recording the script only requires
/// that the file has a function measure.
constexpr const char* script = R"python(
import json, pathlib, runpy, sys
folder, file, *recording = sys.argv[1:]
if pathlib.Path(folder).is_dir():
    sys.path.insert(0, folder)
sys.path.insert(0, str(pathlib.Path(file).parent))
results, sys.stdout = sys.stdout, sys.stderr
import sherd
measure = runpy.run_path(file).get("measure")
if not callable(measure):
    sys.exit("it has no function measure(recording)")
if recording:
    values = measure(sherd.Recording(recording[0]))
    if not isinstance(values, dict):
        sys.exit("measure(recording) must return a dictionary of numbers by name")
    numbers = {str(key): None if value is None else float(value) for key, value in values.items()}
    print(json.dumps(numbers), file=results)
)python";

/// Returns the folder of the Python module that belongs to this program: beside the program in a build, below
/// the prefix of an installation.
std::filesystem::path package_folder() {
    const std::filesystem::path folder = std::filesystem::read_symlink("/proc/self/exe").parent_path();
    if (std::filesystem::exists(folder / "python" / "sherd")) return folder / "python";
    return folder.parent_path() / "lib" / "python3" / "dist-packages";
}

}  // namespace

std::vector<std::string> python_arguments(const std::filesystem::path& file,
                                          const std::filesystem::path& recording) {
    return {"-c", script, package_folder().string(), file.string(), recording.string()};
}

void require_measure(const std::filesystem::path& file) {
    const ProgramEnd end =
        end_of(python_to_start(), {"-c", script, package_folder().string(), file.string()});
    if (end.exit_code != 0) throw Error(fmt::format("{}: {}", file.string(), reason_in(end.err)));
}

std::vector<std::pair<std::string, double>> python_values(const std::string& printed) {
    std::vector<std::pair<std::string, double>> values;
    const Json json = Json::parse(printed, nullptr, false);
    if (!json.is_object()) throw Error("it ended before measure(recording) returned", Fault::run);
    for (const auto& [key, value] : json.items()) {
        if (is_study_column(key))
            throw Error(fmt::format("measure(recording) returned '{}', which is a column already", key),
                        Fault::run);
        if (value.is_number()) values.emplace_back(key, value);
    }
    return values;
}

}  // namespace sherd
