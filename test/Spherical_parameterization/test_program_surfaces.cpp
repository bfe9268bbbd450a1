// The commands of the command line program that make something else of a surface than its sphere: remesh, repair, show.

#include "Program_fixture.h"

#ifdef TEST_EXR
#include <CGAL/Spherical_parameterization/Sampling/EXR_geometry_image.h>
#endif
#ifdef TEST_PNG
#include <CGAL/Spherical_parameterization/Sampling/PNG_geometry_image.h>
#endif

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#ifdef SPHERICAL_PARAMETERIZATION_PROGRAM

namespace {

using test_meshes::Coordinates;

struct Surface_program : Program_fixture
{
  Surface_program()
  {
    write_off("sphere.off", test_meshes::icosphere(2));
    write_off("torus.off", test_meshes::torus(20, 6));
  }

  // what a page has in the element of a script
  static std::string in_element(const std::string& page, const std::string& id)
  {
    const std::string begin = "id=\"" + id + "\">";
    const std::size_t start = page.find(begin) + begin.size();
    return page.substr(start, page.find("</script>", start) - start);
  }
};

// Remeshes over a solid and over the sphere that the program has written itself.
TEST_F(Surface_program, remeshes_through_the_sphere)
{
  expect_part(expect_success("remesh sphere.off octahedron=4 -o remesh.off --sphere map.off --json result.json"),
              "Remesh:    66 vertices, 128 faces");
  const Mesh_file sphere = read_mesh("sphere.off");
  EXPECT_EQ(read_mesh("map.off").faces, sphere.faces);
  const boost::property_tree::ptree report = json();
  expect_part(report.get<std::string>("method"), "stretch energy");
  EXPECT_EQ(report.get<std::size_t>("remesh.vertices"), 66u);
  EXPECT_GT(report.get<double>("remesh.psnr"), 35.);
  EXPECT_LT(report.get<double>("remesh.distance_from_surface.maximum"), 0.2);
  expect_success("remesh sphere.off octahedron=4 --initial map.off --iterations 0 -o again.off");
  expect_near(read_mesh("again.off").points, read_mesh("remesh.off").points);

  // Over the map itself, the remesh is the surface, with the values of its vertices and faces, or those of another surface.
  write("values.ply", ply_with_values(2));
  write_off("other.off", test_meshes::icosphere(1));
  expect_success("remesh sphere.off map.off --initial map.off --iterations 0 --transfer values.ply -o same.ply");
  expect_success("remesh other.off sphere.off --transfer values.ply --values-sphere sphere.off -o other.ply");
  Mesh_file values = read_mesh("values.ply"), same = read_mesh("same.ply"), other = read_mesh("other.ply");
  expect_near(same.points, sphere.points);
  EXPECT_EQ(same.columns["vertex label"], values.columns["vertex label"]);
  for(std::size_t v = 0; v < same.points.size(); ++v)
  {
    for(Mesh_file* result : {&same, &other})
      EXPECT_NEAR(result->columns["vertex height"].at(v), values.columns["vertex height"][v], 1e-6);
    EXPECT_NEAR(same.columns["vertex nz"][v], same.points[v][2], 0.05);
  }
  expect_success("remesh sphere.off map.off"); // reports the distance alone

  write_off("flat.off", test_meshes::scaled(test_meshes::icosphere(1), 1., 1., 0.));
  expect_messages("remesh sphere.off ",
                  {{"torus.off -o result.off", "genus"},
                   {"flat.off -o result.off", "is not a mesh of the sphere"},
                   {"missing.off -o result.off", "or a file with a mesh of the sphere"},
                   {"cube=2 -o result.off --sphere result.off", "written twice"},
                   {"octahedron=0", "N from 1 to 5000"},
                   {"octahedron=1.5", "N from 1 to 5000"},
                   {"octahedron=1e9", "N from 1 to 5000"},
                   {"prism=3", "octahedron=N, cube=N or icosahedron=N"},
                   {"cube=2 --transfer sphere.off", "--transfer needs .ply files"},
                   {"cube=2 --transfer missing.ply -o a.ply", "No such file"},
                   {"cube=2 --transfer values.ply -o a.off", "the name of a .ply or .gii file"},
                   {"cube=2 --values-sphere sphere.off", "--transfer"},
                   {"--geometry-image image.gif", ".png or .exr"},
                   {"cube=2 --image-size 65", "--geometry-image"},
                   {"--geometry-image image.png --image-size 64", "an odd number from 3 to 10001"},
                   {"--geometry-image image.png --image-size 1", "an odd number from 3 to 10001"},
                   {"--geometry-image image.png --image-size 8.5", "an odd number from 3 to 10001"}});
  expect_messages("remesh other.off cube=3 -o result.ply --transfer values.ply",
                  {{"", "does not match this mesh"}, {" --values-sphere other.off", "is not a map of this mesh"}});
}

// Their points are those and the normals of the remesh by the octahedron.
TEST_F(Surface_program, writes_geometry_images)
{
  using Image = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  [[maybe_unused]] const auto expect_images = [&](const std::string& format, const auto& read, double tolerance) {
    expect_success("remesh sphere.off octahedron=4 -o even.ply --geometry-image image." + format + " --image-size 9");
    Mesh_file remesh = read_mesh("even.ply");
    Image points, normals;
    std::ifstream file_of_points(path("image." + format), std::ios::binary),
        file_of_normals(path("image_normals." + format), std::ios::binary);
    ASSERT_EQ(read(file_of_points, points), SP::OK);
    ASSERT_EQ(read(file_of_normals, normals), SP::OK);
    ASSERT_EQ(points.number_of_vertices(), remesh.points.size());
    for(const Image::Vertex_index v : points.vertices())
      for(int k = 0; k < 3; ++k)
      {
        const std::vector<double>& column = remesh.columns[std::string("vertex n") + "xyz"[k]];
        ASSERT_NEAR(points.point(v)[k], remesh.points[v][static_cast<std::size_t>(k)], tolerance) << v << k;
        ASSERT_NEAR(normals.point(v)[k], column.at(v), tolerance) << v << k;
      }
  };
#ifdef TEST_PNG
  expect_images(
      "png", [](auto& in, Image& image) { return SP::IO::read_PNG_geometry_image(in, image); }, 2e-5);
#endif
#ifdef TEST_EXR
  expect_images(
      "exr", [](auto& in, Image& image) { return SP::IO::read_EXR_geometry_image(in, image); }, 6e-8);
  for(const double scale : {1e-50, 1e50})
  {
    write_off("scaled.off", test_meshes::scaled(test_meshes::icosphere(1), scale, scale, scale));
    expect_message("remesh scaled.off --geometry-image none.exr",
                   "none.exr: The values are too large, or all too small");
    expect_success("remesh scaled.off --geometry-image image.png");
  }
#endif
}

// A surface with two holes, whose vertices have values.
class Repair_program : public Surface_program
{
protected:
  void SetUp() override
  {
    Surface_program::SetUp();
    for(const test_meshes::Triangle& t : m_closed.triangles)
      if(std::count(t.begin(), t.end(), 20u) + std::count(t.begin(), t.end(), 100u) == 0)
        m_opened.triangles.push_back(t);
    write_off("opened.off", m_opened);
    write_off("closed.off", m_closed);
  }

