// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/glb_file.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>

#include "app/files/picture/image.h"
#include "app/render/material_look.h"
#include "app/render/render_obstacle.h"
#include "app/render/trace/render_light.h"
#include "meshops/error.h"

namespace sherd {

namespace {

using Rows = std::vector<std::vector<double>>;

/// A glTF model under construction.
class Model {
  public:
    Model(const GlbScene& scene, std::vector<std::string>& warnings);
    void add(const GlbNode& node);
    std::string bytes();

  private:
    int add_view(const void* data, std::size_t bytes, int target);
    int add_accessor(const void* data, std::size_t bytes, std::size_t count, int component, int type,
                     int target);
    int add_rows(const Rows& rows, int type, bool bounds, int target);
    int add_vectors(const std::vector<Vector3d>& vectors, bool bounds);
    int add_texture(const std::vector<Eigen::Vector2d>& texture);
    int add_colours(const std::vector<Colour>& colours);
    int add_numbers(const std::vector<double>& numbers);
    int add_material(const std::string& name, bool double_sided, const Eigen::Vector3f& colour);
    int obstacle_material();
    int sheet_material();
    int surface_material(const FaceMaterial& material);
    int add_picture(const std::filesystem::path& file);
    tinygltf::Primitive surface(const GlbNode& node);
    std::vector<std::pair<int, std::vector<std::array<Index, 3>>>> parts(const GlbNode& node);
    int add_mesh(const GlbNode& node);
    void animate(int node, const char* path, int output);
    void animate_motion(int number, const GlbNode& node);
    void animate_shape(int number);

