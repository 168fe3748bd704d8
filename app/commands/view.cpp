// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <optional>
#include <string_view>
#include <utility>

#include "app/commands/commands.h"
#include "app/commands/number_check.h"
#include "app/commands/slow_motion_options.h"
#include "app/files/disk/pending_file.h"
#include "app/files/xml_text.h"
#include "app/messages/print.h"
#include "app/playback/slow_motion.h"
#include "app/render/surface_paint.h"
#include "app/view/view_assets.h"
#include "app/view/view_data.h"
#include "meshops/error.h"
#include "meshops/shared_values.h"

namespace sherd {
namespace {

/// JSON that is safe in a script element, whatever the names in the scene.
std::string script_json(const PageJson& data) {
    std::string text = data.dump(-1, ' ', false, PageJson::error_handler_t::replace);
    for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at))
        text.replace(at, 1, "\\u003c");
    return text;
}

using Filling = std::pair<std::string_view, std::string_view>;  ///< %NAME% and its replacement

std::string filled(std::string_view page, std::initializer_list<Filling> fillings) {
    std::string text;
    while (!page.empty()) {
        std::size_t next = page.size();
        const Filling* chosen = nullptr;
        for (const Filling& filling : fillings)
            if (const std::size_t at = page.find(filling.first); at < next) {
                next = at;
                chosen = &filling;
            }
        text += page.substr(0, next);
        page.remove_prefix(next);
        if (!chosen) break;
        text += chosen->second;
        page.remove_prefix(chosen->first.size());
    }
    return text;
}

// Approximate bytes in the page, in base64: for a vertex in each frame, and once for the two faces of each
// vertex.
constexpr double frame_bytes = (3 * 2 + 1 + 1) * 4 / 3.0, face_bytes = 2 * (3 + 1 + 1) * 4 * 4 / 3.0;
constexpr double point_bytes = 3 * 4 * 4 / 3.0;  // for a point of a deforming obstacle, in each frame
// The mesh is thinned if fewer frames than this fit.
constexpr std::size_t enough_frames = 20;

/// The thinning of the mesh with which enough frames fit into `most_bytes`; none if all vertices fit.
std::optional<MeshThinning> thinning_for(const Recording& recording, double most_bytes) {
    const RecordingHeader header = recording.header();
    const Snapshot last = recording.frame(recording.frame_count() - 1);
    const auto frames = static_cast<double>(std::min(recording.frame_count(), enough_frames));
    const double most = most_bytes / (frames * frame_bytes + face_bytes);
    if (static_cast<double>(last.position.cols()) <= most) return std::nullopt;
    const double area = std::accumulate(header.rest_area.begin(), header.rest_area.end(), 0.0);
    double cube = std::sqrt(area / most);
    while (true) {
        MeshThinning thinning(header, last.face_sheet, cube);
        if (static_cast<double>(thinning.thinned(last).position.cols()) <= most) return thinning;
        cube *= 1.1;
    }
}

/// Materials and colours for the page. Returns none if the recording has none, and, with a warning, if the
/// mesh is thinned or if they do not fit beside enough frames. Texture pictures get at most a quarter of
/// `most_bytes`.
std::optional<PageLook> look_for(const Recording& recording, const Snapshot& last, bool thinned,
                                 double most_bytes, std::vector<std::string>& warnings) {
    const SurfaceLook look = recording.header().rest_look;
    if (!look.paints()) return std::nullopt;
    const double picture_bytes = shared_values(look.material).rows.empty() ? 0 : most_bytes / 4;
    const auto frames = static_cast<double>(std::min(recording.frame_count(), enough_frames));
    const double others = static_cast<double>(last.position.cols()) * (frames * frame_bytes + face_bytes);
    const auto arrays = static_cast<double>(look_bytes(look, last.faces.size()));
    if (!thinned && others + arrays + picture_bytes <= most_bytes)
        return PageLook(look, static_cast<std::size_t>(picture_bytes), warnings);
    warnings.push_back(
        fmt::format("the page shows no materials and colours of the sheets, so that its data stay near {:g} "
                    "MB; --megabytes allows more",
                    most_bytes / 1e6));
    return std::nullopt;
}

/// Number of points of obstacles that deform, which are stored in each frame.
double deforming_points(const Recording& recording) {
    double sum = 0;
    for (const RecordedObstacle& obstacle : recording.obstacles())
        if (obstacle.deforms) sum += static_cast<double>(obstacle.surface.points.size());
    return sum;
}