  const test_meshes::Triangle_list m_closed = test_meshes::bumpy_sphere(2);
  test_meshes::Triangle_list m_opened = {m_closed.points, {}};
};

// What is written is the repaired surface, what is measured are the faces of the file.
TEST_F(Repair_program, maps_a_surface_with_holes)
{
  expect_message("opened.off -o map.off", "--repair, fills holes");
  expect_message("opened.off -o map.off --repair --max-hole 0.1", "a hole has a border of 6 edges at vertex");
  expect_message("opened.off -o map.off --repair --max-added-area 0.001", "--max-added-area 0.0");
  const std::string out = expect_success("opened.off --repair -o map.off --repaired repaired.ply --json result.json "
                                         "--colored colored --max-added-area 0.1");
  expect_part(out, "Repaired  2 holes filled\n");
  expect_part(out, "patches cover ");
  EXPECT_EQ(json().get_child("repair.patches").size(), 2u);
  EXPECT_GT(json().get_child("repair.patches").front().second.get<double>("share_of_area"), 0.);
  expect_message("opened.off -o map.off --repair --max-added-area 0.001", "closing the surface would add ");
  Mesh_file repaired = read_mesh("repaired.ply");
  for(const char* name : {"map.off", "colored_surface.ply", "colored_sphere.ply"})
    EXPECT_EQ(read_mesh(name).faces, repaired.faces) << name;
  ASSERT_GT(repaired.faces.size(), m_opened.triangles.size());
  for(std::size_t f = 0; f < repaired.faces.size(); ++f)
  {
    const bool is_old = f < m_opened.triangles.size();
    EXPECT_EQ(repaired.columns["face patch"][f], is_old ? 0. : 1.);
    EXPECT_EQ(repaired.columns["face source_face"][f], is_old ? static_cast<double>(f) : -1.);
  }
  for(std::size_t v = 0; v < repaired.points.size(); ++v)
  {
    const double source = repaired.columns["vertex source_vertex"][v];
    if(source >= 0.)
    {
      EXPECT_EQ(repaired.points[v], m_opened.points[static_cast<std::size_t>(source)]);
    }
  }
  expect_success("check repaired.ply map.off");
  expect_success("repair opened.off -o filled.ply --max-added-area 0.1");
  EXPECT_EQ(content(path("filled.ply")), content(path("repaired.ply")));

  const test_meshes::Triangle_list band = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0.1}, {1, 0, 0.1}, {0, 1, 0.1}},
                                           {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}}};
  write_off("band.off", band);
  expect_part(run("band.off --repair --max-added-area 1 -o map.off").err, "more than half");
  test_meshes::Triangle_list holes = m_closed; // six of one face each, apart from each other
  for(const std::size_t f : {310u, 250u, 190u, 130u, 70u, 10u})
    holes.triangles.erase(holes.triangles.begin() + static_cast<std::ptrdiff_t>(f));
  write_off("holes.off", holes);
  expect_part(expect_success("repair holes.off --max-added-area 0.5"), ", and 1 smaller patch\n");
  m_opened.points[3][1] = std::numeric_limits<double>::quiet_NaN();
  write_off("broken.off", m_opened);
  expect_message("repair broken.off -o result.ply", "vertex 3 has a coordinate that is");
}

