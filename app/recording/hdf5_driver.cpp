// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recording/hdf5_driver.h"

#include <algorithm>
#include <exception>
#include <memory>

#include "app/recording/global_heap.h"
#include "app/recording/hdf5_error.h"

namespace sherd::hdf5 {
namespace {

/// Data that HDF5 passes on to open().
struct DriverInfo {
    ByteFile* file;
};

/// An open file. HDF5 itself sets and uses the members of the base class.
struct OpenFile : H5FD_t {
    ByteFile* bytes = nullptr;
    haddr_t end_of_addresses = 0;
};

OpenFile& open_file(H5FD_t* file) {
    return *static_cast<OpenFile*>(file);
}

const OpenFile& open_file(const H5FD_t* file) {
    return *static_cast<const OpenFile*>(file);
}

/// Calls `action`, and reports its exceptions to HDF5 as errors, since no exception may propagate through the
/// C code of HDF5. Returns 0, or -1 after an exception.
template <class Action>
herr_t without_exceptions(Action action) {
    try {
        action();
        return 0;
    } catch (const std::exception& error) {
        H5Epush2(H5E_DEFAULT, __FILE__, __func__, __LINE__, H5E_ERR_CLS, H5E_VFL, H5E_SYSERRSTR, "%s",
                 error.what());
        return -1;
    }
}

H5FD_t* open(const char*, unsigned, hid_t access, haddr_t) {
    const auto* info = static_cast<const DriverInfo*>(H5Pget_driver_info(access));
    if (info == nullptr) return nullptr;
    auto opened = std::make_unique<OpenFile>();
    opened->bytes = info->file;
    return opened.release();
}

herr_t close(H5FD_t* file) {
    const std::unique_ptr<OpenFile> closed(&open_file(file));
    return 0;
}

/// Reports the features of HDF5's own file driver that affect the layout of a file, so that recordings are as
/// that driver would write them.
herr_t query(const H5FD_t*, unsigned long* features) {
    *features = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA | H5FD_FEAT_DATA_SIEVE |
                H5FD_FEAT_AGGREGATE_SMALLDATA | H5FD_FEAT_DEFAULT_VFD_COMPATIBLE;
    return 0;
}

haddr_t get_end_of_addresses(const H5FD_t* file, H5FD_mem_t) {
    return open_file(file).end_of_addresses;
}

herr_t set_end_of_addresses(H5FD_t* file, H5FD_mem_t, haddr_t address) {
    open_file(file).end_of_addresses = address;
    return 0;
}

haddr_t get_end_of_file(const H5FD_t* file, H5FD_mem_t) {
    return open_file(file).bytes->size();
}

herr_t read(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t address, std::size_t size, void* buffer) {
    return without_exceptions([&] {
        const std::span<std::byte> block{static_cast<std::byte*>(buffer), size};
        open_file(file).bytes->read(address, block);
        require_sound_heap(block);
    });
}

herr_t write(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t address, std::size_t size, const void* buffer) {
    return without_exceptions([&] {
        open_file(file).bytes->write(address, {static_cast<const std::byte*>(buffer), size});
    });
}

herr_t truncate(H5FD_t* file, hid_t, hbool_t) {
    OpenFile& opened = open_file(file);
    return without_exceptions([&] {
        if (opened.bytes->size() != opened.end_of_addresses) opened.bytes->resize(opened.end_of_addresses);
    });
}

Handle register_driver() {
    H5FD_class_t driver{};
#ifdef H5FD_CLASS_VERSION  // members that HDF5 1.14 requires and 1.10 does not have
    driver.version = H5FD_CLASS_VERSION;
    driver.value = 512;  // first number for unregistered drivers
#endif
    driver.name = "sherd";
    driver.maxaddr = HADDR_MAX / 2;
    driver.fc_degree = H5F_CLOSE_STRONG;
    driver.fapl_size = sizeof(DriverInfo);
    driver.open = open;
    driver.close = close;
    driver.query = query;
    driver.get_eoa = get_end_of_addresses;
    driver.set_eoa = set_end_of_addresses;
    driver.get_eof = get_end_of_file;
    driver.read = read;
    driver.write = write;
    driver.truncate = truncate;
    constexpr std::array<H5FD_mem_t, H5FD_MEM_NTYPES> map = H5FD_FLMAP_DICHOTOMY;
    std::ranges::copy(map, driver.fl_map);
    return Handle(H5FDregister(&driver));
}

/// Returns access properties for a file. Closing the file closes all its objects, too (H5F_CLOSE_STRONG). The
/// file has the format of HDF5 1.10, in which all metadata have checksums; without checksums HDF5 may read
/// anywhere in a damaged file. The format is also smaller and faster to write.
Handle access_to(ByteFile& file, const Handle& driver) {
    const DriverInfo info{&file};
    Handle access(H5Pcreate(H5P_FILE_ACCESS));
    if (driver < 0 || access < 0 || H5Pset_driver(access, driver, &info) < 0 ||
        H5Pset_fclose_degree(access, H5F_CLOSE_STRONG) < 0 ||
        H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_V110) < 0)
        fail("cannot prepare HDF5");
    return access;
}

hid_t opened_file(const std::string& name, Access access, const Handle& how) {
    if (access == Access::create)
        return checked(H5Fcreate(name.c_str(), H5F_ACC_TRUNC, timeless(H5P_FILE_CREATE), how),
                       "cannot create '" + name + "'");
    const unsigned flags = access == Access::write ? H5F_ACC_RDWR : H5F_ACC_RDONLY;
    return checked(H5Fopen(name.c_str(), flags, how), "cannot open '" + name + "'");
}

}  // namespace

OpenedFile open_in(ByteFile& file, const std::string& name, Access access) {
    silence_errors();
    Handle driver = register_driver();
    const Handle how = access_to(file, driver);
    return {std::move(driver), Handle(opened_file(name, access, how))};
}

}  // namespace sherd::hdf5