    tinygltf::Model model;
    std::vector<unsigned char> data;
    int times = -1, weights = -1, grey = -1, white = -1;
    bool double_sided;
    std::vector<std::pair<FaceMaterial, int>> materials;  ///< materials of surfaces, and indices in the model
    std::map<std::filesystem::path, int> pictures;        ///< index of each picture's texture; -1: unreadable
    std::vector<std::string>& warnings;
    std::size_t time_count;
};

Rows rows_of(const std::vector<double>& values) {
    Rows rows;
    for (const double value : values) rows.push_back({value});
    return rows;
}

Model::Model(const GlbScene& scene, std::vector<std::string>& warnings)
    : double_sided(scene.double_sided), warnings(warnings), time_count(scene.times.size()) {
    model.asset.version = "2.0";
    model.asset.generator = "sherd " SHERD_VERSION;
    tinygltf::Node root;
    root.name = scene.name;
    root.rotation = {-std::sqrt(0.5), 0, 0, std::sqrt(0.5)};
    model.nodes.push_back(root);
    tinygltf::Scene shown;
    shown.nodes = {0};
    model.scenes.push_back(shown);
    model.defaultScene = 0;
    if (time_count < 2) return;
    model.animations.emplace_back().name = scene.name;
    times = add_rows(rows_of(scene.times), TINYGLTF_TYPE_SCALAR, true, 0);
}

int Model::add_material(const std::string& name, bool double_sided, const Eigen::Vector3f& colour) {
    tinygltf::Material material;
    material.name = name;
    material.doubleSided = double_sided;
    material.pbrMetallicRoughness.baseColorFactor = {colour[0], colour[1], colour[2], 1};
    material.pbrMetallicRoughness.metallicFactor = 0;
    material.pbrMetallicRoughness.roughnessFactor = 0.6;
    model.materials.push_back(material);
    return static_cast<int>(model.materials.size()) - 1;
}

int Model::obstacle_material() {
    if (grey < 0) grey = add_material("obstacle", false, linear_colour(obstacle_grey));
    return grey;
}

int Model::sheet_material() {
    if (white < 0) white = add_material("sheet", double_sided, Eigen::Vector3f::Ones());
    return white;
}

int Model::surface_material(const FaceMaterial& material) {
    if (!material) return sheet_material();
    for (const auto& [known, number] : materials)
        if (is_same(known, material)) return number;
    const MaterialLook look = material_look(*material);
    const int number = add_material(material->name, double_sided, look.colour);
    materials.emplace_back(material, number);
    const int picture = look.picture.empty() ? -1 : add_picture(look.picture);
    tinygltf::Material& made = model.materials[number];
    made.pbrMetallicRoughness.roughnessFactor = look.roughness;
    made.emissiveFactor = {look.glow[0], look.glow[1], look.glow[2]};
    if (picture >= 0) {
        made.pbrMetallicRoughness.baseColorFactor = {1, 1, 1, 1};
        made.pbrMetallicRoughness.baseColorTexture.index = picture;
    }
    made.pbrMetallicRoughness.baseColorFactor[3] = look.opacity;
    if (look.opacity < 1) made.alphaMode = "BLEND";
    return number;
}

/// Returns the index of the picture's texture, which is added if necessary, or -1 if the picture cannot be
/// read. Warns of an unreadable picture once.
int Model::add_picture(const std::filesystem::path& file) {
    const auto [entry, is_new] = pictures.try_emplace(file, -1);
    if (!is_new) return entry->second;
    tinygltf::Image image;
    try {
        const PictureFile picture = read_picture_file(file);
        image.bufferView = add_view(picture.bytes.data(), picture.bytes.size(), 0);
        image.mimeType = picture.media_type();
    } catch (const Error& error) {
        warnings.push_back(std::string(error.what()) + "; the .glb has the colour of its material only");
        return -1;
    }
    image.name = file.stem().string();
    model.images.push_back(image);
    tinygltf::Texture texture;
    texture.source = static_cast<int>(model.images.size()) - 1;
    model.textures.push_back(texture);
    return entry->second = static_cast<int>(model.textures.size()) - 1;
}

/// Adds bytes to the buffer, from a multiple of four on, and a view of them. Returns the view's index.
int Model::add_view(const void* values, std::size_t bytes, int target) {
    data.resize((data.size() + 3) / 4 * 4);
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = data.size();
    view.byteLength = bytes;
    view.target = target;
    model.bufferViews.push_back(view);
    const auto* begin = static_cast<const unsigned char*>(values);
    data.insert(data.end(), begin, begin + bytes);
    // Sizes in the file have 32 bits, and many readers use signed ones.
    if (data.size() > std::numeric_limits<std::int32_t>::max())
        throw Error("a glb file holds 2 GB at most: choose fewer --frames, or --animate rigid");
    return static_cast<int>(model.bufferViews.size()) - 1;
}

int Model::add_accessor(const void* values, std::size_t bytes, std::size_t count, int component, int type,
                        int target) {
    tinygltf::Accessor accessor;
    accessor.bufferView = add_view(values, bytes, target);
    accessor.componentType = component;
    accessor.count = count;
    accessor.type = type;
    model.accessors.push_back(accessor);
    return static_cast<int>(model.accessors.size()) - 1;
}

int Model::add_rows(const Rows& rows, int type, bool bounds, int target) {
    std::vector<float> values;
    for (const auto& row : rows) values.insert(values.end(), row.begin(), row.end());
    const int accessor = add_accessor(values.data(), values.size() * sizeof(float), rows.size(),
                                      TINYGLTF_COMPONENT_TYPE_FLOAT, type, target);
    if (!bounds) return accessor;
    // The bounds are those of the values as rounded to float, since a reader compares these.
    const std::size_t width = rows.front().size();
    auto &lower = model.accessors.back().minValues, &upper = model.accessors.back().maxValues;
    lower.assign(values.begin(), values.begin() + static_cast<long>(width));
    upper = lower;
    for (std::size_t i = 0; i < values.size(); ++i) {
        lower[i % width] = std::min<double>(lower[i % width], values[i]);
        upper[i % width] = std::max<double>(upper[i % width], values[i]);
    }
    return accessor;
}

int Model::add_vectors(const std::vector<Vector3d>& vectors, bool bounds) {
    Rows rows;
    for (const Vector3d& vector : vectors) rows.push_back({vector.x(), vector.y(), vector.z()});
    return add_rows(rows, TINYGLTF_TYPE_VEC3, bounds, TINYGLTF_TARGET_ARRAY_BUFFER);
}

/// Adds texture coordinates, with v downwards, as in glTF.
int Model::add_texture(const std::vector<Eigen::Vector2d>& texture) {
    Rows rows;
    for (const Eigen::Vector2d& uv : texture) rows.push_back({uv.x(), 1 - uv.y()});
    return add_rows(rows, TINYGLTF_TYPE_VEC2, false, TINYGLTF_TARGET_ARRAY_BUFFER);
}

int Model::add_colours(const std::vector<Colour>& colours) {
    Rows rows;
    for (const Colour& colour : colours) {
        const Eigen::Vector3f light = linear_colour(colour);
        rows.push_back({light[0], light[1], light[2], colour[3] / 255.0});
    }
    return add_rows(rows, TINYGLTF_TYPE_VEC4, false, TINYGLTF_TARGET_ARRAY_BUFFER);
}

int Model::add_numbers(const std::vector<double>& numbers) {
    Rows rows;
    for (const double number : numbers) rows.push_back({number});
    return add_rows(rows, TINYGLTF_TYPE_SCALAR, false, TINYGLTF_TARGET_ARRAY_BUFFER);
}

std::vector<Vector3d> differences(const std::vector<Vector3d>& to, const std::vector<Vector3d>& from) {
    std::vector<Vector3d> result;
    for (std::size_t i = 0; i < to.size(); ++i) result.push_back(to[i] - from[i]);
    return result;
}

/// Attributes and morph targets that all parts of a node's mesh share.
tinygltf::Primitive Model::surface(const GlbNode& node) {
    tinygltf::Primitive primitive;
    primitive.mode = TINYGLTF_MODE_TRIANGLES;
    const GlbShape& first = node.shapes.front();
    primitive.attributes["POSITION"] = add_vectors(first.points, true);
    primitive.attributes["NORMAL"] = add_vectors(first.normals, false);
    if (!node.texture.empty()) primitive.attributes["TEXCOORD_0"] = add_texture(node.texture);
    if (!node.colour.empty()) primitive.attributes["COLOR_0"] = add_colours(node.colour);
    for (const auto& [name, values] : node.numbers) primitive.attributes["_" + name] = add_numbers(values);
    for (std::size_t i = 1; i < node.shapes.size(); ++i)
        primitive.targets.push_back(
            {{"POSITION", add_vectors(differences(node.shapes[i].points, first.points), true)},
             {"NORMAL", add_vectors(differences(node.shapes[i].normals, first.normals), false)}});
    return primitive;
}

/// The triangles of a node by index of their material, in the order in which materials first occur.
std::vector<std::pair<int, std::vector<std::array<Index, 3>>>> Model::parts(const GlbNode& node) {
    std::vector<std::pair<int, std::vector<std::array<Index, 3>>>> result;
    for (std::size_t t = 0; t < node.triangles.size(); ++t) {
        const FaceMaterial own = node.material.empty() ? nullptr : node.material[t];
        const int material = node.obstacle ? obstacle_material() : surface_material(own);
        auto part = std::ranges::find(result, material, [](const auto& known) { return known.first; });
        if (part == result.end()) part = result.insert(part, {material, {}});
        part->second.push_back(node.triangles[t]);
    }
    return result;
}

int Model::add_mesh(const GlbNode& node) {
    tinygltf::Primitive primitive = surface(node);
    tinygltf::Mesh mesh;
    mesh.name = node.name;
    for (const auto& [material, triangles] : parts(node)) {
        primitive.material = material;
        primitive.indices = add_accessor(triangles.data(), triangles.size() * sizeof triangles[0],
                                         3 * triangles.size(), TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT,
                                         TINYGLTF_TYPE_SCALAR, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
        mesh.primitives.push_back(primitive);
    }
    mesh.weights.assign(node.shapes.size() - 1, 0.0);
    model.meshes.push_back(mesh);
    return static_cast<int>(model.meshes.size()) - 1;
}

void Model::animate(int node, const char* path, int output) {
    tinygltf::Animation& animation = model.animations.front();
    tinygltf::AnimationSampler sampler;
    sampler.input = times;
    sampler.output = output;
    sampler.interpolation = "LINEAR";
    animation.samplers.push_back(sampler);
    tinygltf::AnimationChannel channel;
    channel.sampler = static_cast<int>(animation.samplers.size()) - 1;
    channel.target_node = node;
    channel.target_path = path;
    animation.channels.push_back(channel);
}

void Model::animate_motion(int number, const GlbNode& node) {
    Rows translations, rotations;
    Eigen::Quaterniond last(1, 0, 0, 0);
    for (const Eigen::Isometry3d& motion : node.motions) {
        const Vector3d t = motion.translation();
        translations.push_back({t.x(), t.y(), t.z()});
        Eigen::Quaterniond q(motion.linear());
        q.normalize();
        // q and -q are the same rotation, but interpolation between keys depends on the sign.
        if (q.dot(last) < 0) q.coeffs() *= -1;
        last = q;
        rotations.push_back({q.x(), q.y(), q.z(), q.w()});
    }
    model.nodes[number].translation = translations.front();
    model.nodes[number].rotation = rotations.front();
    if (node.motions.size() < 2) return;
    animate(number, "translation", add_rows(translations, TINYGLTF_TYPE_VEC3, false, 0));
    animate(number, "rotation", add_rows(rotations, TINYGLTF_TYPE_VEC4, false, 0));
}

/// Adds an animation of the weights of a node's morph targets: at time i only target i - 1 has the weight 1,
/// the others have 0. All nodes share the array of weights.
void Model::animate_shape(int number) {
    if (weights < 0) {
        Rows values;
        for (std::size_t i = 0; i < time_count; ++i)
            for (std::size_t target = 1; target < time_count; ++target)
                values.push_back({i == target ? 1.0 : 0.0});
        weights = add_rows(values, TINYGLTF_TYPE_SCALAR, false, 0);
    }
    animate(number, "weights", weights);
}

void Model::add(const GlbNode& part) {
    const int number = static_cast<int>(model.nodes.size());
    tinygltf::Node node;
    node.name = part.name;
    node.mesh = add_mesh(part);
    model.nodes.push_back(node);
    model.nodes[0].children.push_back(number);
    animate_motion(number, part);
    if (part.shapes.size() > 1) animate_shape(number);
}

std::string Model::bytes() {
    tinygltf::Buffer buffer;
    buffer.data = std::move(data);
    model.buffers.push_back(std::move(buffer));
    std::ostringstream stream;
    tinygltf::TinyGLTF writer;
    const bool pretty = false, binary = true;
    if (!writer.WriteGltfSceneToStream(&model, stream, pretty, binary))
        throw Error("the glb file cannot be put together", Fault::run);
    return std::move(stream).str();
}

}  // namespace

std::string glb_bytes(const GlbScene& scene, std::vector<std::string>& warnings) {
    Model model(scene, warnings);
    for (const GlbNode& node : scene.nodes) model.add(node);
    return model.bytes();
}

}  // namespace sherd
