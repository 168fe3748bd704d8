// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstring>

namespace sherd {

/// Four numbers in simultaneous computations, one number for each of four elements. Results have the same
/// bits as computations with a single double, since each operation acts on each number alone.
class Lanes {
  public:
    static constexpr int count = 4;
    /// Aligned to 16 bytes only, since Eigen aligns small matrices no further.
    using Vector [[gnu::vector_size(32), gnu::aligned(16)]] = double;

    Lanes() = default;
    // Copied as one vector: compilers copy a plain struct in parts, and the next operation has to wait for
    // all parts.
    Lanes(const Lanes& o) : v(o.v) {}
    Lanes& operator=(const Lanes& o) {
        v = o.v;
        return *this;
    }
    Lanes(double all) : v{all, all, all, all} {}  // NOLINT: implicit, like conversions of double
    Lanes(const Vector& v) : v(v) {}              // NOLINT
    /// Loads four consecutive numbers, without alignment.
    static Lanes load(const double* from) {
        Vector v;
        std::memcpy(&v, from, sizeof v);
        return v;
    }
    void store(double* to) const { std::memcpy(to, &v, sizeof v); }
    double operator[](int lane) const { return v[lane]; }
    void set(int lane, double value) { v[lane] = value; }

    Lanes& operator+=(const Lanes& o) { return *this = *this + o; }
    Lanes& operator-=(const Lanes& o) { return *this = *this - o; }
    Lanes& operator*=(const Lanes& o) { return *this = *this * o; }
    Lanes& operator/=(const Lanes& o) { return *this = *this / o; }
    friend Lanes operator+(const Lanes& a, const Lanes& b) { return a.v + b.v; }
    friend Lanes operator-(const Lanes& a, const Lanes& b) { return a.v - b.v; }
    friend Lanes operator*(const Lanes& a, const Lanes& b) { return a.v * b.v; }
    friend Lanes operator/(const Lanes& a, const Lanes& b) { return a.v / b.v; }
    friend Lanes operator-(const Lanes& a) { return -a.v; }
    friend Lanes sqrt(const Lanes& a) {
        return Vector{std::sqrt(a.v[0]), std::sqrt(a.v[1]), std::sqrt(a.v[2]), std::sqrt(a.v[3])};
    }
    /// Whether a < b in all lanes.
    friend bool all_less(const Lanes& a, const Lanes& b) {
        const auto less = a.v < b.v;
        return (less[0] & less[1] & less[2] & less[3]) != 0;
    }
    /// Transposes the [4, 4] matrix with the rows a, b, c and d.
    friend void transpose(Lanes& a, Lanes& b, Lanes& c, Lanes& d) {
        const Vector ab0 = __builtin_shufflevector(a.v, b.v, 0, 4, 2, 6);
        const Vector ab1 = __builtin_shufflevector(a.v, b.v, 1, 5, 3, 7);
        const Vector cd0 = __builtin_shufflevector(c.v, d.v, 0, 4, 2, 6);
        const Vector cd1 = __builtin_shufflevector(c.v, d.v, 1, 5, 3, 7);
        a.v = __builtin_shufflevector(ab0, cd0, 0, 1, 4, 5);
        b.v = __builtin_shufflevector(ab1, cd1, 0, 1, 4, 5);
        c.v = __builtin_shufflevector(ab0, cd0, 2, 3, 6, 7);
        d.v = __builtin_shufflevector(ab1, cd1, 2, 3, 6, 7);
    }

  private:
    Vector v;
};

// Loops, with all functions that they call, are compiled twice: for processors with vectors of four numbers,
// and for others. A multiplication and an addition are never contracted to one operation, so that the two
// versions give the same bits.

template <class Body>
[[gnu::flatten, gnu::noinline]] void loop_as_compiled(int begin, int end, const Body& body) {
    for (int i = begin; i < end; ++i) body(i);
}

#ifdef __x86_64__
template <class Body>
[[gnu::target("avx2"), gnu::flatten, gnu::noinline]] void loop_of_four(int begin, int end, const Body& body) {
    for (int i = begin; i < end; ++i) body(i);
}
#endif

/// Calls body(i) for all i from `begin` to before `end`, with the widest vectors that this processor has.
template <class Body>
void wide_loop(int begin, int end, const Body& body) {
#ifdef __x86_64__
    if (__builtin_cpu_supports("avx2")) return loop_of_four(begin, end, body);
#endif
    loop_as_compiled(begin, end, body);
}

}  // namespace sherd

template <>
struct Eigen::NumTraits<sherd::Lanes> : Eigen::GenericNumTraits<sherd::Lanes> {
    using Real = sherd::Lanes;
    using NonInteger = sherd::Lanes;
    using Nested = sherd::Lanes;
    using Literal = double;
    enum { IsComplex = 0, IsInteger = 0, IsSigned = 1, RequireInitialization = 0 };
    enum { ReadCost = 1, AddCost = 1, MulCost = 1 };
};
