// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sweep/study/study_row.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

#include "app/files/disk/checksum.h"
#include "app/files/program_file.h"
#include "app/messages/number_list.h"
#include "app/messages/shell_quoting.h"
#include "app/scene/assemble/built_scene.h"
#include "app/scene/assemble/sheet/supports.h"
#include "app/scene/read/scene.h"
#include "app/scene/read/shipped_scenes.h"
#include "app/sweep/study/design.h"
#include "app/sweep/study/study_measures.h"
#include "meshops/error.h"

namespace sherd {
namespace {

namespace fs = std::filesystem;

/// Largest number of mistakes that a message lists; further ones are only counted.
constexpr std::size_t most_mistakes = 10;

std::string without_quotes(const std::string& value) {
    const bool quoted = value.size() > 1 && (value.front() == '"' || value.front() == '\'');
    return quoted ? value.substr(1, value.size() - 2) : value;
}

/// Returns an assignment: `pattern` with `value` in place of each {}. A string keeps its quotes if the
/// pattern is KEY={}, and loses them inside a longer value.
std::string filled(const std::string& pattern, const std::string& value) {
    const bool whole = pattern.ends_with("={}");
    std::string text = pattern;
    const std::string& put = whole ? value : without_quotes(value);
    for (std::size_t at = text.find("{}"); at != std::string::npos; at = text.find("{}", at + put.size()))
        text.replace(at, 2, put);
    return text;
}

fs::path beside(const Study& study, const std::string& name) {
    return fs::absolute(study.file).parent_path() / name;
}

/// Returns the file of a study's scene: a file in the study's folder, or a scene that comes with the program.
fs::path scene_of(const Study& study) {
    std::error_code ignored;
    for (const char* ending : {"", ".toml"})
        if (const fs::path file = beside(study, study.scene + ending); fs::is_regular_file(file, ignored))
            return file.lexically_normal();
    return fs::absolute(find_scene(study.scene)).lexically_normal();
}

SceneChoice choice_of(const Study& study, const std::vector<std::string>& values) {
    SceneChoice choice{study.set, study.variant};
    for (std::size_t i = 0; i < values.size(); ++i) {
        const StudyParameter& parameter = study.parameters[i];
        if (parameter.name == "variant") {
            choice.variant = without_quotes(values[i]);
            continue;
        }
        for (const std::string& pattern : parameter.patterns)
            choice.overrides.push_back(filled(pattern, values[i]));
    }
    return choice;
}

/// Hashes of files; each file is read only once.
class FileHashes {
  public:
    std::uint64_t of(const fs::path& file) {
        const auto [found, is_new] = known.try_emplace(file);
        if (is_new) found->second = checksum_of(file);
        return found->second;
    }

  private:
    std::map<fs::path, std::uint64_t> known;
};

std::uint64_t settings_hash(const Scene& scene) {
    std::uint64_t sum = checksum("");
    for (const auto& [key, value] : scene.settings) sum = checksum(key + " = " + value + "\n", sum);
    return sum;
}

/// Returns the hash of all files that settings of a scene name: meshes, textures, grids, lists.
std::uint64_t files_hash(const Scene& scene, FileHashes& hashes) {
    std::uint64_t sum = checksum("");
    for (const auto& [key, value] : scene.settings) {
        if (value.empty() || (value.front() != '"' && value.front() != '\'')) continue;
        const std::string name = without_quotes(value);
        std::error_code none;
        const fs::path file = scene.file.parent_path() / name;
        if (fs::is_regular_file(file, none))
            sum = checksum(fmt::format("{} {:016x}\n", name, hashes.of(file)), sum);
    }
    return sum;
}

std::string centre_words(const CrackCentre& centre) {
    std::string words = centre.obstacle;
    if (centre.point)
        words += fmt::format("{} {} {}", centre.point->x(), centre.point->y(), centre.point->z());
    return words + fmt::format(" radii {}", fmt::join(centre.radii, " "));
}

/// Reads the scenes of rows, one after the other, and collects the mistakes in them.
class RowReader {
  public:
    RowReader(const Study& study, StudyRows& all) : study(study), all(all) {
        text = read_scene_text(all.scene);
        has_variants = !variant_names(text, all.scene).empty();
        measured = checksum(fmt::format("over {} about {}\n", study.over, centre_words(study.centre)));
        if (!all.python.empty()) measured = checksum(text_of(all.python), measured);
    }

