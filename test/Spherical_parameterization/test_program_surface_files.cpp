// Files of cortical surfaces and of their values, read and written by the command line program.

#include "Program_fixture.h"
#include "images.h"

#ifdef SPHERICAL_PARAMETERIZATION_PROGRAM

namespace {

using SP::IO::Surface_file;
using SP::IO::Vertex_values;

const std::string volume = []() {
  Binary_file file(true);
  file << std::uint32_t(2) << std::uint32_t(0) << std::uint32_t(20)
       << std::string("valid = 1\nfilename = a.mgz\nvolume = 256 256 256\nvoxelsize = 1 1 1\nxras = -1 0 0\n"
                      "yras = 0 0 -1\nzras = 0 1 0\ncras = 1 2 3\n");
  return file.content;
}();

const std::string remesh_white = "remesh lh.white octahedron=2 --method stereographic --quiet ";

struct Surface_files : Program_fixture
{
  Surface_files()
  {
    write("corner.off", corner_off);
    surface.origin.created_by = "created by somebody";
    surface.origin.footer = volume;
    write_surface("lh.white", surface);
    write_curv("lh.sulc", {0.5, -1., 2., 3.25});
    write_curv("lh.curv", {4., 3., 2., 1.});
    write_curv("lh.short", {1., 2.});
  }

  Surface_file read_freesurfer(const std::string& name) const { return read_by(name, SP::IO::read_FreeSurfer_surface); }

#ifdef TEST_GIFTI
  Surface_file read_gifti(const std::string& name) const
  {
    return read_by(name, SP::IO::read_GIFTI);
  }

  void write_gifti(const std::string& name, const Surface_file& file, bool is_packed = false) const
  {
    write_by(name, [&](auto& out, auto& message) { return SP::IO::write_GIFTI(out, file, message, is_packed); });
  }
#endif

