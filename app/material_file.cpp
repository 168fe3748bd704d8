// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/material_file.h"

#include "app/scene/read/material.h"
#include "app/scene/toml/toml_file.h"

namespace sherd {

MaterialFile read_material_file(const std::filesystem::path& file) {
    const toml::table document = parse_toml(read_toml_text(file, "material"), file);
    Problems problems;
    TomlTable table(document, "", problems, file.parent_path());
    MaterialFile result;
    if (table.has("bending_stiffness"))
        result.bending_stiffness = table.number("bending_stiffness", "N m", positive);
    SheetSpec sheet;
    read_section(table, material_section, sheet);
    if (table.is_table("thickness"))
        table.report("thickness", "must be a positive number (m), not a table: it is that of all vertices");
    result.axis = sheet.axis;
    result.material = sheet.material;
    problems.throw_if_any();
    return result;
}

}  // namespace sherd
