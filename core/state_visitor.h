// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <concepts>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <typeinfo>
#include <vector>

namespace sherd {

class StateVisitor;

template <class T>
concept HasState = requires(T& part, StateVisitor& visit) {
    part.visit_state(visit);
};
template <class T>
concept EigenArray = std::derived_from<T, Eigen::PlainObjectBase<T>>;

/// Visits all state that a simulation keeps from one step to the next, to store or to restore it.
///
/// A class with members that own memory has visit_state(), whose structured binding lists all of its members,
/// so that a new member does not compile until it is listed:
///     void visit_state(StateVisitor& visit) { auto& [shell, counted, slopes] = *this; visit(counted); }
/// Members that are listed but not visited are given at construction, or follow bit for bit from the visited
/// members. A type that owns no memory is stored as its bytes, with all of its members; it must hold no
/// pointers. State is restored into an object that was constructed from the same input.
class StateVisitor {
  public:
    virtual ~StateVisitor() = default;
    /// Whether state is restored; if false, it is stored.
    virtual bool reads() const = 0;
    /// Stores or restores bytes. Throws Error if fewer bytes have been stored than are to be restored.
    virtual void bytes(void* data, std::size_t size) = 0;
    /// Begins a class. Throws Error if another class was stored here.
    virtual void enter(const char* type) = 0;

    template <class... Parts>
    void operator()(Parts&... parts) {
        (one(parts), ...);
    }

  private:
    static constexpr const char* other_input = "the state belongs to other input";

    template <class T>
    static constexpr bool is_bytes =
        std::is_trivially_destructible_v<T> && !HasState<T> && !std::is_pointer_v<T> &&
        !std::is_polymorphic_v<T> && std::is_copy_assignable_v<T>;

    template <HasState T>
    void one(T& part) {
        enter(typeid(part).name());
        part.visit_state(*this);
    }
    template <class T>
    requires is_bytes<T>
    void one(T& part) { bytes(&part, sizeof part); }
    template <EigenArray T>
    requires(!is_bytes<T>) void one(T& array) {
        std::array<Eigen::Index, 2> size{array.rows(), array.cols()};
        bytes(&size, sizeof size);
        if (reads()) array.resize(size[0], size[1]);
        bytes(array.data(), sizeof(typename T::Scalar) * static_cast<std::size_t>(array.size()));
    }
    void one(std::string& text) {
        resize(text);
        bytes(text.data(), text.size());
    }
    template <class T>
    void one(std::vector<T>& list) {
        resize(list);
        if constexpr (is_bytes<T>)
            bytes(list.data(), list.size() * sizeof(T));
        else
            for (T& part : list) one(part);
    }
    template <class T, std::size_t N>
    requires(!is_bytes<std::array<T, N>>) void one(std::array<T, N>& list) {
        for (T& part : list) one(part);
    }
    template <class T>
    void one(std::optional<T>& part) {
        bool there = part.has_value();
        bytes(&there, sizeof there);
        if (reads()) part = there ? std::optional<T>(std::in_place) : std::nullopt;
        if (part) one(*part);
    }
    /// Whether a pointer is null is decided at construction.
    template <class T>
    void one(std::unique_ptr<T>& part) {
        bool there = part != nullptr;
        bytes(&there, sizeof there);
        if (there != (part != nullptr)) throw std::runtime_error(other_input);
        if (part) one(*part);
    }
    template <class Key, class T>
    void one(std::map<Key, T>& map) {
        std::size_t size = map.size();
        bytes(&size, sizeof size);
        if (!reads()) {
            for (auto& [key, part] : map) {
                Key copy = key;
                (*this)(copy, part);
            }
            return;
        }
        map.clear();
        for (std::size_t i = 0; i < size; ++i) {
            Key key{};
            one(key);
            one(map[key]);
        }
    }
    /// Lists of elements without a default constructor keep the length that they had at construction.
    template <class List>
    void resize(List& list) {
        std::size_t size = list.size();
        bytes(&size, sizeof size);
        if constexpr (std::default_initializable<typename List::value_type>)
            list.resize(size);
        else if (size != list.size())
            throw std::runtime_error(other_input);
    }
};

/// Whether the class T has these members and no others besides the members of its base. It is for classes
/// with a base, whose members a structured binding cannot list: static_assert(has_only<A, Base,
/// decltype(one), decltype(other)>()). Only a member that fits into padding goes unnoticed.
template <class T, class Base, class... Members>
constexpr bool has_only() {
    std::size_t end = sizeof(Base), alignment = alignof(Base);
    const auto add = [&](std::size_t size, std::size_t aligned) {
        end = (end + aligned - 1) / aligned * aligned + size;
        alignment = std::max(alignment, aligned);
    };
    const auto add_member = [&]<class Member>(std::type_identity<Member>) {
        if constexpr (std::is_reference_v<Member> || std::is_pointer_v<Member>)
            add(sizeof(void*), alignof(void*));
        else
            add(sizeof(Member), alignof(Member));
    };
    (add_member(std::type_identity<Members>()), ...);
    return sizeof(T) == (end + alignment - 1) / alignment * alignment;
}

}  // namespace sherd
