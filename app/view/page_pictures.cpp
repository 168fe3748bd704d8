// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/page_pictures.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/files/base64.h"

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

}  // namespace sherd
