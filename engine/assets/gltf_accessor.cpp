#include "engine/assets/gltf_accessor.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <span>
#include <string>
#include <type_traits>

#include "engine/files/plain_text.h"

namespace fulcrum {
namespace {

template <class T>
const T& at(const std::vector<T>& list, int index, const char* what) {
  if (index < 0 || static_cast<std::size_t>(index) >= list.size()) {
    throw GltfFault(std::string("it refers to a ") + what + " (number " + std::to_string(index) +
                    ") that it does not hold; export it again");
  }
  return list[static_cast<std::size_t>(index)];
}

// The bytes of an accessor: element i begins at first + i * stride, and all of it lies within the buffer.
struct Elements {
  const unsigned char* first = nullptr;
  std::size_t stride = 0;
  std::size_t count = 0;
};

std::span<const unsigned char> bytes_of(const tinygltf::Model& file, int index) {
  const tinygltf::BufferView& view = at(file.bufferViews, index, "buffer view");
  const tinygltf::Buffer& buffer = at(file.buffers, view.buffer, "buffer");
  if (view.byteOffset > buffer.data.size() || view.byteLength > buffer.data.size() - view.byteOffset) {
    throw GltfFault(
        "a buffer view reaches beyond its buffer; the file is truncated or damaged, export it again");
  }
  return std::span(buffer.data).subspan(view.byteOffset, view.byteLength);
}

Elements locate(const tinygltf::Model& file, const tinygltf::Accessor& accessor, std::size_t element_bytes) {
  if (accessor.sparse.isSparse)
    throw GltfFault("it uses sparse accessors, which are not supported; export it without them");
  const std::span<const unsigned char> bytes = bytes_of(file, accessor.bufferView);
  const tinygltf::BufferView& view = at(file.bufferViews, accessor.bufferView, "buffer view");
  const std::size_t stride = view.byteStride == 0 ? element_bytes : view.byteStride;
  const bool fits = accessor.count > 0 && stride >= element_bytes && accessor.byteOffset <= view.byteLength &&
                    view.byteLength - accessor.byteOffset >= element_bytes &&
                    (view.byteLength - accessor.byteOffset - element_bytes) / stride >= accessor.count - 1;
  if (!fits) {
    throw GltfFault(
        "an accessor is empty or reaches beyond its buffer view; the file is truncated or damaged, "
        "export it again");
  }
  return {bytes.data() + accessor.byteOffset, stride, accessor.count};
}

template <class T>
std::vector<std::uint32_t> read_scalars(const Elements& elements) {
  std::vector<std::uint32_t> result;
  result.reserve(elements.count);
  for (std::size_t i = 0; i < elements.count; ++i) {
    T value;
    std::memcpy(&value, elements.first + i * elements.stride, sizeof(T));
    result.push_back(value);
  }
  return result;
}

// Whole numbers stand for fractions of their largest (glTF 2.0, 3.6.2.2).
template <class T>
constexpr double kOne = std::is_floating_point_v<T> ? 1.0
                                                    : static_cast<double>(std::numeric_limits<T>::max());

template <class T>
std::vector<std::array<float, 2>> read_pairs(const Elements& elements) {
  std::vector<std::array<float, 2>> result;
  result.reserve(elements.count);
  for (std::size_t i = 0; i < elements.count; ++i) {
    T uv[2];
    std::memcpy(uv, elements.first + i * elements.stride, sizeof(uv));
    const auto finite = [](double x) { return std::isfinite(x) ? static_cast<float>(x) : 0.0F; };
    result.push_back(
        {finite(static_cast<double>(uv[0]) / kOne<T>), finite(static_cast<double>(uv[1]) / kOne<T>)});
  }
  return result;
}

// What follows red, green, blue is left.
template <class T>
std::vector<Vec3> read_fractions(const Elements& elements) {
  std::vector<Vec3> result;
  result.reserve(elements.count);
  for (std::size_t i = 0; i < elements.count; ++i) {
    T rgb[3];
    std::memcpy(rgb, elements.first + i * elements.stride, sizeof(rgb));
    Vec3& colour = result.emplace_back();
    for (int k = 0; k < 3; ++k) {
      const double fraction = static_cast<double>(rgb[k]) / kOne<T>;
      colour[k] = std::isfinite(fraction) ? std::clamp(fraction, 0.0, 1.0) : 1.0;
    }
  }
  return result;
}

}  // namespace

std::string name_in_quotes(const std::string& name) {
  constexpr std::size_t kLongest = 80;  // bytes, so that a sentence can be read
  return "'" + short_text(name, kLongest) + "'";
}

std::vector<std::uint8_t> read_bytes(const tinygltf::Model& file, int view) {
  const std::span<const unsigned char> bytes = bytes_of(file, view);
  return {bytes.begin(), bytes.end()};
}

std::vector<Vec3> read_vectors(const tinygltf::Model& file, int index) {
  const tinygltf::Accessor& accessor = at(file.accessors, index, "accessor");
  if (accessor.type != TINYGLTF_TYPE_VEC3 || accessor.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT) {
    throw GltfFault(
        "its positions or normals are quantised or not three-dimensional, which is not supported; export "
        "it with 32-bit floats and without compression");
  }
  const Elements elements = locate(file, accessor, 3 * sizeof(float));
  std::vector<Vec3> result;
  result.reserve(elements.count);
  for (std::size_t i = 0; i < elements.count; ++i) {
    float xyz[3];
    std::memcpy(xyz, elements.first + i * elements.stride, sizeof(xyz));
    result.emplace_back(xyz[0], xyz[1], xyz[2]);
    if (!result.back().allFinite()) {
      throw GltfFault("vertex " + std::to_string(i) +
                      " of a mesh is not a finite number; repair the mesh and export "
                      "it again");
    }
  }
  return result;
}

std::vector<Vec3> read_colours(const tinygltf::Model& file, int index) {
  const tinygltf::Accessor& accessor = at(file.accessors, index, "accessor");
  const std::size_t numbers = accessor.type == TINYGLTF_TYPE_VEC4 ? 4 : 3;
  if (numbers == 4 || accessor.type == TINYGLTF_TYPE_VEC3) {
    switch (accessor.componentType) {
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return read_fractions<std::uint8_t>(locate(file, accessor, numbers));
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return read_fractions<std::uint16_t>(locate(file, accessor, 2 * numbers));
      case TINYGLTF_COMPONENT_TYPE_FLOAT:
        return read_fractions<float>(locate(file, accessor, 4 * numbers));
      default:
        break;
    }
  }
  throw GltfFault("the colours of a mesh are neither RGB nor RGBA; the file is damaged, export it again");
}

std::vector<std::array<float, 2>> read_coordinates(const tinygltf::Model& file, int index) {
  const tinygltf::Accessor& accessor = at(file.accessors, index, "accessor");
  if (accessor.type == TINYGLTF_TYPE_VEC2) {
    switch (accessor.componentType) {
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return read_pairs<std::uint8_t>(locate(file, accessor, 2));
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return read_pairs<std::uint16_t>(locate(file, accessor, 4));
      case TINYGLTF_COMPONENT_TYPE_FLOAT:
        return read_pairs<float>(locate(file, accessor, 8));
      default:
        break;
    }
  }
  throw GltfFault("the texture coordinates of a mesh are no pairs; the file is damaged, export it again");
}

std::vector<std::uint32_t> read_indices(const tinygltf::Model& file, int index) {
  const tinygltf::Accessor& accessor = at(file.accessors, index, "accessor");
  if (accessor.type == TINYGLTF_TYPE_SCALAR) {
    switch (accessor.componentType) {
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return read_scalars<std::uint8_t>(locate(file, accessor, 1));
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return read_scalars<std::uint16_t>(locate(file, accessor, 2));
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        return read_scalars<std::uint32_t>(locate(file, accessor, 4));
      default:
        break;
    }
  }
  throw GltfFault("the indices of a mesh are not unsigned integers; the file is damaged, export it again");
}

}  // namespace fulcrum
