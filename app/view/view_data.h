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

/// What the page reads, whose keys are in the order of the alphabet.
using PageJson = nlohmann::json;

/// Frames of `count` that are shown when a frame takes `frame_bytes` and there are `most_bytes` for all:
/// every one, or as many as there is room for at nearly equal distances; the first and the last always.
std::vector<std::size_t> shown_frames(std::size_t count, std::size_t frame_bytes, std::size_t most_bytes);

/// What the page of a recording has to know, as view_page.html reads it. Arrays are in base64: positions as
/// 16 bits of the box of the action in each direction; corners and owners of the faces (fragments) and what
/// they look like as pairs of a place and its new value, against the frame before; where vertices and faces
/// that were born since the frame before were in that; the thickness of the last frame's faces (none in
/// recordings of before there was any); the shapes of obstacles, and in each frame where they are. thinning:
/// of the meshes; none: as recorded. look: of meshes that are not thinned; none: it is left out.
PageJson view_data(const Recording& recording, const RenderStage& stage,
                   const std::vector<std::size_t>& frames, const std::optional<MeshThinning>& thinning = {},
                   const std::optional<PageLook>& look = {});

}  // namespace sherd
