// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hdf5.h>

#include <array>
#include <concepts>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/vector.h"

/// Functions of HDF5 that a recording needs. Every function throws Error (Fault::run) on failure, with the
/// name of the object and HDF5's own reason.
namespace sherd::hdf5 {

/// Owns an HDF5 identifier of any kind.
class Handle {
  public:
    explicit Handle(hid_t id = H5I_INVALID_HID) : id(id) {}
    Handle(Handle&& other) noexcept : id(std::exchange(other.id, H5I_INVALID_HID)) {}
    Handle& operator=(Handle&& other) noexcept {
        std::swap(id, other.id);
        return *this;
    }
    ~Handle() {
        if (id >= 0) H5Idec_ref(id);
    }
    operator hid_t() const { return id; }

    /// Releases the identifier now, and throws Error if that fails, for example because a delayed write
    /// fails. what: name of the object for the message.
    void close(const std::string& what);

  private:
    hid_t id;
};

/// How a dataset stores values of a C++ type: [rows] of `Scalar` if `width` is 1, otherwise [rows, width].
template <class T>
struct Element {
    using Scalar = T;
    static constexpr hsize_t width = 1;
};
template <class T>
requires std::is_enum_v<T>
struct Element<T> {
    using Scalar = std::underlying_type_t<T>;
    static constexpr hsize_t width = 1;
};
template <class T>
requires(T::SizeAtCompileTime > 0) struct Element<T> {
    using Scalar = typename T::Scalar;
    static constexpr hsize_t width = T::SizeAtCompileTime;
};
template <class T, std::size_t N>
struct Element<std::array<T, N>> {
    using Scalar = typename Element<T>::Scalar;
    static constexpr hsize_t width = N * Element<T>::width;
};

template <class Scalar>
hid_t native_type() {
    if constexpr (std::same_as<Scalar, double>) return H5T_NATIVE_DOUBLE;
    if constexpr (std::same_as<Scalar, std::int32_t>) return H5T_NATIVE_INT32;
    if constexpr (std::same_as<Scalar, std::int64_t>) return H5T_NATIVE_INT64;
    if constexpr (std::same_as<Scalar, std::uint8_t>) return H5T_NATIVE_UINT8;
}

/// Unit and description of a dataset, stored as the attributes `unit` and `description`.
struct Meaning {
    const char* unit = "1";
    const char* description = "";
};

/// In all functions below, `name` is the path of an object below `where`. Functions that create an object
/// also create the missing groups of its path.
Handle create_group(hid_t where, const std::string& name);
Handle open_group(hid_t where, const std::string& name);
bool contains(hid_t where, const std::string& name);
std::size_t member_count(hid_t where, const std::string& group);
/// Returns creation properties of the HDF5 class `kind`, without a time of creation, so that equal runs give
/// equal files.
Handle timeless(hid_t kind);
/// Returns the names in a group, in alphabetical order.
std::vector<std::string> member_names(hid_t where, const std::string& group);
void remove(hid_t where, const std::string& name);
/// Creates a soft link to the path `target` of the same file.
void create_link(hid_t where, const std::string& name, const std::string& target);

/// Attributes of a file, group or dataset. Writing an existing attribute replaces its value.
void write_attribute(hid_t where, const std::string& name, const std::string& value);
void write_attribute(hid_t where, const std::string& name, double value);
void write_attribute(hid_t where, const std::string& name, std::int64_t value);
bool has_attribute(hid_t where, const std::string& name);
std::string read_text_attribute(hid_t where, const std::string& name);
double read_real_attribute(hid_t where, const std::string& name);
std::int64_t read_integer_attribute(hid_t where, const std::string& name);

void write_text(hid_t where, const std::string& name, const std::string& text);
std::string read_text(hid_t where, const std::string& name);
void write_texts(hid_t where, const std::string& name, const std::vector<std::string>& texts);
std::vector<std::string> read_texts(hid_t where, const std::string& name);

/// Untyped versions of the functions below; `type` is HDF5's type of the values in memory.
void create_array(hid_t where, const std::string& name, hid_t type, std::span<const hsize_t> shape,
                  const void* values, const Meaning& meaning);
inline void create_array(hid_t where, const std::string& name, hid_t type, hsize_t rows, hsize_t width,
                         const void* values, const Meaning& meaning) {
    const std::array<hsize_t, 2> shape{rows, width};
    create_array(where, name, type, std::span(shape).first(width == 1 ? 1 : 2), values, meaning);
}
void create_table(hid_t where, const std::string& name, hid_t type, hsize_t width, const Meaning& meaning);
void append_table(hid_t where, const std::string& name, hid_t type, hsize_t rows, hsize_t width,
                  const void* values);
/// Reads a whole dataset into `values`. The function with `width` throws Error unless the dataset has `width`
/// values in each row, and reads nothing if there are no rows.
void read_array(hid_t where, const std::string& name, hid_t type, void* values);
void read_array(hid_t where, const std::string& name, hid_t type, hsize_t width, void* values);
/// Returns the lengths of a dataset along its dimensions.
std::vector<hsize_t> shape_of(hid_t where, const std::string& name);
/// Returns the number of rows of a dataset; throws Error unless each row has `width` values.
hsize_t row_count(hid_t where, const std::string& name, hsize_t width);
void resize_table(hid_t where, const std::string& name, hsize_t rows);

/// Creates a compressed dataset of fixed size.
template <class T>
void write(hid_t where, const std::string& name, std::span<const T> values, const Meaning& meaning) {
    using E = Element<T>;
    create_array(where, name, native_type<typename E::Scalar>(), values.size(), E::width, values.data(),
                 meaning);
}

/// Creates an empty dataset, to which append() adds rows.
template <class T>
void create_column(hid_t where, const std::string& name, const Meaning& meaning) {
    create_table(where, name, native_type<typename Element<T>::Scalar>(), Element<T>::width, meaning);
}

template <class T>
void append(hid_t where, const std::string& name, std::span<const T> values) {
    using E = Element<T>;
    append_table(where, name, native_type<typename E::Scalar>(), values.size(), E::width, values.data());
}

template <class T>
std::vector<T> read(hid_t where, const std::string& name) {
    using E = Element<T>;
    std::vector<T> values(row_count(where, name, E::width));
    read_array(where, name, native_type<typename E::Scalar>(), E::width, values.data());
    return values;
}

}  // namespace sherd::hdf5
