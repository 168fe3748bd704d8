// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "app/files/image.h"
#include "app/render/camera.h"
#include "app/render/render_scene.h"

namespace sherd {

struct PictureOptions {
    int width = 960, height = 540;
    int samples = 32;  ///< of each pixel
    int threads = 0;   ///< 0: as many as the processor runs at once
};

/// Draws a scene: soft shadows of a lamp, and the light of a dome as far as nothing is in its way. The same
/// bits whatever the number of threads. None when `stop` returned true, which is asked for every row, by all
/// threads.
std::optional<Image> render_picture(const RenderScene& scene, const Camera& camera,
                                    const PictureOptions& options, const std::function<bool()>& stop);

}  // namespace sherd
