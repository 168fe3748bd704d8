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

/// Returns the numbers of the frames that a page shows, out of `count` frames, if a frame takes `frame_bytes`
/// and all may take `most_bytes`: every frame, or as many as fit, at nearly equal distances, but always the
/// first and the last one.
std::vector<std::size_t> shown_frames(std::size_t count, std::size_t frame_bytes, std::size_t most_bytes);

/// Returns the data of a recording's page, as view_page.html reads them. Arrays are in base64. Positions are
/// 16-bit numbers, from one side of the box RenderStage::everything() to the other in each direction.
/// Corners, fragments and look of faces are pairs of an index and its new value, which give the changes since
/// the frame before. Inserted vertices and faces have their places in the frame before. The thickness is that
/// of the last frame's faces (none in recordings of older versions). Obstacles have a shape, and a pose in
/// each frame. frames: numbers of the recording's frames to be shown; thinning: thins their meshes, none:
/// meshes as recorded; look: for meshes that are not thinned, none: no look.
PageJson view_data(const Recording& recording, const RenderStage& stage,
                   const std::vector<std::size_t>& frames, const std::optional<MeshThinning>& thinning = {},
                   const std::optional<PageLook>& look = {});

}  // namespace sherd
