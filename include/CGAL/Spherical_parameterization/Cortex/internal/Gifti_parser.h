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

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_INTERNAL_GIFTI_PARSER_H
#define CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_INTERNAL_GIFTI_PARSER_H

#include <CGAL/license/Spherical_parameterization.h>

#include <CGAL/Spherical_parameterization/Cortex/Surface_file.h>
#include <CGAL/Spherical_parameterization/Cortex/internal/Gifti_data.h>
#include <CGAL/Spherical_parameterization/Cortex/internal/Gifti_elements.h>
#include <CGAL/Spherical_parameterization/Cortex/internal/surface_file_checks.h>
#include <CGAL/Spherical_parameterization/internal/files/File_bytes.h>

#include <expat.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <memory>
#include <new>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <CGAL/Spherical_parameterization/internal/numbers/begin_arithmetic.h>

namespace CGAL::Spherical_parameterization::internal {

// Parser for GIFTI files. Expat calls back for each element; exceptions are kept until expat has returned.
class Gifti_parser
{
public:
  // `file_size` is the size of the file before unpacking, which bounds the memory.
  explicit Gifti_parser(std::size_t file_size)
    : m_file_size(file_size)
  {}

  void read(std::string_view content, IO::Surface_file& file, std::string& message)
  {
    const std::unique_ptr<XML_ParserStruct, void (*)(XML_Parser)> parser(XML_ParserCreate(nullptr), XML_ParserFree);
    if(!parser)
      throw std::bad_alloc();
    m_parser = parser.get();
    m_file = &file;
    XML_SetUserData(m_parser, this);
    XML_SetElementHandler(m_parser, start, end);
    XML_SetCharacterDataHandler(m_parser, add_text);
    XML_SetStartDoctypeDeclHandler(m_parser, refuse_declarations);
    XML_SetSkippedEntityHandler(m_parser, refuse_entity);
    XML_Status status = XML_STATUS_OK;
    do
    {
      constexpr std::size_t max_block = std::size_t(1) << 30; // expat counts bytes by int
      const std::string_view block = content.substr(0, max_block);
      content.remove_prefix(block.size());
      status = XML_Parse(m_parser, block.data(), static_cast<int>(block.size()), content.empty());
    } while(status == XML_STATUS_OK && !content.empty());
    if(m_exception)
      std::rethrow_exception(m_exception);
    if(status != XML_STATUS_OK)
      throw File_error("Line ", XML_GetCurrentLineNumber(m_parser), ", column ", XML_GetCurrentColumnNumber(m_parser),
                       ": this is no XML that can be read: ", XML_ErrorString(XML_GetErrorCode(m_parser)),
                       ". The file is truncated or damaged.");
    if(!m_is_gifti)
      throw File_error("This is an XML file, but no GIFTI file.");
    check_arrays(file);
    sort_by_vertices(file);
    if(m_n_arrays != m_n_declared)
      message = File_error::join("The header announces ", m_n_declared, " arrays, but there are ", m_n_arrays, ".\n");
  }

private:
  // calls f(), from within expat
  template <class F>
  static void guard(void* data, const F& f)
  {
    Gifti_parser& self = *static_cast<Gifti_parser*>(data);
    if(self.m_exception)
      return;
    try
    {
      f(self);
    }
    catch(...)
    {
      self.m_exception = std::current_exception();
      XML_StopParser(self.m_parser, XML_FALSE);
    }
  }

  static void XMLCALL start(void* data, const XML_Char* name, const XML_Char** attributes)
  {
    guard(data, [&](Gifti_parser& self) { self.start_element(name, attributes); });
  }
  static void XMLCALL end(void* data, const XML_Char* name)
  {
    guard(data, [&](Gifti_parser& self) { self.end_element(name); });
  }
  static void XMLCALL add_text(void* data, const XML_Char* text, int size)
  {
    guard(data, [&](Gifti_parser& self) {
      if(self.m_has_text)
        self.m_text.append(text, static_cast<std::size_t>(size));
    });
  }
  // The DTD is external and never loaded. Internal declarations could only expand a short file to a long text.
  static void XMLCALL refuse_declarations(void* data, const XML_Char*, const XML_Char*, const XML_Char*,
                                          int has_declarations)
  {
    guard(data, [&](Gifti_parser& self) {
      if(has_declarations != 0)
        throw File_error("Line ", XML_GetCurrentLineNumber(self.m_parser),
                         ": the document type has declarations of its own, which no GIFTI file needs: remove them.");
    });
  }

  // Since the DTD is not loaded, expat skips undeclared entities, and numbers would lose digits.
  static void XMLCALL refuse_entity(void* data, const XML_Char* name, int)
  {
    guard(data, [&](Gifti_parser& self) { self.fail_for_entity(name); });
  }

  [[noreturn]] void fail_for_entity(const std::string& name) const
  {
    fail("the entity ", in_quotes(name), " is not declared: the file is damaged.");
  }