// Values, landmarks, masks and maps of the file are those of the repaired surface, whose vertices have other numbers.
TEST_F(Repair_program, carries_over_what_belongs_to_the_file)
{
  const std::string repair = " --repair --max-added-area 0.1";
  expect_success("opened.off" + repair + " -o map.off --repaired repaired.ply");
  const Mesh_file map = read_mesh("map.off");
  Mesh_file repaired = read_mesh("repaired.ply");
  std::string values_of_file = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(m_opened.points.size()) +
                               "\nproperty double x\nproperty double y\nproperty double z\nproperty float height\n"
                               "element face " +
                               std::to_string(m_opened.triangles.size()) +
                               "\nproperty list uchar int vertex_indices\nend_header\n";
  for(std::size_t v = 0; v < m_opened.points.size(); ++v)
    values_of_file += "0 0 0 " + std::to_string(v) + '\n';
  for(const auto& [a, b, c] : m_opened.triangles)
    values_of_file += "3 " + std::to_string(a) + ' ' + std::to_string(b) + ' ' + std::to_string(c) + '\n';
  write("values.ply", values_of_file);
  expect_success("remesh opened.off map.off -o remesh.ply --transfer values.ply --prefer balance" + repair);
  Mesh_file remesh = read_mesh("remesh.ply"), values = read_mesh("values.ply");
  EXPECT_EQ(remesh.columns["face patch"], repaired.columns["face patch"]);
  const auto [least, largest] =
      std::minmax_element(values.columns["vertex height"].begin(), values.columns["vertex height"].end());
  for(std::size_t v = 0; v < remesh.points.size(); ++v)
  {
    const double source = repaired.columns["vertex source_vertex"][v], height = remesh.columns["vertex height"][v];
    if(source >= 0.)
    {
      EXPECT_NEAR(height, values.columns["vertex height"][static_cast<std::size_t>(source)], 1e-6);
    }
    EXPECT_GE(height, *least);
    EXPECT_LE(height, *largest);
  }

  // A map of the repaired surface, and one of the file alone.
  expect_success("opened.off --initial map.off --iterations 0" + repair);
  test_meshes::Triangle_list images = m_opened;
  for(std::size_t v = 0; v < map.points.size(); ++v)
    if(const double source = repaired.columns["vertex source_vertex"][v]; source >= 0.)
      images.points[static_cast<std::size_t>(source)] = map.points[v];
  write_off("images.off", images);
  expect_success("opened.off --initial images.off --iterations 0" + repair);

  // Patches are masked, and landmarks have the numbers of the file.
  write("of_closed.ply", ply_with_values(2, "float height"));
  EXPECT_EQ(run("match opened.off closed.off -o onto.off --features values.ply of_closed.ply" + repair).status, 0);
  write("landmarks.txt", "0\n50\n161\n");
  EXPECT_EQ(run("match opened.off closed.off -o onto.off --landmarks landmarks.txt landmarks.txt" + repair).status, 0);
  write("gone.txt", "20\n");
  expect_message("match opened.off closed.off -o onto.off --landmarks gone.txt gone.txt" + repair,
                 "vertex 20 has no face after the repair");
  expect_message("opened.off -o map.off --density values.ply --wrap 0.2" + repair,
                 "--wrap and a file of --density cannot be combined");
  EXPECT_EQ(run("opened.off -o map.off --density values.ply" + repair).status, 0);
}

