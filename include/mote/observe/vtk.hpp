/// \file
/// VTK XML files from plain arrays: .vtp (points), .vti (a regular lattice), .pvd (frames and their times).
///
/// Knows nothing of the solver. All data are inline base64, never appended: Debian's ParaView 5.11 rejects appended
/// data. Vectors have three components; the caller pads those of one and two dimensions.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <mote/core/error.hpp>
#include <mote/observe/file.hpp>
#include <numeric>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace mote::observe {

/// Coordinates x y z x y z ..., borrowed from the caller.
using Coordinates = std::variant<std::span<const float>, std::span<const double>>;

/// A named column, `components` numbers per point or cell one after the other. The data are borrowed.
///
///     const std::vector<Array> arrays{{"velocity", 3, velocity}, {"id", 1, id}};
struct Array {
  std::string name;
  int components;
  std::variant<std::span<const float>, std::span<const double>, std::span<const std::uint32_t>,
               std::span<const std::int64_t>>
      data;
};

/// The points of a .vti: node (i, j, k) lies at origin + (i, j, k) * spacing, for i from extent[0] to extent[1]
/// inclusive, j from extent[2] to extent[3], k from extent[4] to extent[5]; i runs fastest. A missing axis has extent
/// 0 to 0. Cells lie between the nodes.
struct Lattice {
  std::array<double, 3> origin;   ///< of node (0, 0, 0), which the extent need not contain, m
  std::array<double, 3> spacing;  ///< m, > 0
  std::array<int, 6> extent;

  std::size_t nodes() const { return along(0, 1) * along(1, 1) * along(2, 1); }
  /// One across a missing axis.
  std::size_t cells() const { return along(0, 0) * along(1, 0) * along(2, 0); }

 private:
  std::size_t along(std::size_t axis, int more) const {
    const auto intervals = std::int64_t{extent[2 * axis + 1]} - extent[2 * axis];
    return intervals < 0 ? 0 : std::size_t(more == 0 && intervals == 0 ? 1 : intervals + more);
  }
};

namespace detail {

/// VTK's word for a number type: Float32, UInt32, Int64.
template <class T>
std::string vtk_type() {
  return text(std::is_floating_point_v<T> ? "Float" : (std::is_signed_v<T> ? "Int" : "UInt"), 8 * sizeof(T));
}

/// The two base64 characters of each 12-bit number.
inline constexpr auto base64_pairs = [] {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::array<char, 8192> pairs{};
  for (std::size_t i = 0; i < 4096; ++i) {
    pairs[2 * i] = digits[i >> 6];
    pairs[2 * i + 1] = digits[i & 63];
  }
  return pairs;
}();

/// Encodes bytes, in any number of pieces, as one base64 text.
class Base64 {
 public:
  explicit Base64(OutputFile& out) : out_(out), text_(std::size_t{1} << 16) {}

  void write(const void* data, std::size_t size) {
    auto from = static_cast<const unsigned char*>(data);
    for (; carried_ % 3 != 0 && size > 0; --size) carry_[carried_++] = *from++;
    if (carried_ == 3) {
      encode(carry_.data(), 1);
      carried_ = 0;
    }
    for (std::size_t triples = 0; size >= 3; from += 3 * triples, size -= 3 * triples) {
      triples = std::min(size / 3, text_.size() / 4);
      encode(from, triples);
    }
    for (; size > 0; --size) carry_[carried_++] = *from++;
  }

  /// Pads the last characters and hands everything to the file.
  void finish() {
    if (carried_ > 0) {
      for (std::size_t i = carried_; i < 3; ++i) carry_[i] = 0;
      encode(carry_.data(), 1);
      for (std::size_t i = carried_; i < 3; ++i) text_[used_ - 3 + i] = '=';
    }
    flush();
  }

 private:
  void encode(const unsigned char* from, std::size_t triples) {
    if (used_ + 4 * triples > text_.size()) flush();
    char* to = text_.data() + used_;
    for (std::size_t i = 0; i < triples; ++i, from += 3, to += 4) {
      const unsigned bits = unsigned{from[0]} << 16 | unsigned{from[1]} << 8 | from[2];
      std::memcpy(to, &base64_pairs[2 * (bits >> 12)], 2);
      std::memcpy(to + 2, &base64_pairs[2 * (bits & 4095)], 2);
    }
    used_ += 4 * triples;
  }
  void flush() {
    out_.write({text_.data(), used_});
    used_ = 0;
  }