  template <class... What>
  [[noreturn]] void fail(const What&... what) const // names the array or the line
  {
    if(m_array)
      throw File_error("Array ", m_n_arrays, " (", in_quotes(m_array->intent), ", line ", m_array->line,
                       "): ", what...);
    throw File_error("Line ", XML_GetCurrentLineNumber(m_parser), ": ", what...);
  }

  template <class Read>
  auto or_fail(const Read& read) const // calls read(), and adds the location to its errors
  {
    try
    {
      return read();
    }
    catch(const File_error& error)
    {
      fail(error.what());
    }
  }

  void add_size(std::size_t n_bytes) // of data that are kept
  {
    m_unpacked_size += n_bytes;
    or_fail([&] { check_unpacked_size(m_unpacked_size, m_file_size); });
  }

  std::uint64_t read_count(const std::string& text, const char* what) const // at most Gifti_array::max_size
  {
    double x = 0.;
    if(!Number_text::is_number(text, x) || !(x >= 0. && x == std::floor(x) && x <= double(Gifti_array::max_size)))
      fail(what, " is ", in_quotes(text), ", which is no number of things: the file is damaged.");
    return static_cast<std::uint64_t>(x);
  }

  void start_element(std::string_view name, const XML_Char** attributes)
  {
    constexpr std::size_t max_depth = 32;
    if(++m_depth > max_depth)
      fail("elements are nested deeper than in any GIFTI file: it is damaged.");
    if(const std::string entity = undeclared_entity(m_parser); !entity.empty())
      fail_for_entity(entity);
    if(m_depth == 1)
    {
      m_is_gifti = name == "GIFTI";
      if(m_is_gifti)
        m_n_declared = read_count(attribute(attributes, "NumberOfDataArrays"), "NumberOfDataArrays");
    }
    m_has_text = name == "Name" || name == "Value" || name == "Label" || name == "DataSpace" ||
                 name == "TransformedSpace" || name == "MatrixData" || name == "Data";
    if(m_has_text)
      m_text.clear();
    if(name == "DataArray")
      start_array(attributes);
    else if(name == "MD")
      m_pair = {};
    else if(name == "CoordinateSystemTransformMatrix")
      m_system = {};
    else if(name == "Label")
      start_label(attributes);
  }

  void start_array(const XML_Char** attributes)
  {
    if(m_array)
      fail("an array is within another one: the file is damaged.");
    m_array.emplace();
    m_array->line = XML_GetCurrentLineNumber(m_parser);
    m_array->intent = attribute(attributes, "Intent");
    m_array->type = attribute(attributes, "DataType");
    m_array->order = attribute(attributes, "ArrayIndexingOrder");
    m_array->encoding = attribute(attributes, "Encoding");
    m_array->endian = attribute(attributes, "Endian");
    constexpr std::uint64_t max_dimensions = 6; // limit of the format
    const std::uint64_t n = read_count(attribute(attributes, "Dimensionality"), "Dimensionality");
    if(n < 1 || n > max_dimensions)
      fail("Dimensionality is ", n, ", not 1 to 6: the file is damaged.");
    std::uint64_t size = 1;
    for(std::uint64_t k = 0; k < n; ++k)
    {
      const std::string dimension = File_error::join("Dim", k);
      const std::uint64_t d = read_count(attribute(attributes, dimension), dimension.c_str());
      if(k > 1 && d != 1)
        fail("it has ", n, " dimensions, which neither surfaces nor values of vertices have.");
      if(d > 0 && size > Gifti_array::max_size / d)
        fail("the dimensions are too large: the file is damaged.");
      size *= d;
      m_array->dimensions.push_back(d);
    }
  }

  void start_label(const XML_Char** attributes)
  {
    add_size(sizeof(IO::Label));
    m_file->labels.push_back(or_fail([&] { return label_of(attributes); }));
    if(!m_keys.insert(m_file->labels.back().key).second)
      fail("two labels have the key ", m_file->labels.back().key, ": the file is damaged.");
  }

  void end_element(std::string_view name)
  {
    --m_depth;
    if(name == "DataArray")
      end_array();
    else if(name == "MD")
    {
      add_size(sizeof m_pair + m_pair.first.size() + m_pair.second.size());
      (m_array ? m_array->metadata : m_file->origin.metadata).push_back(std::move(m_pair));
    }
    else if(name == "CoordinateSystemTransformMatrix" && m_array)
    {
      add_size(sizeof m_system + m_system.data_space.size() + m_system.transformed_space.size());
      m_array->systems.push_back(std::move(m_system));
    }
    if(!m_has_text)
      return;
    m_has_text = false;
    if(name == "Data")
      read_data();
    else if(name == "MatrixData")
      read_matrix();
    else if(std::string* text = name == "Name"               ? &m_pair.first
                                : name == "Value"            ? &m_pair.second
                                : name == "DataSpace"        ? &m_system.data_space
                                : name == "TransformedSpace" ? &m_system.transformed_space
                                : name == "Label"            ? &m_file->labels.back().name
                                                             : nullptr)
      *text = stripped(m_text);
  }

  void read_matrix()
  {
    Number_text numbers(m_text);
    for(double& x : m_system.matrix)
      if(const std::string_view word = numbers.next_word(); !numbers.is_number(word, x))
        fail("the matrix has ", in_quotes(word), " instead of one of its 16 numbers: the file is damaged.");
  }