TEST_F(Repair_program, wraps_what_is_no_surface)
{
  write_off("sheet.off", {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}});
  expect_message("sheet.off --repair -o map.off", "--wrap ALPHA closes gaps");
  const std::string out = expect_success("sheet.off --repair --wrap 0.2 -o map.off --repaired wrapped.ply");
  expect_part(out, "Repaired  wrapped: ");
  EXPECT_EQ(read_mesh("wrapped.ply").columns["vertex source_vertex"].front(), -1.);
  // What needs nothing is as it was.
  expect_success("closed.off -o as_it_is.off");
  expect_part(expect_success("closed.off --repair -o map.off"), "Repaired  nothing");
  EXPECT_EQ(content(path("map.off")), content(path("as_it_is.off")));
}

TEST_F(Repair_program, maps_one_component_or_each_and_cuts_handles)
{
  const test_meshes::Triangle_list two =
      test_meshes::disjoint_union(test_meshes::octahedron(), test_meshes::bumpy_sphere(2));
  write_off("three.off", test_meshes::disjoint_union(two, test_meshes::tetrahedron()));
  expect_message("three.off -o map.off", "--each-component maps each");
  const std::string out = expect_success("three.off -o map.off --repair --json result.json");
  expect_part(out, "Repaired  the largest of 3 components kept; the others had 12 faces");
  EXPECT_EQ(json().get<std::size_t>("faces"), 320u);
  EXPECT_EQ(json().get<std::size_t>("repair.components"), 3u);
  expect_part(expect_success("three.off -o map.off --each-component --json each.json"),
              "Component 1 of 3, with 320 faces; the others have 8 and 4");
  for(const auto& [name, n_faces] : {std::pair("map_1.off", 320u), {"map_2.off", 8u}, {"map_3.off", 4u}})
    EXPECT_EQ(read_mesh(name).faces.size(), n_faces) << name;
  EXPECT_EQ(read_mesh("map_2.off").points.size(), 6u); // its own
  EXPECT_EQ(json("each_3.json").get<std::size_t>("component"), 3u);
  EXPECT_EQ(json("each_3.json").get<std::size_t>("components"), 3u);
  EXPECT_EQ(json("each_1.json").get_child("faces_of_components").size(), 3u);
  write("values.ply", ply_with_values(1));
  for(const char* words : {"map three.off --density values.ply -o a.off", "map three.off --initial values.ply -o a.off",
                           "remesh three.off cube=2 --transfer values.ply -o a.ply"})
    expect_message(std::string(words) + " --each-component", "--each-component and a file of --");
  expect_success("repair three.off -o part.ply --each-component");
  expect_success("check part_2.ply map_2.off --quiet");
  EXPECT_EQ(read_mesh("part_2.ply").columns["face source_face"].front(), 0.); // in the file
  EXPECT_EQ(read_mesh("part_1.ply").columns["face source_face"].front(), 8.);
  write_off("alike.off", test_meshes::disjoint_union(test_meshes::octahedron(), test_meshes::octahedron()));
  expect_part(expect_success("repair alike.off"), "map --each-component maps each component");
  // what fails with one of them
  write_off("with_torus.off", test_meshes::disjoint_union(test_meshes::octahedron(), test_meshes::torus(8, 5)));
  const Outcome outcome = run("with_torus.off -o of_torus.off --each-component");
  EXPECT_EQ(outcome.status, 1);
  expect_part(outcome.err, "component 1 of 2: with_torus.off: the surface has the genus 1");
  EXPECT_FALSE(fs::exists(path("of_torus_1.off")));
  EXPECT_EQ(read_mesh("of_torus_2.off").faces.size(), 8u);

  expect_message("torus.off -o map_of_torus.off", "A cycle of 6 edges around a handle, of length 6, at vertex");
  const std::string repaired = expect_success("repair torus.off --handles handles.ply --max-added-area 0.5");
  expect_part(repaired, "1 handle cut\n");
  expect_part(repaired, "The surface can be mapped.");
  expect_part(content(path("handles.ply")), "element edge ");
  expect_success("repair sphere.off --handles handles.ply");
  expect_part(content(path("handles.ply")), "element edge 0\n");
}

