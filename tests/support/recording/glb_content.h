// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/support/recording/export_fixture.h"

namespace sherd::test {

using Cloud = std::vector<Eigen::Vector3f>;

/// Content of a .glb file.
struct Glb {
    explicit Glb(const std::string& content) {
        Bytes bytes(content);
        EXPECT_EQ(bytes.text(4), "glTF");
        EXPECT_EQ(bytes.next<std::uint32_t>(), 2u);
        EXPECT_EQ(bytes.next<std::uint32_t>(), content.size());
        const auto json_size = bytes.next<std::uint32_t>();
        EXPECT_EQ(bytes.text(4), "JSON");
        json = nlohmann::json::parse(bytes.text(json_size));
        const auto size = bytes.next<std::uint32_t>();
        EXPECT_EQ(bytes.text(4), std::string("BIN\0", 4));
        EXPECT_EQ(size % 4, 0u);
        data = bytes.text(size);
        EXPECT_TRUE(bytes.at_end());
    }

    template <class T>
    std::vector<T> values(std::size_t accessor, int width) const {
        const nlohmann::json& a = json["accessors"][accessor];
        const nlohmann::json& view = json["bufferViews"][a["bufferView"].get<std::size_t>()];
        Bytes bytes(data, view.value("byteOffset", std::size_t{0}));
        std::vector<T> result;
        for (std::size_t i = 0; i < width * a["count"].get<std::size_t>(); ++i)
            result.push_back(bytes.next<T>());
        EXPECT_EQ(view["byteLength"], result.size() * sizeof(T));
        return result;
    }
    Cloud cloud(std::size_t accessor) const {
        EXPECT_EQ(json["accessors"][accessor]["type"], "VEC3");
        const auto numbers = values<float>(accessor, 3);
        Cloud cloud;
        for (std::size_t i = 0; i < numbers.size(); i += 3) cloud.emplace_back(&numbers[i]);
        return cloud;
    }
    const nlohmann::json& primitive(const nlohmann::json& node) const {
        return json["meshes"][node["mesh"].get<std::size_t>()]["primitives"][0];
    }
    /// Number of the accessor with the values that the animation gives to the property `path` of a node.
    std::size_t track(std::size_t node, const std::string& path) const {
        const nlohmann::json& animation = json["animations"][0];
        for (const nlohmann::json& channel : animation["channels"])
            if (channel["target"]["node"] == node && channel["target"]["path"] == path)
                return animation["samplers"][channel["sampler"].get<std::size_t>()]["output"];
        throw std::out_of_range("no track " + path);
    }

    nlohmann::json json;
    std::string data;
};

}  // namespace sherd::test