  void read_data()
  {
    if(!m_array)
      return;
    if(m_array->has_data)
      fail("it has data twice: the file is damaged.");
    m_array->has_data = true;
    m_numbers = or_fail([&] { return Gifti_data(*m_array, m_file_size, m_unpacked_size)(m_text); });
    m_text = {}; // also releases the memory
  }

  void end_array()
  {
    if(!m_array->has_data)
      fail("it has no data: the file is damaged.");
    const std::size_t n = m_array->rows(), n_columns = m_array->columns();
    IO::Surface_origin& origin = m_file->origin;
    if(m_array->intent == "NIFTI_INTENT_POINTSET")
    {
      take_triples(m_file->points, m_has_points, [](double x) { return x; });
      origin.metadata_of_points = std::move(m_array->metadata);
      origin.coordinate_systems = std::move(m_array->systems);
    }
    else if(m_array->intent == "NIFTI_INTENT_TRIANGLE")
    {
      take_triples(m_file->triangles, m_has_triangles, [this](double x) { return index_of(x); });
      origin.metadata_of_triangles = std::move(m_array->metadata);
    }
    else if(m_array->intent == "NIFTI_INTENT_NODE_INDEX")
    {
      if(std::exchange(m_has_indices, true))
        fail("the file has two of them, but values are of one choice of vertices.");
      if(m_numbers.empty())
        fail("it has no index: the file is damaged.");
      for(const double x : m_numbers)
        m_file->vertices.push_back(index_of(x));
    }
    else
    {
      check_number_of_columns(m_file->columns.size() + n_columns);
      for(std::size_t k = 0; k < n_columns; ++k)
        take_column(n, n_columns, k);
    }
    m_numbers = {};
    m_array.reset();
    ++m_n_arrays;
  }

  template <class Item, class Convert>
  void take_triples(std::vector<Item>& items, bool& is_there, const Convert& convert)
  {
    if(std::exchange(is_there, true))
      fail("the file has two of them, but a surface has one.");
    if(m_array->columns() != 3)
      fail("it has ", m_array->columns(), " columns, not 3: the file is damaged.");
    items.resize(m_array->rows());
    for(std::size_t i = 0; i < m_numbers.size(); ++i)
      items[i / 3][i % 3] = convert(m_numbers[i]);
  }

  std::uint32_t index_of(double x) const
  {
    constexpr double max = (std::numeric_limits<std::int32_t>::max)();
    if(!(x >= 0. && x <= max && x == std::floor(x)))
      fail("it has the index ", x, ", but vertices are counted from 0: the file is damaged.");
    return static_cast<std::uint32_t>(x);
  }

  void take_column(std::size_t n, std::size_t n_columns, std::size_t k)
  {
    using Type = IO::Vertex_values::Type;
    IO::Vertex_values column;
    column.intent = m_array->intent;
    column.type = m_array->type.find("FLOAT") != std::string::npos ? Type::float32
                  : m_array->type == "NIFTI_TYPE_UINT8"            ? Type::uint8
                                                                   : Type::int32;
    const bool is_label = column.intent == "NIFTI_INTENT_LABEL";
    if(is_label && column.type == Type::float32)
      column.type = Type::int32; // keys must not be averaged
    add_size(sizeof column + column.intent.size());
    for(const auto& pair : m_array->metadata)
    {
      add_size(sizeof pair + pair.first.size() + pair.second.size());
      if(pair.first == "Name")
        column.name = pair.second;
      else
        column.metadata.push_back(pair);
    }
    if(n_columns > 1)
      column.name += (column.name.empty() ? "" : " ") + std::to_string(k + 1);
    column.values.reserve(n);
    for(std::size_t i = 0; i < n; ++i)
    {
      const double x = m_numbers[i * n_columns + k];
      if(is_label && !(x == std::floor(x) && std::abs(x) <= (std::numeric_limits<std::int32_t>::max)()))
        fail("it has the label ", x, ", but the keys of labels are 32-bit integers: the file is damaged.");
      column.values.push_back(x);
    }
    m_file->columns.push_back(std::move(column));
  }

  XML_Parser m_parser = nullptr;
  IO::Surface_file* m_file = nullptr;
  std::exception_ptr m_exception;
  std::size_t m_file_size, m_unpacked_size = 0, m_depth = 0, m_n_declared = 0, m_n_arrays = 0;
  bool m_is_gifti = false, m_has_text = false, m_has_points = false, m_has_triangles = false, m_has_indices = false;
  std::string m_text; // of the current element
  std::pair<std::string, std::string> m_pair;
  IO::Coordinate_system m_system;
  std::optional<Gifti_array> m_array; // the current array
  std::vector<double> m_numbers;      // of the current array
  std::set<std::int32_t> m_keys;      // of labels
};

} // namespace CGAL::Spherical_parameterization::internal

#include <CGAL/Spherical_parameterization/internal/numbers/end_arithmetic.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_CORTEX_INTERNAL_GIFTI_PARSER_H