/// Data of the frames that fit, thinned if necessary. Adds warnings for anything that differs from the
/// recording.
PageJson fitting_data(const Recording& recording, const RenderStage& stage, double megabytes,
                      std::vector<std::string>& warnings) {
    const double most_bytes = 1e6 * megabytes;
    const std::optional<MeshThinning> thinning = thinning_for(recording, most_bytes);
    Snapshot last = recording.frame(recording.frame_count() - 1);
    const Eigen::Index whole = last.position.cols();
    if (thinning) {
        last = thinning->thinned(last);
        warnings.push_back(fmt::format(
            "the page has {} of {} vertices, so that its data stay near {:g} MB: those within {:.2g} m are "
            "merged, and fragments smaller than that may be missing; --megabytes allows more",
            last.position.cols(), whole, megabytes, thinning->cube_length()));
    }
    const std::optional<PageLook> look =
        look_for(recording, last, thinning.has_value(), most_bytes, warnings);
    const auto vertices = static_cast<double>(last.position.cols());
    const std::size_t look_space =
        look ? look_bytes(recording.header().rest_look, last.faces.size()) + look->pictures().bytes() : 0;
    const double room = std::max(0.0, most_bytes - vertices * face_bytes - static_cast<double>(look_space));
    const double shapes = point_bytes * deforming_points(recording);
    const std::vector<std::size_t> frames =
        shown_frames(recording.frame_count(), static_cast<std::size_t>(vertices * frame_bytes + shapes),
                     static_cast<std::size_t>(room));
    if (frames.size() < recording.frame_count())
        warnings.push_back(fmt::format(
            "the page has {} of {} frames, so that its data stay near {:g} MB; --megabytes allows more",
            frames.size(), recording.frame_count(), megabytes));
    return view_data(recording, stage, frames, thinning, look);
}

/// Initial playback speed of the page.
Pace pace_of_page(const ViewOptions& options, const Recording& recording) {
    return pace_of({options.slow, {}}, recording.time(recording.frame_count() - 1) - recording.time(0));
}

int view(ViewOptions options) {
    if (options.output.empty())
        options.output = std::filesystem::path(options.recording).replace_extension(".html");
    require_kind(options.output, ".html", "a page is HTML; name a .html file");
    check_free(options.output, options.force, {options.recording});
    const OutputLock lock(options.output);
    std::vector<std::string> warnings;
    const std::string page = view_page(options, warnings);
    print_warnings(warnings);
    PendingFile pending(lock, Fault::input);
    pending.write(page);
    pending.publish(options.force);
    print_message("sherd: {}\n", pace_of_page(options, Recording(options.recording)).words());
    print_result("{}\n", options.output.string());
    return 0;
}

}  // namespace

std::string view_page(const ViewOptions& options, std::vector<std::string>& warnings) {
    check_slow_motion({options.slow, {}});
    const Recording recording(options.recording);
    StageOptions stage_options;
    const RenderColour colour =
        options.colour.empty() ? RenderColour::strain : parse_render_colour(options.colour, view_colours);
    if (colour == RenderColour::material) require_paint(recording.header().rest_look);
    stage_options.colour = is_scalar(colour) ? colour : RenderColour::strain;
    const RenderStage stage(recording, stage_options, warnings);
    const std::string title = xml_escaped(options.recording.stem().string());
    PageJson data = fitting_data(recording, stage, options.megabytes, warnings);
    data["plain"] = options.plain;
    const bool starts_painted =
        data.contains("look") && (options.colour.empty() || colour == RenderColour::material);
    data["start"] = starts_painted ? "material" : "fragment";
    data["slow"] = pace_of_page(options, recording).slowdown;
    return filled(view_assets::page, {{"%TITLE%", title},
                                      {"%THREE%", view_assets::three},
                                      {"%CONTROLS%", view_assets::controls},
                                      {"%PLAYBACK%", view_assets::playback},
                                      {"%PAINT%", view_assets::paint},
                                      {"%RECORDING%", script_json(data)}});
}

void add_view(CLI::App& program, Command& chosen) {
    CLI::App* command = program.add_subcommand("view", "Make a page that plays a run in a browser");
    auto options = std::make_shared<ViewOptions>();
    command->add_option("recording", options->recording, "Recording of a run (.h5)")
        ->required()
        ->option_text("RUN.h5");
    command->add_option("-o,--output", options->output, "HTML file (default: beside RUN.h5)")
        ->option_text("FILE.html");
    command
        ->add_option(
            "--color", options->colour,
            "Quantity that colours can show besides fragments (default: strain); material: shown first")
        ->option_text("strain|stress|curvature|material");
    add_slow_motion_option(*command, options->slow);
    command->add_option("--megabytes", options->megabytes, "Megabytes of data in the page (default 64)")
        ->check(number_within(1, 400))
        ->option_text("N");
    command->add_flag("--plain", options->plain, "Leave out the colour bar and the caption");
    command->add_flag("--force", options->force, "Replace a file that exists");
    command->footer("Example:\n  sherd view plate_drop.h5 -o plate.html");
    command->callback([&chosen, options] { chosen = [options] { return view(*options); }; });
}

}  // namespace sherd
