// Copyright (c) 2026  The Spherical_parameterization authors.
// All rights reserved.
//
// This file is part of the Spherical_parameterization package for CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spherical_parameterization authors

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_GIFTI_H
#define CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_GIFTI_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Cortex/Surface_file.h>
#include <CGAL/Spherical_parameterization/Error_code.h>
#include <CGAL/Spherical_parameterization/Cortex/internal/Gifti_data.h>
#include <CGAL/Spherical_parameterization/Cortex/internal/Gifti_parser.h>
#include <CGAL/Spherical_parameterization/Cortex/internal/Zlib.h>
#include <CGAL/Spherical_parameterization/Cortex/internal/surface_file_checks.h>
#include <CGAL/Spherical_parameterization/internal/files/File_bytes.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <istream>
#include <limits>
#include <locale>
#include <ostream>
#include <sstream>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization {
namespace internal {

// Returns the number of bytes of the XML character in UTF-8 that begins here, or 0 if the bytes are not one.
inline std::size_t length_of_character(std::string_view text)
{
  const auto byte = [&](std::size_t k) { return k < text.size() ? static_cast<unsigned char>(text[k]) : 0u; };
  const unsigned int first = byte(0);
  if(first < 0x80)
    return first >= ' ' || first == '\t' || first == '\n' || first == '\r' ? 1 : 0;
  const std::size_t n = first >= 0xC2 && first < 0xE0   ? 2
                        : first >= 0xE0 && first < 0xF0 ? 3
                        : first >= 0xF0 && first < 0xF5 ? 4
                                                        : 0;
  std::uint32_t code = n == 0 ? 0 : first & (0x7Fu >> n);
  for(std::size_t k = 1; k < n; ++k)
  {
    if((byte(k) & 0xC0u) != 0x80u)
      return 0;
    code = code << 6 | (byte(k) & 0x3Fu);
  }
  const bool is_short = (n == 3 && code < 0x800) || (n == 4 && (code < 0x10000 || code > 0x10FFFF));
  const bool is_no_character = (code >= 0xD800 && code < 0xE000) || code == 0xFFFE || code == 0xFFFF;
  return is_short || is_no_character ? 0 : n;
}

// Returns a text as an XML CDATA section. Bytes that XML does not allow become question marks.
inline std::string xml_text(std::string_view text)
{
  std::string result = "<![CDATA[";
  while(!text.empty())
  {
    const std::size_t n = length_of_character(text);
    const bool is_end = text.compare(0, 3, "]]>") == 0; // not allowed within one section
    result += is_end ? "]]]]><![CDATA[>" : n > 0 ? text.substr(0, n) : "?";
    text.remove_prefix(is_end ? 3 : n > 0 ? n : 1);
  }
  return result + "]]>";
}

// Writes a GIFTI file to a text.
class Gifti_writer
{
public:
  Gifti_writer()
  {
    m_text.imbue(std::locale::classic());
    m_text.precision(std::numeric_limits<double>::max_digits10);
  }

  std::string operator()(const IO::Surface_file& file)
  {
    const std::size_t n_arrays = file.columns.size() + (file.points.empty() ? 0 : 1) +
                                 (file.triangles.empty() ? 0 : 1) + (file.vertices.empty() ? 0 : 1);
    m_text << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
              "<!DOCTYPE GIFTI SYSTEM \"http://www.nitrc.org/frs/download.php/115/gifti.dtd\">\n"
              "<GIFTI Version=\"1.0\" NumberOfDataArrays=\""
           << n_arrays << "\">\n";
    write_metadata(file.origin.metadata);
    write_labels(file.labels);
    if(!file.points.empty())
      write_array<float>("NIFTI_INTENT_POINTSET", file.origin.metadata_of_points, file.points,
                         file.origin.coordinate_systems);
    if(!file.triangles.empty())
      write_array<std::int32_t>("NIFTI_INTENT_TRIANGLE", file.origin.metadata_of_triangles, file.triangles);
    if(!file.vertices.empty())
      write_array<std::int32_t>("NIFTI_INTENT_NODE_INDEX", {}, file.vertices);
    for(const IO::Vertex_values& column : file.columns)
      write_column(column);
    m_text << "</GIFTI>\n";
    return m_text.str();
  }

private:
  void write_metadata(const IO::Metadata& metadata)
  {
    m_text << "<MetaData>\n";
    for(const auto& [name, value] : metadata)
      m_text << "<MD><Name>" << xml_text(name) << "</Name><Value>" << xml_text(value) << "</Value></MD>\n";
    m_text << "</MetaData>\n";
  }

  void write_labels(const std::vector<IO::Label>& labels)
  {
    const std::string unnamed = "???"; // as Connectome Workbench writes; some programs reject an empty name
    m_text << "<LabelTable>\n";
    for(const IO::Label& label : labels)
      m_text << "<Label Key=\"" << label.key << "\" Red=\"" << label.color[0] << "\" Green=\"" << label.color[1]
             << "\" Blue=\"" << label.color[2] << "\" Alpha=\"" << label.color[3] << "\">"
             << xml_text(label.name.empty() ? unnamed : label.name) << "</Label>\n";
    m_text << "</LabelTable>\n";
  }

  void write_column(const IO::Vertex_values& column)
  {
    IO::Metadata metadata = column.metadata;
    if(!column.name.empty())
      metadata.insert(metadata.begin(), {"Name", column.name});
    constexpr const char* characters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_";
    const bool is_intent = !column.intent.empty() && column.intent.find_first_not_of(characters) == std::string::npos;
    const std::string intent = is_intent ? column.intent : "NIFTI_INTENT_NONE";
    if(column.type == IO::Vertex_values::Type::uint8)
      write_array<std::uint8_t>(intent, metadata, column.values);
    else if(column.type == IO::Vertex_values::Type::int32)
      write_array<std::int32_t>(intent, metadata, column.values);
    else
      write_array<float>(intent, metadata, column.values);
  }

