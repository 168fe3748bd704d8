// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/page_look.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "app/files/base64.h"
#include "app/render/material_look.h"
#include "app/render/surface_paint.h"
#include "app/render/trace/render_light.h"
#include "meshops/error.h"
#include "meshops/shared_values.h"

namespace sherd {
namespace {

std::size_t page_bytes(const PictureFile& content) {
    return content.bytes.size() * 4 / 3;
}

}  // namespace

std::int32_t PagePictures::add(const std::filesystem::path& file) {
    const auto known = std::ranges::find(pictures, file, &Picture::file);
    if (known != pictures.end()) return static_cast<std::int32_t>(known - pictures.begin());
    read_picture(file);  // throws on a damaged picture, which a browser would not report
    pictures.push_back({file, read_picture_file(file)});
    return static_cast<std::int32_t>(pictures.size()) - 1;
}

void PagePictures::halve(Picture& picture) {
    picture.smaller =
        half_size(picture.smaller.width == 0 ? read_picture(picture.file) : std::move(picture.smaller));
    picture.content = picture_file(picture.smaller, picture.content.is_jpeg);
}

void PagePictures::fit(std::size_t most_bytes, std::vector<std::string>& warnings) {
    while (bytes() > most_bytes) {
        const auto largest = std::ranges::max_element(
            pictures, {}, [](const Picture& picture) { return picture.content.bytes.size(); });
        if (largest->smaller.width == 1 && largest->smaller.height == 1) break;
        halve(*largest);
    }
    for (const Picture& picture : pictures)
        if (picture.smaller.width > 0)
            warnings.push_back(
                fmt::format("the page has the picture '{}' with {} x {} pixels only; --megabytes allows more",
                            picture.file.string(), picture.smaller.width, picture.smaller.height));
}

std::size_t PagePictures::bytes() const {
    std::size_t sum = 0;
    for (const Picture& picture : pictures) sum += page_bytes(picture.content);
    return sum;
}

std::vector<std::string> PagePictures::urls() const {
    std::vector<std::string> urls;
    for (const auto& [file, content, smaller] : pictures)
        urls.push_back(fmt::format(
            "data:{};base64,{}", content.media_type(),
            base64({reinterpret_cast<const std::uint8_t*>(content.bytes.data()), content.bytes.size()})));
    return urls;
}

PageLook::PageLook(const SurfaceLook& look, std::size_t picture_bytes, std::vector<std::string>& warnings)
    : known(shared_values(look.material).rows) {
    for (const SurfaceMaterial& material : known)
        drawn.push_back(drawn_material(material, !look.texture.empty(), warnings));
    drawn.push_back({look.has_colours() ? 0xffffff : porcelain, -1});
    files.fit(picture_bytes, warnings);
}

PageLook::Material PageLook::drawn_material(const SurfaceMaterial& material, bool has_texture,
                                            std::vector<std::string>& warnings) {
    const MaterialLook look = material_look(material);
    Material drawn{written_colour(look.colour), -1};
    if (look.picture.empty() || !has_texture) return drawn;
    try {
        drawn.picture = files.add(look.picture);
    } catch (const Error& error) {
        warnings.push_back(unread_picture(material, error));
    }
    return drawn;
}

PageLook::Arrays PageLook::arrays(const Snapshot& frame) const {
    const SurfaceLook& look = frame.rest.look;
    Arrays arrays;
    for (const FaceTexture& corners : look.texture)
        for (const Eigen::Vector2d& corner : corners)
            for (const double x : corner)
                arrays.texture.push_back(std::bit_cast<std::uint32_t>(static_cast<float>(x)));
    const SharedValues<SurfaceMaterial> materials = shared_values(look.material);
    std::vector<std::uint32_t> number;  // index in `known` of each material of the frame
    for (const SurfaceMaterial& material : materials.rows)
        number.push_back(static_cast<std::uint32_t>(std::ranges::find(known, material) - known.begin()));
    for (std::size_t f = 0; f < frame.faces.size(); ++f) {
        const Index row = materials.number.empty() ? -1 : materials.number[f];
        arrays.material.push_back(row < 0 ? static_cast<std::uint32_t>(known.size()) : number[row]);
        if (!look.has_colours()) continue;
        for (const Index v : frame.faces[f]) {
            const Colour colour = look.colour(f, frame.original[v]);
            arrays.colour.push_back(colour[0] | colour[1] << 8 | colour[2] << 16);
        }
    }
    return arrays;
}

std::size_t look_bytes(const SurfaceLook& look, std::size_t faces) {
    const std::size_t numbers = 1 + (look.texture.empty() ? 0 : 6) + (look.has_colours() ? 3 : 0);
    return faces * numbers * sizeof(std::uint32_t) * 4 / 3;
}

}  // namespace sherd
