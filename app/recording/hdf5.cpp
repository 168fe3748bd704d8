// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recording/hdf5.h"

#include <algorithm>

#include "app/files/picture/image.h"
#include "app/recording/hdf5_error.h"
#include "meshops/error.h"

namespace sherd::hdf5 {

namespace {

Handle open_dataset(hid_t where, const std::string& name) {
    return Handle(checked(H5Dopen2(where, name.c_str(), H5P_DEFAULT), "cannot open dataset '" + name + "'"));
}

Handle text_type() {
    Handle type(checked(H5Tcopy(H5T_C_S1), "cannot make a text type"));
    H5Tset_size(type, H5T_VARIABLE);
    H5Tset_cset(type, H5T_CSET_UTF8);
    return type;
}

void store_attribute(hid_t where, const std::string& name, hid_t type, const void* value) {
    const std::string what = "cannot write attribute '" + name + "'";
    const bool exists = checked(H5Aexists(where, name.c_str()), what) > 0;
    const Handle space(H5Screate(H5S_SCALAR));
    const Handle attribute(
        checked(exists ? H5Aopen(where, name.c_str(), H5P_DEFAULT)
                       : H5Acreate2(where, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT),
                what));
    checked(H5Awrite(attribute, type, value), what);
}

/// Opens an attribute; throws Error (run) unless it has a single value of the type class `kind`.
Handle open_attribute(hid_t where, const std::string& name, H5T_class_t kind) {
    const std::string what = "cannot read attribute '" + name + "'";
    Handle attribute(checked(H5Aopen(where, name.c_str(), H5P_DEFAULT), what));
    const Handle type(checked(H5Aget_type(attribute), what));
    const Handle space(checked(H5Aget_space(attribute), what));
    if (H5Tget_class(type) != kind || H5Sget_simple_extent_npoints(space) != 1)
        throw Error(what + ": not of the expected type", Fault::run);
    return attribute;
}

template <class T>
T read_number(hid_t where, const std::string& name, H5T_class_t kind) {
    T value{};
    const Handle attribute = open_attribute(where, name, kind);
    checked(H5Aread(attribute, native_type<T>(), &value), "cannot read attribute '" + name + "'");
    return value;
}

/// Returns the text of a variable-length string that HDF5 allocated, and frees the string.
std::string taken(char* text) {
    std::string value = text ? text : "";
    H5free_memory(text);
    return value;
}

Handle new_group(hid_t where, const std::string& name) {
    return Handle(
        checked(H5Gcreate2(where, name.c_str(), H5P_DEFAULT, timeless(H5P_GROUP_CREATE), H5P_DEFAULT),
                "cannot create group '" + name + "'"));
}

/// Creates the missing parent groups of `name`. HDF5 itself would create them with their time of creation.
void make_groups_above(hid_t where, const std::string& name) {
    for (std::size_t end = name.find('/', 1); end != std::string::npos; end = name.find('/', end + 1))
        if (const std::string above = name.substr(0, end); !contains(where, above)) new_group(where, above);
}

Handle create_dataset(hid_t where, const std::string& name, hid_t type, hid_t space, hid_t layout) {
    make_groups_above(where, name);
    return Handle(checked(H5Dcreate2(where, name.c_str(), type, space, H5P_DEFAULT, layout, H5P_DEFAULT),
                          "cannot create dataset '" + name + "'"));
}

void write_lines(hid_t where, const std::string& name, const Handle& space, const char* const* lines) {
    const Handle type = text_type();
    const Handle dataset = create_dataset(where, name, type, space, timeless(H5P_DATASET_CREATE));
    if (H5Sget_simple_extent_npoints(space) > 0)
        checked(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, lines),
                "cannot write dataset '" + name + "'");
}

void read_lines(const Handle& dataset, const std::string& name, char** lines) {
    checked(H5Dread(dataset, text_type(), H5S_ALL, H5S_ALL, H5P_DEFAULT, lines),
            "cannot read dataset '" + name + "'");
}

void describe(hid_t dataset, const Meaning& meaning) {
    write_attribute(dataset, "unit", std::string(meaning.unit));
    if (*meaning.description) write_attribute(dataset, "description", std::string(meaning.description));
}

/// Throws Error (run) if the header of a dataset claims more values than its stored bytes can hold: readers
/// allocate what the header claims.
void require_stored(hid_t dataset, const std::string& name, const std::vector<hsize_t>& shape) {
    constexpr double few = 1 << 17;  // number of values that need no check
    double values = 1;
    for (const hsize_t length : shape) values *= static_cast<double>(length);
    if (values < few) return;
    const auto stored = static_cast<double>(H5Dget_storage_size(dataset));
    if (values > static_cast<double>(most_of_a_deflated_byte) * stored)
        throw Error("dataset '" + name + "' promises more values than the file holds", Fault::run);
}

int rank_of(hsize_t width) {
    return width == 1 ? 1 : 2;
}

}  // namespace