  template <class Number, class Item>
  void write_array(const std::string& intent, const IO::Metadata& metadata, const std::vector<Item>& items,
                   const std::vector<IO::Coordinate_system>& systems = {})
  {
    constexpr bool has_columns = !std::is_arithmetic_v<Item>;
    m_text
        << "<DataArray Intent=\"" << intent << "\" DataType=\"NIFTI_TYPE_"
        << (std::is_same_v<Number, float>          ? "FLOAT32"
            : std::is_same_v<Number, std::int32_t> ? "INT32"
                                                   : "UINT8")
        << "\" ArrayIndexingOrder=\"RowMajorOrder\" Dimensionality=\"" << (has_columns ? 2 : 1) << "\" Dim0=\""
        << items.size() << (has_columns ? "\" Dim1=\"3" : "")
        << "\" Encoding=\"GZipBase64Binary\" Endian=\"LittleEndian\" ExternalFileName=\"\" ExternalFileOffset=\"\">\n";
    write_metadata(metadata);
    for(const IO::Coordinate_system& system : systems)
      write_system(system);
    Byte_writer bytes(false);
    for(const Item& item : items)
      if constexpr(has_columns)
        for(const auto x : item)
          bytes.write(static_cast<Number>(x));
      else
        bytes.write(static_cast<Number>(item));
    m_text << "<Data>" << to_base64(pack(bytes.content, false)) << "</Data>\n</DataArray>\n";
  }

  void write_system(const IO::Coordinate_system& system)
  {
    m_text << "<CoordinateSystemTransformMatrix>\n<DataSpace>" << xml_text(system.data_space)
           << "</DataSpace>\n<TransformedSpace>" << xml_text(system.transformed_space)
           << "</TransformedSpace>\n<MatrixData>";
    for(std::size_t k = 0; k < system.matrix.size(); ++k)
      m_text << system.matrix[k] << (k % 4 == 3 ? '\n' : ' ');
    m_text << "</MatrixData>\n</CoordinateSystemTransformMatrix>\n";
  }

  std::ostringstream m_text;
};

} // namespace internal

namespace IO {

/// \ingroup PkgSphericalParameterizationFiles
///
/// reads a GIFTI file \cgalCite{cgal:gifti-11} with a surface (`.surf.gii`), values at vertices (`.shape.gii`,
/// `.func.gii`), labels (`.label.gii`), or all of them.
///
/// - All encodings are supported except external files, as are both byte orders and all number types that doubles can
///   represent. The file may be compressed by gzip (`.gii.gz`).
/// - Metadata and coordinate systems are kept; points are not transformed.
/// - An array with several columns becomes as many columns, numbered from 1.
/// - Values with node indices are sorted by index, and `vertices` receives the indices, even if they include all
///   vertices.
/// - Numbers with the label intent must be integers, but may be of any type.
/// - Coordinates and values that are not finite are kept.
///
/// Memory is bounded by the size of the file: compressed data may unpack to at most 32 MB of doubles or 250 times the
/// size of the file, whichever is larger.
///
/// This header requires expat and zlib. It is not included by `CGAL/spherical_parameterization.h`.
///
/// \param in the file, in binary mode
/// \param file receives the contents
/// \param message receives one line. On an error, it states the error, its location and a remedy. With `OK`, it reports
///         a header that declares a different number of arrays; otherwise it is empty.
///
/// \return `OK`, or `ERROR_INVALID_SURFACE_FILE` if the file is damaged or has another format; `file` is then unchanged
inline Error_code read_GIFTI(std::istream& in, Surface_file& file, std::string& message)
{
  return internal::read_or_report(in, file, message, [](std::string content, Surface_file& result, std::string& text) {
    const std::size_t file_size = content.size();
    if(internal::is_packed_by_gzip(content))
    {
      content = internal::unpack(content, internal::max_unpacked_size(file_size), true);
      internal::check_unpacked_size(content.size(), file_size);
    }
    internal::Gifti_parser(file_size).read(content, result, text);
  });
}

/// \ingroup PkgSphericalParameterizationFiles
///
/// writes a GIFTI file \cgalCite{cgal:gifti-11} with points, rounded to single precision, triangles, columns, labels,
/// metadata and coordinate systems. The first line and the footer of FreeSurfer are not written. The data are
/// compressed and encoded in base 64.
///
/// \param out the file, in binary mode
/// \param file the contents; the metadata state, for example, the anatomical structure of a surface
/// \param message receives one line that states the error; empty with `OK`
/// \param is_packed whether the whole file is compressed by gzip, as a file with the extension `.gii.gz` must be
///
/// \return `OK`; `ERROR_WRONG_PARAMETER` if a number does not have the type of its column, two labels have the same
///         key, a color is not finite, or `vertices` contains a vertex twice; `ERROR_OUT_OF_FLOAT_RANGE` if a finite
///         number is outside the range of single precision; or `ERROR_CANNOT_WRITE_FILE`
inline Error_code write_GIFTI(std::ostream& out, const Surface_file& file, std::string& message, bool is_packed = false)
{
  message.clear();
  if(const Error_code error = internal::check_labels_and_vertices(file, message); error != OK)
    return error;
  if(const Error_code error = internal::check_columns(file.columns, false, message); error != OK)
    return error;
  if(const Error_code error = internal::check_points(file.points, message); error != OK)
    return error;
  const std::string text = internal::Gifti_writer()(file);
  return internal::write_bytes(out, is_packed ? internal::pack(text, true) : text, message);
}

} // namespace IO
} // namespace CGAL::Spherical_parameterization

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_GIFTI_H
