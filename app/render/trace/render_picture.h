// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "app/files/picture/image.h"
#include "app/render/trace/camera.h"
#include "app/render/trace/render_scene.h"

namespace sherd {

struct PictureOptions {
    int width = 960, height = 540;
    int samples = 32;  ///< number of samples of each pixel
    int threads = 0;   ///< 0: as many as the processor runs at once
};

/// Draws a scene, with soft shadows of a lamp, and with the light of a dome where it is not occluded. The
/// bits do not depend on the number of threads. Returns none when `stop` returned true, which all threads
/// call for every row.
std::optional<Image> render_picture(const RenderScene& scene, const Camera& camera,
                                    const PictureOptions& options, const std::function<bool()>& stop);

}  // namespace sherd