TEST_F(Surface_program, writes_a_page)
{
  if(run("show sphere.off -o page.html").err.find("was built without the page") != std::string::npos)
    GTEST_SKIP() << "The program was built without the page.";
  expect_message("torus.off --page page.html", "show SURFACE -o PAGE.html shows them");
  expect_part(expect_success("show torus.off -o page_of_handles.html"), "Written:   page_of_handles.html\n");
  expect_part(content(path("page_of_handles.html")), "distance from handles");
  const std::string name = "a<!--b.off";
  write_off(name, test_meshes::icosphere(2));
  expect_success("'" + name + "' --page page.html --quiet");
  const std::string page = content(path("page.html"));
  EXPECT_EQ(page.substr(0, 15), "<!DOCTYPE html>");
  EXPECT_EQ(page.find("<!--b"), std::string::npos); // a comment that would swallow the page
  expect_part(page, "a\\u003c!--b.off");
  EXPECT_EQ(in_element(page, "corners").size(), 320u * 3 * 2 / 3 * 4); // of 320 faces, with two bytes each
  EXPECT_EQ(in_element(page, "inverted"), "");
  expect_success("show '" + name + "' -o shown.html");
  EXPECT_EQ(in_element(content(path("shown.html")), "corners"), in_element(page, "corners"));

  // two surfaces: the common refinement, and for each of its triangles both faces
  write_off("long.off", test_meshes::scaled(test_meshes::icosphere(2), 1., 1.5, 2.5));
  ASSERT_EQ(run("match long.off sphere.off --page page.html --overlay overlay.ply --quiet").status, 0);
  const std::size_t n = read_mesh("overlay.ply").faces.size();
  for(const std::string id : {"left_faces", "right_faces"})
    EXPECT_EQ(in_element(content(path("page.html")), id).size(), (4 * n + 2) / 3 * 4) << id;
  EXPECT_EQ(run("match sphere.off long.off --split --page page.html --convention cortex --quiet").status, 0);
  const std::string classes = in_element(content(path("page.html")), "sulci");
  EXPECT_FALSE(classes.empty());
  EXPECT_EQ(classes.find_first_not_of("ABEQ="), classes.npos); // 16 bits that are 0 or 1, in base 64
}

TEST_F(Surface_program, opens_all_that_it_reads_before_it_maps_anything)
{
  write("sphere.ply", "");
  for(const char* words :
      {"match torus.off missing.ply", "match torus.off sphere.off --landmarks sphere.off missing.ply",
       "match torus.off sphere.off --features missing.ply sphere.ply",
       "remesh torus.off cube=3 -o a.ply --transfer missing.ply",
       "remesh torus.off cube=3 -o a.ply --transfer sphere.ply --values-sphere missing.ply",
       "check torus.off missing.ply", "show torus.off missing.ply -o page.html"})
    expect_message(words, "missing.ply: No such file");
}

} // namespace

#endif
