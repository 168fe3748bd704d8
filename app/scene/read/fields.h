// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/toml/toml_table.h"
#include "core/shell/face_fields.h"

namespace sherd {

/// The fields of faces among the names, which need not all be of fields.
FaceFieldChoice chosen_fields(const std::vector<std::string>& names);

/// `fields` of [output]: a list of names, true for all or false for none, which is the default.
FaceFieldChoice read_fields(TomlTable& output);

}  // namespace sherd