  Surface_file surface = corner_surface();
};

TEST_F(Surface_files, a_surface_of_FreeSurfer_becomes_its_sphere)
{
  expect_success("lh.white -o lh.sphere");
  const Surface_file sphere = read_freesurfer("lh.sphere");
  EXPECT_EQ(sphere.triangles, surface.triangles);
  EXPECT_EQ(sphere.origin.footer, volume);
  EXPECT_EQ(sphere.origin.created_by, "created by Spherical_parameterization");
  // It is the sphere that other formats get, but for the digits; and it is read as a map.
  expect_success("lh.white -o lh.off");
  expect_success("lh.off -o rh.again");
  expect_success("corner.off -o sphere.off");
  EXPECT_EQ(content(path("lh.off")), content(path("sphere.off")));
  expect_success("lh.white --initial lh.sphere --iterations 0 -o again.off");
  // The name need not show the format.
  expect_success("corner.off -o sphere --format freesurfer");
  EXPECT_EQ(read_freesurfer("sphere").points, sphere.points);
  expect_success("sphere -o again.ply");
  expect_message("corner.off -o sphere", "must be a file name that ends with .off");
}

TEST_F(Surface_files, spheres_follow_the_convention_of_the_cortex)
{
  const auto expect_radius = [&](const std::string& name, double radius) {
    for(const auto& p : read_freesurfer(name).points)
      EXPECT_NEAR(test::norm(p), radius, 1e-6 * radius) << name;
  };
  // whether each vertex lies on its side of the centroid
  const auto expect_turned = [&](const std::string& name) {
    expect_radius(name, 100.);
    const auto points = read_freesurfer(name).points;
    for(std::size_t v = 0; v < 4; ++v)
    {
      const auto from_center = test::difference(surface.points[v], {0.25, 0.25, 0.25});
      EXPECT_GT(test::dot(from_center, points[v]), 60. * test::norm(from_center)) << name;
    }
  };
  expect_success("lh.white -o lh.sphere --json a.json --quiet");
  EXPECT_EQ(json("a.json").get<double>("written_radius"), 100.);
  expect_turned("lh.sphere");

  // It is the same sphere in a format with more digits, if it is asked for; and any sphere of it.
  expect_success("lh.white -o cortex.off --convention cortex");
  expect_success("cortex.off -o cortex --format freesurfer --method stereographic --convention none");
  expect_success("corner.off --initial cortex.off --iterations 0 --radius fixed=100 -o lh.again --convention none");
  expect_near(read_freesurfer("lh.again").points, read_freesurfer("lh.sphere").points, 1e-5);

  // What was chosen is kept.
  expect_success("lh.white -o lh.small --radius fixed=5");
  expect_radius("lh.small", 5.);
  expect_success("lh.white -o lh.plain --convention none --json b.json");
  expect_radius("lh.plain", json("b.json").get<double>("radius"));
  EXPECT_EQ(json("b.json").count("written_radius"), 0u);
  expect_part(json("b.json").get<std::string>("method"), "convention none");

  // many, each as its format says
  expect_success("batch lh.white corner.off --output-folder out");
  expect_radius("out/lh.white", 100.);
  expect_success("lh.white -o plain.off");
  EXPECT_EQ(content(path("out/corner.off")), content(path("plain.off")));

  // Directions on the sphere of a target turn with it.
  write("all.txt", "0\n1\n2\n3\n");
  expect_success("match corner.off lh.white --landmarks all.txt all.txt --sphere lh.on -o on.off");
  EXPECT_EQ(read_freesurfer("lh.on").points, read_freesurfer("lh.on_target").points);
  expect_turned("lh.on");
}

TEST_F(Surface_files, a_sphere_does_not_fold_in_short_numbers)
{
  // The end of this surface is a point on its sphere to the 7 digits that these numbers have.
  const std::string settings = " --initial end.off --iterations 0 --radius fixed=1 -o ";
  write_off("end.off", test::tube(4, 40, 0.5, 1.));
  expect_success("end.off" + settings + "lh.end");
  expect_success("end.off --initial lh.end --iterations 0 -o again.off"); // is read, and is bijective

  for(const char* radius : {"1e308", "1e-100"})
    expect_message("end.off -o lh.range --radius fixed=" + std::string(radius),
                   "Use --radius fixed=R with R from 1e-30 to 1e+38");

  // There is no room for much more.
  write_off("end.off", test::tube(32, 100, 0.8, 1.));
  expect_success("end.off" + settings + "sphere.off");
  expect_message("end.off" + settings + "lh.large",
                 "lh.large: cannot store the map: on the sphere, large parts of the surface");

  // A map that folds is written as it is.
  write_off("spiky.off", test_meshes::random_stacked_sphere(300, 7));
  EXPECT_EQ(run("spiky.off --method conformal -o lh.folded").status, 2);
  EXPECT_TRUE(fs::exists(path("lh.folded")));
}

TEST_F(Surface_files, damaged_files_are_named)
{
  write("lh.damaged", content(path("lh.white")).substr(0, 100));
  write("lh.text", "nothing of that kind");
  expect_messages(
      "", {{"lh.damaged -o a.off", "lh.damaged: Byte 28: the file is too short for 4 triangles: it is truncated"},
           {"lh.sulc -o a.off", "lh.sulc: the file contains vertex values, but no surface"},
           {"lh.text -o a.off", "lh.text: the name of a mesh file must end with one of .off"}});
}

TEST_F(Surface_files, values_are_carried_over)
{
  expect_success(remesh_white + "-o even.ply --transfer lh.sulc,lh.curv");
  expect_part(content(path("even.ply")), "property float sulc\nproperty float curv\n");
#ifdef TEST_MGH
  Surface_file values; // frames get numbers
  values.columns.resize(2);
  values.columns[0].values = values.columns[1].values = {1., 2., 3., 4.};
  write_by("lh.both.mgz", [&](auto& out, auto& message) { return SP::IO::write_MGH(out, values, message, true); });
  expect_success(remesh_white + "-o even.ply --transfer lh.both.mgz");
  expect_part(content(path("even.ply")), "property float both_1\nproperty float both_2\n");
  values.columns.resize(4091, values.columns[0]);
  write_by("lh.many.mgz", [&](auto& out, auto& message) { return SP::IO::write_MGH(out, values, message, true); });
  expect_message(remesh_white + "-o many.ply --transfer lh.many.mgz", "but a .ply file can have at most 4090");
#endif
  // those of another surface, whose sphere has its faces
  expect_success("lh.white -o lh.sphere");
  expect_success(remesh_white + "-o even.ply --transfer lh.sulc --values-sphere lh.sphere");
  write("cortex.label", "#!ascii label\n1\n2 0 0 0 1\n");
  expect_message(remesh_white + "-o lh.even --transfer lh.sulc", "the name of a .ply or .gii file");
  expect_messages(remesh_white + "-o even.ply --transfer ",
                  {{"lh.short", "lh.short: has values of 2 vertices, but lh.white has 4"},
                   {"lh.sulc,lh.short", "lh.short: has values of 2 vertices, but lh.sulc of 4"},
                   {"lh.sulc,lh.sulc", "lh.sulc: has values named sulc, like an earlier file"},
                   {"lh.sulc,missing", "missing: No such file"},
                   {"lh.sulc,corner.off", "--transfer needs .ply files"},
                   {"cortex.label", "cortex.label: has values of 1 vertices only"},
                   {"lh.short --values-sphere lh.sphere", "lh.short: has values of 2 vertices, but lh.sphere has 4"}});
}

TEST_F(Surface_files, features_are_compared_in_their_order_and_masks_may_be_labels)
{
  write_curv("rh.depth", {0.5, -1., 2., 3.25});
  write_curv("rh.curv", {4., 3., 2., 1.});
  write_curv("lh.nan", {1., NAN, 2., 3.});
  write_curv("lh.mask", {1., 1., 0., 1.});
  write("lh.cortex.label", "#!ascii label\n3\n0 0 0 0 0\n1 0 0 0 0\n3 0 0 0 0\n");
  write("lh.large.label", "#!ascii label\n1\n4 0 0 0 0\n");
  Surface_file regions;
  regions.columns = {{"", "NIFTI_INTENT_LABEL", Vertex_values::Type::int32, {0., 0., 1., 1.}, {}}};
  regions.labels = {{0, "a", {{1., 0., 0., 1.}}}, {1, "b", {{0., 1., 0., 1.}}}};
  write_by("lh.regions.annot",
           [&](auto& out, auto& message) { return SP::IO::write_FreeSurfer_annotation(out, regions, message); });
  const std::string map = "match lh.white lh.white --method hierarchical -o on.off ";
  const Outcome outcome = run(map + "--features lh.sulc,lh.curv rh.depth,rh.curv");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  expect_part(outcome.out, "Aligned:   by features");
  expect_success(map + "--convention none --masks lh.cortex.label lh.mask");
  expect_messages(
      map, {{"--features lh.sulc lh.short",
             "lh.short: does not match the mesh: it has values of 2 vertices, the mesh has 4"},
            {"--features lh.nan lh.sulc", "the property nan of vertex 1 is infinite or not a number"},
            {"--features lh.cortex.label lh.sulc", "lh.cortex.label: has values of 3 vertices only"},
            {"--masks lh.cortex.label lh.large.label",
             "lh.large.label: is not a mask of the mesh: it has a vertex 4, the mesh has 4 vertices"},
            {"--masks lh.cortex.label lh.regions.annot", "lh.regions.annot: is an annotation, which does not specify"},
            {"--masks lh.cortex.label lh.short", "it has 2 vertices, the mesh has 4"}});
}

TEST_F(Surface_files, a_surface_is_registered_to_an_atlas)
{
  constexpr double turn = 2.;
  const test_meshes::Triangle_list ball = test_meshes::icosphere(4), ahead = test_meshes::turned(ball, turn),
                                   behind = test_meshes::turned(ball, -turn);
  const auto value = [](const test_meshes::Coordinates& p) { // a mountain and a valley
    return std::exp(20. * (p[0] - 1.)) - 0.7 * std::exp(30. * (0.6 * p[1] + 0.8 * p[2] - 1.));
  };
  Surface_file white, atlas;
  std::vector<double> own, of_atlas;
  for(std::size_t v = 0; v < ball.points.size(); ++v)
  {
    const test_meshes::Coordinates& p = ball.points[v];
    own.push_back(value(p));
    of_atlas.push_back(value(behind.points[v]));
    white.points.push_back(test::combination(40. + 8. * own[v], p, 0., p));
    atlas.points.push_back(test::combination(50., p, 0., p));
  }
  for(const auto& t : ball.triangles)
    white.triangles.push_back({{std::uint32_t(t[0]), std::uint32_t(t[1]), std::uint32_t(t[2])}});
  atlas.triangles = white.triangles;
  write_surface("lh.folded", white);
  write_surface("lh.atlas", atlas);
  write_curv("lh.own", own);
  write_curv("lh.atlas.own", of_atlas);

  // The features agree where a vertex of the atlas turns up that far ahead.
  for(const std::string features : {"lh.own lh.atlas.own", "height lh.atlas.own --compare values --regularize spheres"})
  {
    SCOPED_TRACE(features);
    const Outcome outcome =
        run("register lh.folded lh.atlas --features " + features + " -o lh.sphere.reg --sphere lh.sphere");
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    expect_part(outcome.out, "the sphere is written with the radius 100");
    const Surface_file result = read_freesurfer("lh.sphere.reg");
    ASSERT_EQ(result.points.size(), white.points.size());
    EXPECT_EQ(result.triangles, white.triangles);
    EXPECT_EQ(read_freesurfer("lh.sphere").triangles, white.triangles);
    double sum = 0.;
    for(std::size_t v = 0; v < result.points.size(); ++v)
    {
      EXPECT_NEAR(test::norm(result.points[v]), 100., 1e-3);
      sum += test::dot(ahead.points[v], result.points[v]) / 100.;
    }
    EXPECT_GT(sum / static_cast<double>(result.points.size()), 0.99);
  }

  write_curv("lh.flat", std::vector<double>(own.size(), 0.5));
  expect_message("register lh.folded lh.own --features lh.own lh.own -o lh.sphere.reg", "lh.own");
  expect_message(
      "register lh.folded lh.folded --features lh.own lh.own -o lh.sphere.reg",
      "lh.folded: is not a sphere around the origin: the distances of its vertices from the origin range from ");
  expect_messages("register lh.folded lh.atlas -o lh.sphere.reg ",
                  {{"--features lh.own lh.flat", "lh.flat: the property own is constant"},
                   {"--features depth,height lh.atlas.own", "lh.atlas.own: has 1 features, but depth,height has 2"},
                   {"--features depht lh.atlas.own", "'depht', which is neither a file nor one of depth, height"},
                   {"", "--features"},
                   {"--features depth depth", "--features has 'depth' for the atlas"},
                   {"--features depth lh.atlas.own --split", "--split"}});
  run("register lh.folded lh.atlas --features lh.own lh.atlas.own -o reg.off --radius fixed=7 --convention none "
      "--json result.json");
  EXPECT_NEAR(json().get<double>("written_radius"), 50., 1e-4);
}

TEST_F(Surface_files, hemispheres_that_are_mixed_up_are_reported)
{
  const std::string map = " --method hierarchical -o on.off --convention none --quiet";
  const std::string rest = " to the right one\n", mixed = "lh.white belongs to the left hemisphere, but ";
  fs::copy(path("lh.white"), path("rh.white"));
  write_curv("rh.sulc", {0.5, -1., 2., 3.25});
  expect_success("match lh.white rh.white" + map, mixed + "rh.white" + rest);
  expect_success("match lh.white lh.white --features lh.sulc rh.sulc" + map, mixed + "rh.sulc" + rest + uncertain);
  expect_success("match lh.white lh.white --features lh.sulc lh.sulc" + map, uncertain);
  expect_success("match lh.white corner.off" + map);
  expect_success(remesh_white + "-o even.ply --transfer lh.curv,rh.sulc", mixed + "rh.sulc" + rest);
  expect_success("lh.white -o lh.sphere");
  fs::copy(path("lh.sphere"), path("sub-1_hemi-R_sphere"));
  expect_success("resample lh.sulc lh.sphere sub-1_hemi-R_sphere -o lh.out",
                 "lh.sphere belongs to the left hemisphere, but sub-1_hemi-R_sphere" + rest);
  fs::copy(path("lh.sphere"), path("a.R.sphere"));
  expect_success("resample rh.sulc a.R.sphere a.R.sphere -o rh.out");
  expect_success(
      "batch lh.white rh.white --template lh.white --output-folder out --method hierarchical --convention none",
      "spherical_parameterization: rh.white: " + mixed + "rh.white" + rest);
}

TEST_F(Surface_files, many_keep_their_names)
{
  fs::create_directory(path("in"));
  fs::copy(path("lh.white"), path("in/lh.white"));
  fs::copy(path("lh.white"), path("in/lh.pial"));
  expect_success("batch in/lh.white in/lh.pial --output-folder out");
  EXPECT_EQ(names_of_files("out"), (Names{"lh.white", "lh.white.json", "lh.pial", "lh.pial.json"}));
  EXPECT_EQ(read_freesurfer("out/lh.white").points.size(), 4u);
  expect_success("batch corner.off in/lh.white --output-folder out2 --format freesurfer");
  EXPECT_EQ(names_of_files("out2"), (Names{"corner", "corner.json", "lh.white", "lh.white.json"}));
  expect_message("batch in --output-folder out3", "this folder contains no file whose name ends with one of .off");
}

#ifdef TEST_GIFTI

TEST_F(Surface_files, GIFTI_keeps_what_is_known_of_a_surface)
{
  surface.origin.metadata = {{"Provenance", "unknown"}, {"UniqueID", "{1}"}};
  surface.origin.metadata_of_points = {{"AnatomicalStructurePrimary", "CortexRight"},
                                       {"AnatomicalStructureSecondary", "Pial"},
                                       {"GeometricType", "Anatomical"}};
  surface.origin.coordinate_systems.resize(1);
  surface.origin.coordinate_systems[0].data_space = "NIFTI_XFORM_TALAIRACH";
  write_gifti("a.surf.gii", surface);
  const auto metadata_of_sphere = [](const std::string& structure) {
    return SP::IO::Metadata{
        {"AnatomicalStructurePrimary", structure}, {"TopologicalType", "Closed"}, {"GeometricType", "Spherical"}};
  };
  expect_success("a.surf.gii -o b.surf.gii");
  const Surface_file sphere = read_gifti("b.surf.gii");
  EXPECT_EQ(sphere.triangles, surface.triangles);
  EXPECT_EQ(sphere.origin.metadata, (SP::IO::Metadata{{"Provenance", "unknown"}}));
  EXPECT_EQ(sphere.origin.metadata_of_points, metadata_of_sphere("CortexRight"));
  EXPECT_EQ(sphere.origin.coordinate_systems.at(0).data_space, "NIFTI_XFORM_TALAIRACH");

  // File names of FreeSurfer contain the hemisphere of a surface.
  expect_success("lh.white -o c.surf.gii");
  EXPECT_EQ(read_gifti("c.surf.gii").origin.metadata_of_points, metadata_of_sphere("CortexLeft"));
  EXPECT_EQ(read_gifti("c.surf.gii").points, sphere.points);
  expect_success("corner.off -o d.gii");
  expect_success("d.gii -o d.off");
  expect_success(
      "remesh a.surf.gii octahedron=2 -o even.surf.gii --sphere even_sphere.surf.gii --method stereographic");
  EXPECT_EQ(read_gifti("even.surf.gii").points.size(), 18u);
  EXPECT_EQ(read_gifti("even.surf.gii").origin.metadata_of_points[2].second, "Anatomical");
  write("all.txt", "0\n1\n2\n3\n");
  expect_success("match a.surf.gii lh.white --landmarks all.txt all.txt --sphere s.surf.gii -o on.surf.gii --morph "
                 "0.5 m.surf.gii",
                 "a.surf.gii belongs to the right hemisphere, but lh.white to the left one\n");
  for(const char* name : {"s.surf.gii", "s_target.surf.gii", "m.surf.gii"})
    EXPECT_TRUE(fs::exists(path(name))) << name;
  EXPECT_EQ(read_gifti("on.surf.gii").origin.metadata_of_points[0].second, "CortexLeft"); // it lies there

  fs::create_directory(path("in"));
  fs::copy(path("a.surf.gii"), path("in/a.surf.gii"));
  write("in/a.shape.gii", "no surface");
  expect_success("batch in --output-folder out");
  EXPECT_EQ(names_of_files("out"), (Names{"a.surf.gii", "a.json"}));
  expect_success("batch corner.off --output-folder out2 --format gifti");
  EXPECT_EQ(names_of_files("out2"), (Names{"corner.surf.gii", "corner.json"}));
}

TEST_F(Surface_files, GIFTI_may_be_packed)
{
  write_gifti("in/a.surf.gii.gz", surface, true);
  EXPECT_EQ(content(path("in/a.surf.gii.gz")).substr(0, 2), "\x1F\x8B");
  expect_success("in/a.surf.gii.gz -o b.surf.gii.gz");
  expect_success("in/a.surf.gii.gz -o b.surf.gii");
  EXPECT_EQ(run_script("gzip -dc b.surf.gii.gz | cmp - b.surf.gii").status, 0);
  expect_success("batch in --output-folder out");
  EXPECT_EQ(names_of_files("out"), (Names{"a.surf.gii.gz", "a.json"}));
  expect_success("remesh in/a.surf.gii.gz octahedron=2 --method stereographic -o even.surf.gii.gz --transfer lh.sulc");
  EXPECT_TRUE(fs::exists(path("even.func.gii.gz")));
  ASSERT_EQ(run_script("head -c 100000000 /dev/zero | gzip > bomb.surf.gii.gz").status, 0);
  expect_message("bomb.surf.gii.gz -o c.off", "bytes are to be unpacked to");
}

TEST_F(Surface_files, GIFTI_values_are_those_of_the_vertices_that_the_file_names)
{
  Surface_file file;
  file.vertices = {3, 1, 0, 2};
  file.columns = {{"", "NIFTI_INTENT_SHAPE", Vertex_values::Type::float32, {4., 2., 1., 3.}, {}}};
  write_gifti("values.shape.gii", file);
  write_curv("lh.values", {1., 2., 3., 4.});
  file.vertices = {3, 1};
  file.columns[0].values = {4., 2.};
  write_gifti("some.shape.gii", file);
  const std::string match = "match lh.white lh.white --method hierarchical -o a.off --features lh.sulc ";
  const auto result = [&](const std::string& arguments) {
    EXPECT_EQ(run(arguments).status, 0) << arguments;
    return content(path("a.off"));
  };
  for(const std::string& arguments : {std::string("lh.white -o a.off --density "), match})
  {
    EXPECT_EQ(result(arguments + "values.shape.gii"), result(arguments + "lh.values"));
    expect_message(arguments + "some.shape.gii", "some.shape.gii: has values of 2 vertices only");
  }
  // The first vertices of a surface are not all of it.
  Surface_file first = surface;
  first.vertices = {0, 1};
  first.columns = {{"first", "NIFTI_INTENT_SHAPE", Vertex_values::Type::float32, {1., 2.}, {}}};
  write_gifti("first.surf.gii", first);
  expect_message(remesh_white + "-o even.ply --transfer first.surf.gii",
                 "first.surf.gii: has values of 2 vertices only");
}

TEST_F(Surface_files, values_are_carried_over_to_GIFTI)
{
  Surface_file values;
  values.columns = {{"thickness", "NIFTI_INTENT_SHAPE", Vertex_values::Type::float32, {1., 2., 3., 4.}, {}},
                    {"region", "NIFTI_INTENT_LABEL", Vertex_values::Type::int32, {7., 7., 7., 7.}, {}}};
  values.labels = {{7, "all", {{0., 0., 0., 1.}}}};
  write_gifti("v.func.gii", values);
  expect_success(remesh_white + "-o even.ply --transfer v.func.gii",
                 "v.func.gii: not transferred: the names and colors of its labels, which need a GIFTI file\n");
  expect_success(remesh_white + "-o even.surf.gii --transfer lh.sulc,v.func.gii");
  Surface_file file = read_gifti("even.func.gii");
  ASSERT_EQ(file.columns.size(), 3u);
  EXPECT_EQ(file.columns[0].name, "sulc");
  EXPECT_EQ(file.columns[1].name, "thickness");
  EXPECT_EQ(file.columns[2].values, std::vector<double>(18, 7.));
  EXPECT_EQ(file.columns[2].intent, "NIFTI_INTENT_LABEL");
  ASSERT_EQ(file.labels.size(), 1u);
  EXPECT_EQ(file.labels[0].name, "all");
  EXPECT_EQ(file.origin.metadata.at(0).second, "CortexLeft");
  // Integers that 32-bit floating-point numbers do not hold
  Surface_file whole;
  whole.columns = {{"long", "NIFTI_INTENT_SHAPE", Vertex_values::Type::int32, std::vector<double>(4, 16777217.), {}}};
  write_gifti("long.shape.gii", whole);
  expect_success(remesh_white + "-o even.surf.gii --transfer long.shape.gii");
  file = read_gifti("even.func.gii");
  EXPECT_EQ(file.columns.at(0).type, Vertex_values::Type::int32);
  EXPECT_EQ(file.columns[0].values, std::vector<double>(18, 16777217.));
  // Names that points, colors and comments have in other files; numbers beside labels stay numbers.
  whole.columns[0].name = "x";
  whole.columns.push_back({"red #1", "NIFTI_INTENT_SHAPE", Vertex_values::Type::uint8, {1., 1., 1., 1.}, {}});
  write_gifti("names.shape.gii", whole);
  expect_success(remesh_white + "-o even.ply --transfer names.shape.gii",
                 "names.shape.gii: not transferred: the vertex property 'x', whose name is reserved\n");
  expect_part(content(path("even.ply")), "property uchar red__1\n");
  whole.columns[0].name = "count";
  whole.columns[0].values = {1., 1., 1., 1.};
  whole.columns[1].name = "red";
  write_gifti("names.shape.gii", whole);
  expect_success(remesh_white + "-o even.surf.gii --transfer v.func.gii,names.shape.gii");
  file = read_gifti("even.func.gii");
  ASSERT_EQ(file.columns.size(), 4u);
  EXPECT_EQ(file.columns[0].name, "red"); // colors come first
  EXPECT_EQ(file.columns[2].intent, "NIFTI_INTENT_LABEL");
  EXPECT_EQ(file.columns[3].intent, "NIFTI_INTENT_SHAPE");
  values.columns.erase(values.columns.begin());
  values.columns[0].name = "region2";
  write_gifti("w.label.gii", values);
  expect_success(remesh_white + "-o even.surf.gii --transfer v.func.gii,w.label.gii",
                 "v.func.gii,w.label.gii: not transferred: the names and colors of the labels of w.label.gii, "
                 "because an earlier file has labels\n");
  expect_message(remesh_white + "-o even.func.gii --transfer lh.sulc", "even.func.gii: would be written twice");
}

#endif

} // namespace

#endif
