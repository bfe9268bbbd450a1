#include "Page.h"
#include "Page_text.h"

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>

#include <limits>

namespace Program {

#ifdef PROGRAM_WRITES_PAGES
namespace {

std::string facts(const Page& page)
{
  const auto side = [](const Page::Side& of) {
    return Json_object()
        .add("title", of.title)
        .add("centre", of.centre)
        .add("scale", of.scale)
        .add("rotation", of.rotation);
  };
  Json_object measures;
  for(const Page::Measure& measure : page.measures)
    measures.add(measure.name, Json_object()
                                   .add("meaning", measure.meaning)
                                   .add("minimum", measure.minimum)
                                   .add("statistics", measure.statistics));
  Json_object all_classes;
  std::vector<std::string> names;
  for(const Page::Measure& measure : page.measures)
    names.push_back(measure.name);
  for(const Page::Classes& of : page.classes)
  {
    std::vector<Json_object> classes;
    for(const Page::Class& one : of.classes)
      classes.push_back(Json_object().add("name", one.name).add("colour", one.colour));
    all_classes.add(of.name, Json_object().add("meaning", of.meaning).add("classes", classes));
    names.push_back(of.name);
  }
  return Json_object()
      .add("vertices", page.left.points.size())
      .add("left", side(page.left))
      .add("right", side(page.right))
      .add("has_sphere", page.has_sphere)
      .add("has_one_frame", page.has_one_frame)
      .add("has_numbers", page.has_numbers)
      .add("morphs", page.morphs)
      .add("measure", names[page.shown])
      .add("measures", measures)
      .add("classes", all_classes)
      .add("one_to_one", page.is_one_to_one)
      .add("certificate", page.verdict)
      .add("summary", page.summary)
      .text();
}

// A text in JSON is the same with this; HTML would end or change the script at a tag.
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

// The lowest byte of a number comes first, as browsers have it.
template <class Number>
void write_array(std::ostream& out, const std::string& id, const std::vector<Number>& numbers)
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
  out << R"(<script type="text/plain" id=")" << id << "\">" << text << "</script>\n";
}

template <class Index>
void write_corners(std::ostream& out, const Page& page)
{
  std::vector<Index> corners;
  for(const auto& triangle : page.triangles)
    for(const std::uint32_t v : triangle)
      corners.push_back(static_cast<Index>(v));
  write_array(out, "corners", corners);
}

void write_side(std::ostream& out, const std::string& id, const Page::Side& side, bool has_numbers)
{
  std::vector<float> coordinates;
  for(const Point_3& p : side.points)
    for(int k = 0; k < 3; ++k)
      coordinates.push_back(static_cast<float>(p[k]));
  write_array(out, id, coordinates);
  if(has_numbers)
    write_array(out, id + "_faces", side.faces);
}

} // namespace
#endif

void check_pages()
{
#ifdef PROGRAM_WRITES_PAGES
  if(*page_fault != '\0')
    throw Program_error(page_fault);
#else
  throw Program_error(
      "this program was built without the page of --page.\nInstall Node.js and npm, and build it again.");
#endif
}

void write_page([[maybe_unused]] std::ostream& out, [[maybe_unused]] const Page& page)
{
#ifdef PROGRAM_WRITES_PAGES
  write_pieces(out, page_head);
  out << R"(<script type="application/json" id="facts">)" << without_tags(facts(page)) << "</script>\n";
  if(page.left.points.size() <= std::size_t((std::numeric_limits<std::uint16_t>::max)()) + 1)
    write_corners<std::uint16_t>(out, page);
  else
    write_corners<std::uint32_t>(out, page);
  write_side(out, "left", page.left, page.has_numbers);
  write_side(out, "right", page.right, page.has_numbers);
  for(const Page::Measure& measure : page.measures)
    write_array(out, measure.name, measure.values);
  for(const Page::Classes& classes : page.classes)
    write_array(out, classes.name, classes.values);
  write_array(out, "folded", page.folded);
  write_pieces(out, page_tail);
#endif
}

} // namespace Program