  OutputFile& out_;
  std::vector<char> text_;
  std::size_t used_ = 0;
  std::array<unsigned char, 3> carry_{};
  std::size_t carried_ = 0;
};

/// Text as an XML attribute.
inline std::string quoted(std::string_view plain) {
  std::string out = "\"";
  for (const char c : plain) {
    const bool special = std::string_view("&<>\"").find(c) != std::string_view::npos;
    out += special ? text("&#", int{c}, ';') : std::string(1, c);
  }
  return out += '"';
}

/// Numbers separated by blanks, as an XML attribute.
template <class Number, std::size_t N>
std::string quoted(const std::array<Number, N>& numbers) {
  std::string out = "\"";
  for (std::size_t i = 0; i < N; ++i) {
    if (i > 0) out += ' ';
    append_number(out, numbers[i]);
  }
  return out += '"';
}

/// A DataArray of `count` numbers T; write(base64) supplies them.
template <class T, class Write>
void data_array(OutputFile& out, std::string_view name, int components, std::size_t count, Write&& write) {
  out.write(text("<DataArray type=\"", vtk_type<T>(), "\" Name=", quoted(name), " NumberOfComponents=\"", components,
                 "\" format=\"binary\">\n"));
  Base64 base64{out};
  const std::uint64_t bytes = count * sizeof(T);
  base64.write(&bytes, sizeof(bytes));
  write(base64);
  base64.finish();
  out.write("\n</DataArray>\n");
}

template <class T>
void data_array(OutputFile& out, std::string_view name, int components, std::span<const T> data) {
  data_array<T>(out, name, components, data.size(),
                [&](Base64& base64) { base64.write(data.data(), data.size_bytes()); });
}

/// The numbers first, first + 1, ... as a DataArray.
inline void counting_array(OutputFile& out, std::string_view name, std::int32_t first, std::size_t count) {
  data_array<std::int32_t>(out, name, 1, count, [&](Base64& base64) {
    std::array<std::int32_t, 4096> block;
    for (std::size_t done = 0; done < count; done += block.size()) {
      std::iota(block.begin(), block.end(), static_cast<std::int32_t>(done) + first);
      base64.write(block.data(), std::min(block.size(), count - done) * sizeof(std::int32_t));
    }
  });
}

/// Throws InputError unless every array has its own name and `count` tuples.
inline void check_arrays(const std::vector<Array>& arrays, std::size_t count, std::string_view per) {
  for (std::size_t i = 0; i < arrays.size(); ++i) {
    const auto& array = arrays[i];
    const std::size_t size = std::visit([](auto data) { return data.size(); }, array.data);
    require(array.components > 0 && size == count * std::size_t(array.components), "the array '", array.name, "' has ",
            size, " numbers; ", count, " ", per, " with ", array.components, " components need another count");
    for (std::size_t j = 0; j < i; ++j)
      require(arrays[j].name != array.name, "two arrays are called '", array.name, "'");
  }
}

inline void write_arrays(OutputFile& out, std::string_view element, const std::vector<Array>& arrays) {
  out.write(text("<", element, ">\n"));
  for (const auto& array : arrays)
    std::visit([&](auto data) { data_array(out, array.name, array.components, data); }, array.data);
  out.write(text("</", element, ">\n"));
}

inline std::string vtk_head(std::string_view type) {
  return text("<?xml version=\"1.0\"?>\n<VTKFile type=\"", type, "\" version=\"1.0\" byte_order=\"",
              std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian",
              "\" header_type=\"UInt64\">\n");
}

inline void check_finite(double value, std::string_view what, const std::filesystem::path& file) {
  require(std::isfinite(value), "the ", what, " of ", file.string(), " is ", value);
}

inline void write_time(OutputFile& out, double time) {
  out.write("<FieldData>\n<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">");
  std::string digits;
  append_number(digits, time);
  out.write(digits + "</DataArray>\n</FieldData>\n");
}

}  // namespace detail

/// Writes points, each with a vertex cell so that viewers show it, and their arrays as PolyData (.vtp).
///
/// `time` (s) becomes the field TimeValue. Throws InputError if the counts do not agree, OutputError.
inline void write_vtp(const std::filesystem::path& file, const Coordinates& points, const std::vector<Array>& arrays,
                      double time) {
  const std::size_t numbers = std::visit([](auto data) { return data.size(); }, points);
  const std::size_t count = numbers / 3;
  require(numbers == 3 * count, "points have three coordinates each, but there are ", numbers, " numbers");
  require(count < 0x7fff0000u, count, " points are too many for one .vtp file; the most is ", 0x7fff0000u - 1);
  detail::check_finite(time, "time", file);
  detail::check_arrays(arrays, count, "points");

  OutputFile out{file};
  out.write(detail::vtk_head("PolyData") + "<PolyData>\n");
  detail::write_time(out, time);
  out.write(text("<Piece NumberOfPoints=\"", count, "\" NumberOfVerts=\"", count,
                 "\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n"));
  detail::write_arrays(out, "PointData", arrays);
  out.write("<Points>\n");
  std::visit([&](auto data) { detail::data_array(out, "Points", 3, data); }, points);
  out.write("</Points>\n<Verts>\n");
  detail::counting_array(out, "connectivity", 0, count);
  detail::counting_array(out, "offsets", 1, count);
  out.write("</Verts>\n</Piece>\n</PolyData>\n</VTKFile>\n");
  out.close();
}

/// Writes node and cell arrays of a regular lattice as ImageData (.vti).
///
/// `time` (s) becomes the field TimeValue. Throws InputError if the counts do not agree, OutputError.
inline void write_vti(const std::filesystem::path& file, const Lattice& lattice, const std::vector<Array>& node_arrays,
                      const std::vector<Array>& cell_arrays, double time) {
  require(lattice.nodes() > 0, "the extent of ", file.string(), " is empty");
  for (const double h : lattice.spacing) require(std::isfinite(h) && h > 0, "the spacing is ", h, "; it must be > 0");
  for (const double x : lattice.origin) detail::check_finite(x, "origin", file);
  detail::check_finite(time, "time", file);
  detail::check_arrays(node_arrays, lattice.nodes(), "nodes");
  detail::check_arrays(cell_arrays, lattice.cells(), "cells");

  OutputFile out{file};
  const std::string extent = detail::quoted(lattice.extent);
  out.write(text(detail::vtk_head("ImageData"), "<ImageData WholeExtent=", extent,
                 " Origin=", detail::quoted(lattice.origin), " Spacing=", detail::quoted(lattice.spacing), ">\n"));
  detail::write_time(out, time);
  out.write(text("<Piece Extent=", extent, ">\n"));
  detail::write_arrays(out, "PointData", node_arrays);
  detail::write_arrays(out, "CellData", cell_arrays);
  out.write("</Piece>\n</ImageData>\n</VTKFile>\n");
  out.close();
}

/// A .pvd: the list of frames with their physical times, which ParaView opens as one animation.
///
/// The file is complete after each add().
class Collection {
 public:
  explicit Collection(std::filesystem::path file) : file_(std::move(file)) {}

  /// Lists a frame, given by its path as seen from here, and writes the .pvd with the path relative to it. `time` in s.
  void add(const std::filesystem::path& frame, double time) {
    detail::check_finite(time, "time", frame);
    const auto home = std::filesystem::absolute(file_).lexically_normal().parent_path();
    const auto path = std::filesystem::absolute(frame).lexically_normal().lexically_proximate(home);
    entries_ += text("<DataSet timestep=", detail::quoted(std::array{time}),
                     " part=\"0\" file=", detail::quoted(path.generic_string()), "/>\n");
    OutputFile out{file_};
    out.write(text(detail::vtk_head("Collection"), "<Collection>\n", entries_, "</Collection>\n</VTKFile>\n"));
    out.close();
  }

 private:
  std::filesystem::path file_;
  std::string entries_;
};

}  // namespace mote::observe
