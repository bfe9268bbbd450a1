#include "Page.h"
#include "Page_text.h"

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>

#include <limits>

namespace Program {

namespace {

// Numbers are little-endian, as in browsers.
template <class Number>
std::string element_of(const std::string& id, const std::vector<Number>& numbers)
{
  SP::internal::Byte_writer writer(false);
  for(const Number x : numbers)
    writer.write(x);
  std::string& bytes = writer.content;
  using Base64 =
      boost::archive::iterators::base64_from_binary<boost::archive::iterators::transform_width<const char*, 6, 8>>;
  const std::size_t n_missing = (3 - bytes.size() % 3) % 3;
  bytes.append(n_missing, '\0');
  std::string text(Base64(bytes.data()), Base64(bytes.data() + bytes.size()));
  text.replace(text.size() - n_missing, n_missing, n_missing, '=');
  return R"(<script type="text/plain" id=")" + id + "\">" + text + "</script>\n";
}

#ifdef PROGRAM_WRITES_PAGES
std::string facts(const Page& page)
{
  const auto side = [](const Page::Side& of) {
    return Json{{"title", of.title}, {"center", of.center}, {"scale", of.scale}, {"rotation", of.rotation}};
  };
  return Json{{"vertices", page.left.points.size()},
              {"left", side(page.left)},
              {"right", side(page.right)},
              {"has_sphere", page.has_sphere},
              {"has_one_frame", page.has_one_frame},
              {"has_numbers", page.has_numbers},
              {"morphs", page.morphs},
              {"measure", page.shown},
              {"measures", page.measures},
              {"classes", page.classes},
              {"one_to_one", page.is_one_to_one},
              {"certificate", page.verdict},
              {"warning", page.warning},
              {"summary", page.summary}}
      .text();
}

// Escapes < in JSON, because a tag would end or change the script element of HTML.
std::string without_tags(const std::string& json)
{
  std::string result;
  for(const char c : json)
    result += c == '<' ? "\\u003c" : std::string(1, c);
  return result;
}

void write_pieces(std::ostream& out, const char* const* piece)
{
  for(; *piece != nullptr; ++piece)
    out << *piece;
}

void write_side(std::ostream& out, const std::string& id, const Page::Side& side, bool has_numbers)
{
  std::vector<float> coordinates;
  for(const Point_3& p : side.points)
    for(int k = 0; k < 3; ++k)
      coordinates.push_back(static_cast<float>(p[k]));
  out << element_of(id, coordinates);
  if(has_numbers)
    out << element_of(id + "_faces", side.faces);
}
#endif

} // namespace

void Page::add_measure(const std::string& name, const std::string& title, const std::string& meaning, double minimum,
                       const Json& statistics, const std::vector<float>& values)
{
  measures.add(name, {{"title", title}, {"meaning", meaning}, {"minimum", minimum}, {"statistics", statistics}});
  arrays += element_of(name, values);
}

void Page::add_classes(const std::string& name, const std::string& title, const std::string& meaning,
                       const std::vector<Class>& names, const std::vector<std::uint16_t>& values)
{
  std::vector<Json> all;
  for(const Class& one : names)
    all.push_back({{"name", one.name}, {"colour", one.colour}});
  classes.add(name, {{"title", title}, {"meaning", meaning}, {"classes", all}});
  std::vector<std::uint16_t> of_faces = values;
  if(has_numbers) // the drawn faces are parts of the faces of the first surface
  {
    of_faces.clear();
    for(const std::uint32_t f : left.faces)
      of_faces.push_back(values[f]);
  }
  arrays += element_of(name, of_faces);
}

void check_pages()
{
#ifdef PROGRAM_WRITES_PAGES
  if(*page_fault != '\0')
    throw Program_error(page_fault);
#else
  throw Program_error(
      "this program was built without support for pages.\nInstall Node.js and npm, and build it again.");
#endif
}

void write_page([[maybe_unused]] std::ostream& out, [[maybe_unused]] const Page& page)
{
#ifdef PROGRAM_WRITES_PAGES
  write_pieces(out, page_head);
  out << R"(<script type="application/json" id="facts">)" << without_tags(facts(page)) << "</script>\n";
  std::vector<std::uint32_t> corners;
  for(const auto& triangle : page.triangles)
    corners.insert(corners.end(), triangle.begin(), triangle.end());
  if(page.left.points.size() <= std::size_t((std::numeric_limits<std::uint16_t>::max)()) + 1)
    out << element_of("corners", std::vector<std::uint16_t>(corners.begin(), corners.end()));
  else
    out << element_of("corners", corners);
  write_side(out, "left", page.left, page.has_numbers);
  write_side(out, "right", page.right, page.has_numbers);
  out << page.arrays << element_of("inverted", page.inverted);
  write_pieces(out, page_tail);
#endif
}

} // namespace Program
