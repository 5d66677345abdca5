/// \file
/// Particles: one contiguous column of numbers per component of each field, and nothing else.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

#include <mote/core/aligned.hpp>
#include <mote/core/field.hpp>
#include <mote/core/pack.hpp>

namespace mote {

namespace detail {

template <class Tag, class T>
struct Stored {
  using type = T;
};
template <class Tag, class T>
requires requires { typename Tag::stored; }
struct Stored<Tag, T> {
  using type = typename Tag::stored;
};

template <class Tag, class T, int D>
struct Column {
  using stored = typename Stored<Tag, T>::type;
  static constexpr int components = Tag::shape::template components<D>;
  std::array<StaggeredVector<stored>, std::size_t(components)> data;
};

}  // namespace detail

/// Columns for exactly the fields in List, number type T, D dimensions.
///
/// Between sorts particle i stays where it is; a sort moves all columns alike. field::Id tells who is who.
template <class T, int D, class List>
class Particles;

template <class T, int D, class... Tags>
class Particles<T, D, fields<Tags...>> {
  std::tuple<detail::Column<Tags, T, D>...> columns_;
  std::size_t size_ = 0;

 public:
  using list = fields<Tags...>;
  static constexpr int dimension = D;

  Particles() {
    int number = 0;
    for_each_column([&]<class V>(V& column) { column = V(typename V::allocator_type(number++)); });
  }

  /// Bytes that one particle takes in the columns.
  static constexpr int bytes_per_particle =
      (0 + ... +
       int(sizeof(typename detail::Column<Tags, T, D>::stored) * std::size_t(detail::Column<Tags, T, D>::components)));

  std::size_t size() const { return size_; }

  void resize(std::size_t n) {
    for_each_column([&](auto& column) { column.resize(n); });
    size_ = n;
  }
  void reserve(std::size_t n) {
    for_each_column([&](auto& column) { column.reserve(n); });
  }

  /// Component i of a field for all particles, in storage order.
  template <class Tag>
  auto column(int i = 0) {
    return std::span(std::get<detail::Column<Tag, T, D>>(columns_).data[std::size_t(i)]);
  }
  template <class Tag>
  auto column(int i = 0) const {
    return std::span(std::get<detail::Column<Tag, T, D>>(columns_).data[std::size_t(i)]);
  }

  /// The value of a field of particle p.
  template <class Tag>
  auto get(std::size_t p) const {
    typename Tag::shape::template value<T, D> value{};
    for (int i = 0; i < detail::Column<Tag, T, D>::components; ++i) component<Tag>(value, i) = T(column<Tag>(i)[p]);
    complete<Tag>(value);
    return value;
  }
  template <class Tag, class Value>
  void set(std::size_t p, const Value& value) {
    for (int i = 0; i < detail::Column<Tag, T, D>::components; ++i) column<Tag>(i)[p] = T(component<Tag>(value, i));
  }

  /// Every field of particle p but its Id.
  void set_all(std::size_t p, const Values<T, D, list>& values) {
    const auto put = [&]<class Tag>(Tag) {
      if constexpr (!std::is_same_v<Tag, field::Id>) set<Tag>(p, mote::get<Tag>(values));
    };
    (put(Tags{}), ...);
  }

  /// Fields of the n <= lanes particles from `first` on, in packs; surplus lanes repeat the last particle.
  template <class... Wanted>
  void load(std::size_t first, int n, Values<Pack<T>, D, fields<Wanted...>>& values) const {
    (load_field<Wanted>(first, n, mote::get<Wanted>(values)), ...);
  }
  /// Fields of one particle.
  template <class... Wanted>
  void load(std::size_t p, Values<T, D, fields<Wanted...>>& values) const {
    ((mote::get<Wanted>(values) = get<Wanted>(p)), ...);
  }
  /// Writes the fields in Wanted, which may be fewer than `values` holds.
  template <class... Wanted, class V>
  void store(std::size_t first, int n, const V& values, fields<Wanted...>) {
    (store_field<Wanted>(first, n, mote::get<Wanted>(values)), ...);
  }

  /// Calls f(column) for every component column.
  template <class F>
  void for_each_column(F&& f) {
    const auto visit = [&](auto& column) {
      for (auto& data : column.data) f(data);
    };
    (visit(std::get<detail::Column<Tags, T, D>>(columns_)), ...);
  }
  template <class F>
  void for_each_column(F&& f) const {
    const auto visit = [&](const auto& column) {
      for (const auto& data : column.data) f(data);
    };
    (visit(std::get<detail::Column<Tags, T, D>>(columns_)), ...);
  }

 private:
  template <class Tag, class Value>
  static void complete(Value& value) {
    using N = std::remove_cvref_t<decltype(component<Tag>(value, 0))>;
    if constexpr (std::is_same_v<typename Tag::shape, shape_of::Symmetric>)
      for (int i = detail::Column<Tag, T, D>::components; i < 6; ++i) value.c[i] = N(0);
  }
  template <class Tag, class Value>
  void load_field(std::size_t first, int n, Value& value) const {
    const auto& column = std::get<detail::Column<Tag, T, D>>(columns_);
    for (int c = 0; c < column.components; ++c) {
      const T* data = column.data[std::size_t(c)].data() + first;
      __builtin_prefetch(data + 3 * lanes);  // two dozen columns are more streams than the hardware follows
      if (n == lanes) [[likely]]
        component<Tag>(value, c) = mote::read<Pack<T>>(data);
      else
        component<Tag>(value, c) = Pack<T>([&](int l) { return data[std::min(l, n - 1)]; });
    }
    complete<Tag>(value);
  }
  template <class Tag, class Value>
  void store_field(std::size_t first, int n, const Value& value) {
    auto& column = std::get<detail::Column<Tag, T, D>>(columns_);
    for (int c = 0; c < column.components; ++c) {
      T* data = column.data[std::size_t(c)].data() + first;
      if (n == lanes) [[likely]] {
        mote::write(component<Tag>(value, c), data);
      } else {
        for (int l = 0; l < n; ++l) data[l] = component<Tag>(value, c)[std::size_t(l)];
      }
    }
  }
};

}  // namespace mote