Handle timeless(hid_t kind) {
    Handle properties(checked(H5Pcreate(kind), "cannot prepare HDF5"));
    checked(H5Pset_obj_track_times(properties, false), "cannot prepare HDF5");
    return properties;
}

void Handle::close(const std::string& what) {
    checked(H5Idec_ref(std::exchange(id, H5I_INVALID_HID)), "cannot close " + what);
}

Handle create_group(hid_t where, const std::string& name) {
    make_groups_above(where, name);
    return new_group(where, name);
}

Handle open_group(hid_t where, const std::string& name) {
    return Handle(checked(H5Gopen2(where, name.c_str(), H5P_DEFAULT), "cannot open group '" + name + "'"));
}

bool contains(hid_t where, const std::string& name) {
    return H5Lexists(where, name.c_str(), H5P_DEFAULT) > 0;
}

std::size_t member_count(hid_t where, const std::string& group) {
    H5G_info_t info;
    checked(H5Gget_info_by_name(where, group.c_str(), &info, H5P_DEFAULT),
            "cannot open group '" + group + "'");
    return info.nlinks;
}

std::vector<std::string> member_names(hid_t where, const std::string& group) {
    std::vector<std::string> names(member_count(where, group));
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto name = [&](char* buffer, std::size_t size) {
            return H5Lget_name_by_idx(where, group.c_str(), H5_INDEX_NAME, H5_ITER_INC, i, buffer, size,
                                      H5P_DEFAULT);
        };
        const ssize_t length = name(nullptr, 0);
        if (length < 0) throw Error("cannot read the names in group '" + group + "'", Fault::run);
        names[i].resize(static_cast<std::size_t>(length));
        name(names[i].data(), names[i].size() + 1);
    }
    return names;
}

void remove(hid_t where, const std::string& name) {
    checked(H5Ldelete(where, name.c_str(), H5P_DEFAULT), "cannot remove '" + name + "'");
}

void create_link(hid_t where, const std::string& name, const std::string& target) {
    checked(H5Lcreate_soft(target.c_str(), where, name.c_str(), H5P_DEFAULT, H5P_DEFAULT),
            "cannot create link '" + name + "'");
}

void write_attribute(hid_t where, const std::string& name, const std::string& value) {
    const char* text = value.c_str();
    store_attribute(where, name, text_type(), &text);
}

void write_attribute(hid_t where, const std::string& name, double value) {
    store_attribute(where, name, H5T_NATIVE_DOUBLE, &value);
}

void write_attribute(hid_t where, const std::string& name, std::int64_t value) {
    store_attribute(where, name, H5T_NATIVE_INT64, &value);
}

std::string read_text_attribute(hid_t where, const std::string& name) {
    const Handle attribute = open_attribute(where, name, H5T_STRING);
    char* text = nullptr;
    checked(H5Aread(attribute, text_type(), &text), "cannot read attribute '" + name + "'");
    return taken(text);
}

bool has_attribute(hid_t where, const std::string& name) {
    return H5Aexists(where, name.c_str()) > 0;
}

double read_real_attribute(hid_t where, const std::string& name) {
    return read_number<double>(where, name, H5T_FLOAT);
}

std::int64_t read_integer_attribute(hid_t where, const std::string& name) {
    return read_number<std::int64_t>(where, name, H5T_INTEGER);
}

void write_text(hid_t where, const std::string& name, const std::string& text) {
    const char* line = text.c_str();
    write_lines(where, name, Handle(H5Screate(H5S_SCALAR)), &line);
}

std::string read_text(hid_t where, const std::string& name) {
    const Handle dataset = open_dataset(where, name);
    const Handle space(H5Dget_space(dataset));
    char* line = nullptr;
    if (H5Sget_simple_extent_npoints(space) != 1)
        throw Error("dataset '" + name + "' is not one text", Fault::run);
    read_lines(dataset, name, &line);
    return taken(line);
}

void write_texts(hid_t where, const std::string& name, const std::vector<std::string>& texts) {
    std::vector<const char*> lines;
    for (const std::string& text : texts) lines.push_back(text.c_str());
    const hsize_t rows = lines.size();
    write_lines(where, name, Handle(H5Screate_simple(1, &rows, nullptr)), lines.data());
}

