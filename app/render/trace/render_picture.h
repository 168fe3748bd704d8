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
    int threads = 0;   ///< number of threads; 0: as many as the processor runs at once
};

/// Returns a picture of a scene, lit by a lamp with soft shadows, and by a dome where no mesh hides it. The
/// bits of the picture do not depend on the number of threads. Every thread calls stop() before each row;
/// returns none if stop() has returned true.
std::optional<Image> render_picture(const RenderScene& scene, const Camera& camera,
                                    const PictureOptions& options, const std::function<bool()>& stop);

}  // namespace sherd