    /// Adds the rows of a point, which differ in their seeds only.
    void add(const StudyRow& point) try {
        if (has_variants && point.choice.variant.empty())
            throw Error(fmt::format("{} has variants: name one (variant = \"...\"), or make them a parameter",
                                    all.scene.string()));
        Scene scene = parse_scene(text, all.scene, point.choice);
        const std::uint64_t files = files_hash(scene, hashes);
        for (const SupportName& support : support_names(scene))
            supports.insert(name_in_measures(support.name));
        for (std::int64_t repeat = 0; repeat < study.repeats; ++repeat) {
            StudyRow row = point;
            row.seed = scene.seed + repeat;
            row.duration = scene.duration;
            if (study.repeats > 1) {
                row.choice.overrides.push_back(fmt::format("seed={}", row.seed));
                scene.settings["seed"] = std::to_string(row.seed);
            }
            row.scene = settings_hash(scene);
            row.files = files;
            row.identity = checksum(
                fmt::format("{:016x} {:016x} {}", row.scene, row.files, row.choice.variant), measured);
            all.rows.push_back(std::move(row));
        }
    } catch (const Error& error) {
        refuse(error.what());
    }

    /// Builds the scene of a row, to find mistakes that reading does not show.
    void build(const StudyRow& row) try {
        std::vector<std::string> warnings;
        build_scene(parse_scene(text, all.scene, row.choice), warnings);
    } catch (const Error& error) {
        refuse(error.what());
    }

    /// Must be called after all rows have been added, since a support in a measure's name may exist in some
    /// of the rows only.
    void require_supports() {
        for (const std::string& measure : study.measures)
            if (const std::string mistake = support_error(measure, supports); !mistake.empty())
                refuse(fmt::format("{}: measures: {}", study.file.string(), mistake));
    }

    void throw_if_any() const {
        if (mistakes.empty()) return;
        const std::size_t shown = std::min(mistakes.size(), most_mistakes);
        std::string lines = fmt::format("{}", fmt::join(mistakes.begin(), mistakes.begin() + shown, "\n"));
        if (shown < mistakes.size()) lines += fmt::format("\nand {} more", mistakes.size() - shown);
        throw Error(lines);
    }

  private:
    void refuse(const std::string& mistake) {
        if (std::ranges::find(mistakes, mistake) == mistakes.end()) mistakes.push_back(mistake);
    }

    const Study& study;
    StudyRows& all;
    std::string text;
    bool has_variants = false;
    std::uint64_t measured = 0;
    FileHashes hashes;
    std::set<std::string> supports;  ///< supports and obstacles of all rows, by their names in measures
    std::vector<std::string> mistakes;
};

/// Returns the first row and, for each parameter, the rows with its smallest and its largest number, and a
/// row for each value that is no number.
std::set<std::size_t> rows_to_build(const Study& study, const std::vector<StudyRow>& rows) {
    std::set<std::size_t> chosen;
    if (!rows.empty()) chosen.insert(0);
    for (std::size_t p = 0; p < study.parameters.size(); ++p) {
        std::optional<std::pair<double, std::size_t>> least, most;
        std::set<std::string> words;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const std::optional<double> number = number_of(rows[i].values[p]);
            if (!number && words.insert(rows[i].values[p]).second) chosen.insert(i);
            if (number && (!least || *number < least->first)) least = {*number, i};
            if (number && (!most || *number > most->first)) most = {*number, i};
        }
        if (least) chosen.insert({least->second, most->second});
    }
    return chosen;
}

}  // namespace

StudyRows study_rows(const Study& study, bool build) {
    StudyRows all;
    all.scene = scene_of(study);
    all.program = checksum_of(program_file());
    if (!study.python.empty()) all.python = beside(study, study.python);
    RowReader reader(study, all);
    const std::vector<std::vector<std::string>> points = design_points(study);
    for (std::size_t point = 0; point < points.size(); ++point) {
        StudyRow row{.values = points[point], .point = point, .choice = choice_of(study, points[point])};
        std::ranges::transform(row.values, row.values.begin(), without_quotes);
        reader.add(row);
    }
    reader.throw_if_any();
    reader.require_supports();
    if (build)
        for (const std::size_t row : rows_to_build(study, all.rows)) reader.build(all.rows[row]);
    reader.throw_if_any();
    return all;
}

std::vector<std::string> row_arguments(const StudyRows& rows, const StudyRow& row) {
    std::vector<std::string> arguments{"run", path_argument(rows.scene)};
    if (!row.choice.variant.empty()) arguments.insert(arguments.end(), {"--variant", row.choice.variant});
    for (const std::string& assignment : row.choice.overrides)
        arguments.insert(arguments.end(), {"--set", assignment});
    return arguments;
}

std::string row_command(const StudyRows& rows, const StudyRow& row) {
    std::string command = "sherd";
    for (const std::string& argument : row_arguments(rows, row)) command += " " + shell_quoted(argument);
    return command;
}

}  // namespace sherd