std::vector<std::string> read_texts(hid_t where, const std::string& name) {
    std::vector<char*> lines(row_count(where, name, 1), nullptr);
    if (!lines.empty()) read_lines(open_dataset(where, name), name, lines.data());
    std::vector<std::string> texts;
    for (char* line : lines) texts.push_back(taken(line));
    return texts;
}

void create_array(hid_t where, const std::string& name, hid_t type, std::span<const hsize_t> shape,
                  const void* values, const Meaning& meaning) {
    const std::string what = "cannot write dataset '" + name + "'";
    const int rank = static_cast<int>(shape.size());
    const Handle space(checked(H5Screate_simple(rank, shape.data(), nullptr), what));
    const Handle layout = timeless(H5P_DATASET_CREATE);
    const bool empty = H5Sget_simple_extent_npoints(space) == 0;
    if (!empty) {
        // A chunk is large enough that a frame of an ordinary plate is one chunk, and small enough for HDF5's
        // chunk cache.
        std::vector<hsize_t> chunk(shape.begin(), shape.end());
        hsize_t& rows = chunk[rank == 1 ? 0 : rank - 2];
        rows = std::min<hsize_t>(rows, 32768);
        if (rank > 2) chunk[0] = 1;
        checked(H5Pset_chunk(layout, rank, chunk.data()), what);
        checked(H5Pset_shuffle(layout), what);
        checked(H5Pset_deflate(layout, 4), what);
    }
    const Handle dataset = create_dataset(where, name, type, space, layout);
    if (!empty) checked(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), what);
    describe(dataset, meaning);
}

void create_table(hid_t where, const std::string& name, hid_t type, hsize_t width, const Meaning& meaning) {
    const std::string what = "cannot create dataset '" + name + "'";
    const std::array<hsize_t, 2> shape{0, width}, limit{H5S_UNLIMITED, width}, chunk{128, width};
    const Handle space(checked(H5Screate_simple(rank_of(width), shape.data(), limit.data()), what));
    const Handle layout = timeless(H5P_DATASET_CREATE);
    checked(H5Pset_chunk(layout, rank_of(width), chunk.data()), what);
    const Handle dataset = create_dataset(where, name, type, space, layout);
    describe(dataset, meaning);
}

void append_table(hid_t where, const std::string& name, hid_t type, hsize_t rows, hsize_t width,
                  const void* values) {
    if (rows == 0) return;
    const std::string what = "cannot append to dataset '" + name + "'";
    const std::array<hsize_t, 2> start{row_count(where, name, width), 0}, count{rows, width},
        shape{start[0] + rows, width};
    const Handle dataset = open_dataset(where, name);
    checked(H5Dset_extent(dataset, shape.data()), what);
    const Handle target(checked(H5Dget_space(dataset), what));
    checked(H5Sselect_hyperslab(target, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr), what);
    const Handle source(checked(H5Screate_simple(rank_of(width), count.data(), nullptr), what));
    checked(H5Dwrite(dataset, type, source, target, H5P_DEFAULT, values), what);
}

void read_array(hid_t where, const std::string& name, hid_t type, void* values) {
    const Handle dataset = open_dataset(where, name);
    checked(H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values),
            "cannot read dataset '" + name + "'");
}

void read_array(hid_t where, const std::string& name, hid_t type, hsize_t width, void* values) {
    if (row_count(where, name, width) > 0) read_array(where, name, type, values);
}

std::vector<hsize_t> shape_of(hid_t where, const std::string& name) {
    const Handle dataset = open_dataset(where, name);
    const Handle space(checked(H5Dget_space(dataset), "cannot read dataset '" + name + "'"));
    std::vector<hsize_t> shape(std::max(0, H5Sget_simple_extent_ndims(space)));
    H5Sget_simple_extent_dims(space, shape.data(), nullptr);
    require_stored(dataset, name, shape);
    return shape;
}

hsize_t row_count(hid_t where, const std::string& name, hsize_t width) {
    const std::vector<hsize_t> shape = shape_of(where, name);
    const bool fits = shape.size() == static_cast<std::size_t>(rank_of(width));
    if (!fits || (shape.size() == 2 && shape[1] != width))
        throw Error("dataset '" + name + "' does not have " + std::to_string(width) + " value(s) a row",
                    Fault::run);
    return shape[0];
}

void resize_table(hid_t where, const std::string& name, hsize_t rows) {
    const Handle dataset = open_dataset(where, name);
    const Handle space(checked(H5Dget_space(dataset), "cannot resize dataset '" + name + "'"));
    std::array<hsize_t, 2> shape{};
    H5Sget_simple_extent_dims(space, shape.data(), nullptr);
    shape[0] = rows;
    checked(H5Dset_extent(dataset, shape.data()), "cannot resize dataset '" + name + "'");
}

}  // namespace sherd::hdf5
