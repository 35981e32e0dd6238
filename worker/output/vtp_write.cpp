#include "worker/output/vtp_write.h"

#include <bit>
#include <cstdint>
#include <span>
#include <string_view>

#include "worker/output/contact_count.h"

namespace regolab {
namespace {

static_assert(std::endian::native == std::endian::little, "the files say LittleEndian");

template <class T>
constexpr std::string_view vtk_type();
template <>
constexpr std::string_view vtk_type<double>() {
  return "Float64";
}
template <>
constexpr std::string_view vtk_type<std::int32_t>() {
  return "Int32";
}
template <>
constexpr std::string_view vtk_type<std::int64_t>() {
  return "Int64";
}

/// Collects the XML head and the appended block side by side: each array's place in the block stands in its XML tag.
class PolyData {
 public:
  PolyData(std::size_t points, std::size_t vertices, std::size_t lines) {
    xml_ =
        "<?xml version=\"1.0\"?>\n"
        "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<PolyData>\n";
    xml_ += "<Piece NumberOfPoints=\"" + std::to_string(points) + "\" NumberOfVerts=\"" + std::to_string(vertices) +
            "\" NumberOfLines=\"" + std::to_string(lines) + "\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n";
  }

  void open(std::string_view section) { xml_ += "<" + std::string(section) + ">\n"; }
  void close(std::string_view section) { xml_ += "</" + std::string(section) + ">\n"; }

  template <class T>
  void array(std::string_view name, int components, std::span<const T> values) {
    xml_ += "<DataArray type=\"" + std::string(vtk_type<T>()) + "\" Name=\"" + std::string(name) +
            "\" NumberOfComponents=\"" + std::to_string(components) + "\" format=\"appended\" offset=\"" +
            std::to_string(block_.size()) + "\"/>\n";
    const std::uint64_t bytes = values.size_bytes();
    block_.append(reinterpret_cast<const char*>(&bytes), sizeof bytes);
    block_.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
  }

  /// Cells of `size` points each, numbered in the order the points stand in.
  void cells(std::string_view section, std::size_t count, std::size_t size) {
    std::vector<std::int64_t> connectivity(count * size);
    std::vector<std::int64_t> offsets(count);
    for (std::size_t i = 0; i < connectivity.size(); ++i) connectivity[i] = static_cast<std::int64_t>(i);
    for (std::size_t i = 0; i < count; ++i) offsets[i] = static_cast<std::int64_t>((i + 1) * size);
    open(section);
    array<std::int64_t>("connectivity", 1, connectivity);
    array<std::int64_t>("offsets", 1, offsets);
    close(section);
  }

  std::string text() && {
    return std::move(xml_) + "</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_" + block_ +
           "\n</AppendedData>\n</VTKFile>\n";
  }

 private:
  std::string xml_;
  std::string block_;
};

}  // namespace

std::string bed_vtp(const BedView& bed) {
  const std::size_t n = bed.spheres.size();
  std::vector<double> position, radius, velocity;
  std::vector<std::int32_t> cluster;
  for (const SphereView& s : bed.spheres) {
    position.insert(position.end(), {s.x, s.y, s.z});
    velocity.insert(velocity.end(), {s.vx, s.vy, s.vz});
    radius.push_back(s.radius);
    cluster.push_back(s.cluster);
  }
  PolyData file(n, n, 0);
  file.open("PointData Scalars=\"radius\" Vectors=\"velocity\"");
  file.array<double>("radius", 1, radius);
  file.array<std::int32_t>("cluster", 1, cluster);
  file.array<double>("velocity", 3, velocity);
  file.array<std::int32_t>("contacts", 1, contact_count(bed));
  file.close("PointData");
  file.open("Points");
  file.array<double>("position", 3, position);
  file.close("Points");
  file.cells("Verts", n, 1);
  return std::move(file).text();
}

std::string contacts_vtp(const BedView& bed) {
  const std::size_t n = bed.contacts.size();
  std::vector<double> ends, force;
  std::vector<std::int32_t> wall;
  for (const ContactView& contact : bed.contacts) {
    const SphereView& a = bed.spheres.at(static_cast<std::size_t>(contact.sphere_a));
    ends.insert(ends.end(), {a.x, a.y, a.z});
    if (contact.sphere_b >= 0) {
      const SphereView& b = bed.spheres.at(static_cast<std::size_t>(contact.sphere_b));
      ends.insert(ends.end(), {b.x, b.y, b.z});
    } else {
      ends.insert(ends.end(), {contact.x, contact.y, contact.z});
    }
    force.push_back(contact.normal_force);
    wall.push_back(contact.sphere_b >= 0 ? -1 : -1 - contact.sphere_b);
  }
  PolyData file(2 * n, 0, n);
  file.open("CellData Scalars=\"normal_force\"");
  file.array<double>("normal_force", 1, force);
  file.array<std::int32_t>("wall", 1, wall);
  file.close("CellData");
  file.open("Points");
  file.array<double>("position", 3, ends);
  file.close("Points");
  file.cells("Lines", n, 2);
  return std::move(file).text();
}

}  // namespace regolab
