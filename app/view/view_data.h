// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "app/json/json.h"
#include "app/recording/recording.h"
#include "app/render/render_stage.h"
#include "app/view/page_look.h"
#include "app/view/view_thinning.h"

namespace sherd {

/// JSON for the page, with keys in alphabetical order.
using PageJson = nlohmann::json;

/// Returns the frames of `count` to be shown if a frame takes `frame_bytes` and all may take `most_bytes`:
/// every one, or as many as fit, at nearly equal distances; the first and the last always.
std::vector<std::size_t> shown_frames(std::size_t count, std::size_t frame_bytes, std::size_t most_bytes);

/// Returns the data of a recording's page, as view_page.html reads them. Arrays are in base64: positions as
/// 16 bits of RenderStage::everything() in each direction; corners, fragments and look of the faces as pairs
/// of an index and its new value, against the frame before; places of inserted vertices and faces in the
/// frame before; the thickness of the last frame's faces (none in recordings of older versions); the shapes
/// of obstacles, and their poses in each frame. thinning: of the meshes; none: as recorded. look: of meshes
/// that are not thinned; none: left out.
PageJson view_data(const Recording& recording, const RenderStage& stage,
                   const std::vector<std::size_t>& frames, const std::optional<MeshThinning>& thinning = {},
                   const std::optional<PageLook>& look = {});

}  // namespace sherd
