// The command `map` of the command line program, which is the default: settings, reports, and maps that are refused.

#include "Program_fixture.h"

#ifdef SPHERICAL_PARAMETERIZATION_PROGRAM

namespace {

struct Map_program : Program_fixture
{
  Map_program() { write_off("sphere.off", test_meshes::icosphere(2)); }
};

TEST_F(Map_program, writes_all_that_is_asked_for)
{
  const std::string out = expect_success("sphere.off -o result.off --json result.json --colored result");
  expect_part(out, "D_iso");
  expect_part(out, "bijective");
  EXPECT_EQ(names_of_files(), (Names{"sphere.off", "result.off", "result.json", "result_surface.ply",
                                     "result_sphere.ply", "stdout.txt", "stderr.txt"})); // nothing temporary is left
  const boost::property_tree::ptree report = json();
  EXPECT_EQ(report.get<std::size_t>("vertices"), 162u);
  EXPECT_TRUE(report.get<bool>("one_to_one"));
  EXPECT_LT(report.get<double>("distortion.D_iso.maximum"), 1.02);
  EXPECT_FALSE(report.get_child_optional("balanced")); // the radius is a part of the result already
  const Mesh_file surface =
      read_mesh("sphere.off"); // the same faces in the same order, each with the same first corner
  for(const char* name : {"result.off", "result_surface.ply", "result_sphere.ply"})
    EXPECT_EQ(read_mesh(name).faces, surface.faces);
  EXPECT_EQ(read_mesh("result_surface.ply").columns["vertex quality"].size(), 162u);

  fs::remove(path("result.off"));
  expect_part(expect_success("map sphere.off"), "D_angle");
  EXPECT_EQ(expect_success("sphere.off --quiet"), "");
  write("result.json", expect_success("sphere.off --json -"));
  EXPECT_EQ(json().get<std::size_t>("vertices"), 162u);
  EXPECT_EQ(expect_success("sphere.off --json - --quiet").substr(0, 1), "{"); // it was asked for
  EXPECT_EQ(names_of_files().size(), 6u);
}

// The vertices of the file come first; the texture is upright and faces the viewer, as the surface does.
TEST_F(Map_program, writes_texture_coordinates)
{
  const test_meshes::Triangle_list surface = test_meshes::bumpy_sphere(2);
  write_off("bumpy.off", surface);
  expect_success("bumpy.off --texture bumpy.obj");
  const Mesh_file textured = read_mesh("bumpy.obj");
  ASSERT_GT(textured.points.size(), surface.points.size());
  EXPECT_EQ(
      std::vector<test_meshes::Coordinates>(textured.points.data(), textured.points.data() + surface.points.size()),
      surface.points);
  std::istringstream lines(content(path("bumpy.obj")));
  std::vector<std::array<double, 2>> coordinates;
  double northern = 0., central = 0.; // sums of heights and of depths
  std::size_t n_corners = 0;
  for(std::string word; lines >> word;)
    if(word == "vt")
    {
      auto& [u, v] = coordinates.emplace_back();
      lines >> u >> v;
      EXPECT_TRUE(u >= 0. && u <= 1. && v >= 0. && v <= 1.) << u << ' ' << v;
    }
    else if(const std::size_t slash = word.find('/'); slash != word.npos)
    {
      const test_meshes::Coordinates& p = textured.points[std::stoul(word) - 1];
      const auto& [u, v] = coordinates.at(std::stoul(word.substr(slash + 1)) - 1);
      northern += v > 0.5 ? p[1] : -p[1];
      central += u > 0.25 && u < 0.75 ? p[2] : -p[2];
      ++n_corners;
    }
  EXPECT_EQ(n_corners, 3 * textured.faces.size());
  EXPECT_GT(northern, 0.5 * static_cast<double>(n_corners));
  EXPECT_GT(central, 0.5 * static_cast<double>(n_corners));
  expect_messages("", {{"bumpy.off --texture bumpy.ply", "--texture must be a file name that ends with .obj"},
                       {"match bumpy.off bumpy.off --texture a.obj", "--texture is not an option of match, but of map"},
                       {"bumpy.off --texture ", "--texture"},
                       {"bumpy.off --texture a.obj -o a.obj", "a.obj"}});

  write_off("spiky.off", test_meshes::random_stacked_sphere(300, 7));
  expect_messages("", {{"spiky.off --method conformal --texture a.obj", "it has no texture coordinates"}});
  EXPECT_FALSE(fs::exists(path("a.obj")));
}

// Needles that are narrower than the arcs along them take more new vertices than are allowed.
TEST_F(Map_program, warns_of_inverted_texture_triangles)
{
  test_meshes::Triangle_list needles = test_meshes::icosphere(2);
  for(std::size_t k = 0, n = needles.triangles.size(); k < n; ++k)
  {
    const auto [a, b, c] = needles.triangles[k];
    test_meshes::Coordinates point;
    for(std::size_t i = 0; i < 3; ++i)
      point[i] = (1. - 3e-6) * (0.7 * needles.points[a][i] + 0.3 * needles.points[b][i]) + 3e-6 * needles.points[c][i];
    test_meshes::split_face(needles, k, point);
  }
  write_off("needles.off", needles);
  const Outcome outcome = run("needles.off --initial needles.off --iterations 0 --texture needles.obj");
  EXPECT_EQ(outcome.status, 0);
  expect_part(outcome.err, "needles.off: Some texture triangles are inverted");
  EXPECT_TRUE(fs::exists(path("needles.obj")));
}

TEST_F(Map_program, takes_every_setting_and_ignores_none)
{
  write_off("long.off", test_meshes::scaled(test_meshes::icosphere(2), 1., 1.5, 2.5));
  expect_success("long.off -o start.off --iterations 1 --quiet");
  std::map<std::string, std::string> arguments_of; // each map
  std::vector<std::string> settings;
  std::istringstream list(
      "--prefer average; --prefer worst; --prefer sampling; --sharpness 3.5; --schedule 0.5,5; "
      "--schedule 0.1,2,3; --schedule 5,5,0; --radius two-phase; --radius optimal; --radius area; "
      "--radius balanced; --radius fixed=2.5; --initial start.off; --method hierarchical; "
      "--method hierarchical --energy conformal; --method harmonic; --method harmonic --iterations 2; "
      "--method conformal; --method arap; --method arap --initial harmonic; --method arap --initial start.off; "
      "--method stereographic; --paper --iterations 130; "
      "--paper --iterations 130 --initial hierarchical --radius area; --paper --schedule 1,1,5 --iterations 30; "
      "--tolerance 0; --tolerance 1e-6; --density equal; --density equal --energy isometric; "
      "--density equal --prefer average --iterations 2; --iterations 3; --iterations 0");
  for(std::string words; std::getline(list >> std::ws, words, ';');)
    settings.push_back(words);
  for(const char* energy : {"symmetric-dirichlet", "isometric", "conformal"})
    for(const char* start : {"hierarchical", "stereographic", "harmonic", "conformal", "schnyder"})
      settings.push_back(std::string("--energy ") + energy + " --initial " + start);
  for(const std::string& arguments : settings)
  {
    expect_success("long.off -o result.off --json result.json " + arguments);
    SCOPED_TRACE(arguments);
    EXPECT_TRUE(json().get<bool>("one_to_one"));
    EXPECT_LT(json().get<double>("distortion.D_angle.maximum"), 6.);
    const auto [other, is_new] = arguments_of.emplace(content(path("result.off")), arguments);
    EXPECT_TRUE(is_new) << "the same map as " << other->second;
  }
  expect_success("long.off -o result.off --method schnyder"); // whose angles are any
  EXPECT_TRUE(arguments_of.emplace(content(path("result.off")), "--method schnyder").second);
  for(const char* arguments :
      {"", "--method bld", "--energy symmetric-dirichlet", "--initial hierarchical", "--prefer balance",
       "--sharpness 20", "--radius objective", "--tolerance 1e-3", "--time-limit 100"})
  {
    expect_success(std::string("long.off -o result.off ") + arguments);
    EXPECT_EQ(arguments_of[content(path("result.off"))], "--energy symmetric-dirichlet --initial hierarchical")
        << arguments;
  }
  run("sphere.off --json result.json --radius fixed=2.5");
  EXPECT_EQ(json().get<double>("radius"), 2.5);
}

TEST_F(Map_program, reports_the_history_of_the_sweeps)
{
  write_off("bumpy.off", test_meshes::bumpy_sphere(2));
  for(const char* arguments :
      {"", "--iterations 7", "--iterations 0", "--prefer average", "--paper --iterations 120", "--method harmonic",
       "--method conformal", "--method arap", "--method hierarchical", "--method stereographic", "--method schnyder"})
  {
    SCOPED_TRACE(arguments);
    ASSERT_NE(run(std::string("bumpy.off --json result.json ") + arguments).status, 1);
    const boost::property_tree::ptree report = json();
    std::size_t iteration = 0;
    double radius = 0.;
    for(const auto& row : report.get_child("history"))
    {
      std::vector<double> values;
      for(const auto& value : row.second)
        values.push_back(value.second.get_value<double>());
      ASSERT_EQ(values.size(), 3u);
      EXPECT_EQ(values[0], static_cast<double>(++iteration));
      EXPECT_GT(values[1], 0.);
      radius = values[2];
    }
    EXPECT_EQ(iteration, report.get<std::size_t>("sweeps.average") + report.get<std::size_t>("sweeps.sharp"));
    // the last row is of the map that was written, but for a last step of the radius
    EXPECT_NEAR(radius, iteration > 0 ? report.get<double>("radius") : 0., 0.3 * radius);
  }

  const auto sweeps = [&](const std::string& arguments) {
    expect_success("bumpy.off --json result.json " + arguments);
    return std::make_pair(json().get<int>("sweeps.average"), json().get<int>("sweeps.sharp"));
  };
  EXPECT_EQ(sweeps("--paper --iterations 120"), std::make_pair(100, 20));
  EXPECT_EQ(sweeps("--paper --iterations 20 --schedule 0.1,10,15"), std::make_pair(15, 5));
  EXPECT_EQ(sweeps("--schedule 1,3,4 --iterations 6"), std::make_pair(4, 2));
  EXPECT_EQ(sweeps("--schedule 5,5 --iterations 3"), std::make_pair(0, 3));
  EXPECT_EQ(sweeps("--schedule 0.1,5,0 --iterations 1"), std::make_pair(0, 1));
  EXPECT_EQ(json().get<double>("sharpness"), 0.1);
  // Slivers go on changing, if only in the last digits.
  write_off("bumpy.off", test_meshes::with_slivers(test_meshes::icosphere(4), 40, 1e-4));
  EXPECT_EQ(sweeps("--tolerance 0").second, 250);
}

TEST_F(Map_program, writes_a_map_with_inverted_faces_and_says_so)
{
  write_off("spiky.off", test_meshes::random_stacked_sphere(300, 7));
  for(const char* method : {"conformal", "arap"})
  {
    SCOPED_TRACE(method);
    const Outcome outcome =
        run(std::string("spiky.off -o result.off --json result.json --colored result --method ") + method);
    EXPECT_EQ(outcome.status, 2);
    const boost::property_tree::ptree report = json();
    EXPECT_FALSE(report.get<bool>("one_to_one"));
    const std::size_t number_of_inverted_faces = report.get<std::size_t>("distortion.inverted_faces");
    EXPECT_GT(number_of_inverted_faces, 0u);
    const std::string fault = std::to_string(number_of_inverted_faces) + " faces are inverted";
    expect_part(outcome.out, "Not bijective: " + fault);
    EXPECT_EQ(outcome.out.find("Certified"), std::string::npos) << outcome.out;
    expect_part(outcome.err, fault);
    // it is a map, but none to start from
    expect_message("spiky.off --initial result.off", "bijective");
    for(const char* name : {"result.off", "result.json", "result_surface.ply", "result_sphere.ply"})
      EXPECT_TRUE(fs::remove(path(name))) << name;
  }
  expect_messages("spiky.off --initial conformal ", {{"--method arap", "--initial hierarchical"},
                                                     {"--paper", "--initial hierarchical"},
                                                     {"--method bld", "--initial hierarchical"}});

  write_off("tentacle.off", test_meshes::with_tentacle(400, 60.)); // which needs more precision
  for(const std::string start : {"stereographic", "harmonic"})
    expect_messages("tentacle.off ",
                    {{"--initial " + start, "--initial hierarchical"},
                     {"--initial " + start, "the " + start + " initial map is not bijective in double precision"},
                     {"--method " + start, "--method hierarchical"}});
  expect_success("tentacle.off --initial hierarchical --iterations 1");
}

TEST_F(Map_program, compares_maps_to_the_unit_sphere_at_their_balanced_radius)
{
  // Where a small sphere is mapped to the unit sphere, only the balanced radius shows that its shape is kept.
  write_off("small.off", test_meshes::scaled(test_meshes::icosphere(2), 1e-200, 1e-200, 1e-200));
  for(const char* arguments : {"--method hierarchical", "--method harmonic", "--method conformal",
                               "--method stereographic", "--energy conformal"})
  {
    const std::string out = expect_success(std::string("small.off --json result.json ") + arguments);
    SCOPED_TRACE(arguments);
    expect_part(out, "which balances areas");
    const boost::property_tree::ptree report = json();
    EXPECT_GT(report.get<double>("distortion.D_iso.average"), 1e199);
    EXPECT_NEAR(report.get<double>("balanced.radius"), 1e-200, 1e-202);
    EXPECT_LT(report.get<double>("balanced.D_iso.maximum"), 1.2);
    EXPECT_NEAR(report.get<double>("balanced.D_area.average"), 2., 0.01);
  }
  for(const auto& [method, measure] :
      Messages{{"hierarchical", "balanced D_iso"}, {"harmonic", "D_angle"}, {"bld", "D_iso"}})
  {
    expect_success("small.off --json result.json --colored result --method " + method);
    EXPECT_EQ(json().get<std::string>("colors.measure"), measure);
    EXPECT_LT(json().get<double>("colors.maximum"), 2.2);
  }
  // a radius that was chosen is meant
  for(const char* arguments : {"--energy conformal --radius fixed=3", "--method arap"})
  {
    expect_success(std::string("small.off --json result.json ") + arguments);
    EXPECT_FALSE(json().get_child_optional("balanced")) << arguments;
  }
}

TEST_F(Map_program, starts_from_a_map)
{
  expect_success("sphere.off -o first.off --iterations 1 --quiet");
  expect_success("sphere.off -o second.off --initial first.off --quiet");
  // the surface itself, star-shaped about the origin, is a map as well
  expect_success("sphere.off -o third.off --initial sphere.off --quiet");
  write_off("coarse.off", test_meshes::icosphere(1));
  write_off("mirrored.off", test_meshes::scaled(test_meshes::icosphere(2), -1., 1., 1.));
  expect_messages("sphere.off -o result.off --initial ",
                  {{"missing.off", "missing.off"}, {"coarse.off", "vertices"}, {"mirrored.off", "bijective"}});
}

TEST_F(Map_program, gives_parts_of_the_surface_the_prescribed_areas)
{
  for(const auto& [name, first_density] : {std::pair("density.ply", 3.), {"negative.ply", -1.}, {"nan.ply", NAN}})
    write(name, ply_with_values(2, "int label,float density", first_density));
  std::string last;
  for(const char* density : {"equal", "density.ply"})
  {
    const std::string out = expect_success(std::string("sphere.off -o even.off --json even.json --density ") + density);
    expect_part(out, "0 of 162 vertices differ by more than 1 %\n");
    EXPECT_TRUE(json("even.json").get<bool>("one_to_one"));
    EXPECT_TRUE(json("even.json").get<bool>("areas.reached"));
    EXPECT_LT(json("even.json").get<double>("areas.deviation"), 1e-3);
    EXPECT_NE(content(path("even.off")), last);
    last = content(path("even.off"));
  }
  write("other.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
                     "property float density\nend_header\n0 0 0 1\n");
  expect_messages("sphere.off -o no.off --density ",
                  {{"negative.ply", "the density of vertex 0 is negative"},
                   {"nan.ply", "the density of vertex 0 is negative, infinite or not a number"},
                   {"other.ply", "does not match the mesh"},
                   {"missing.ply", "No such file"},
                   {"sphere.off", "--density needs .ply files"},
                   {"''", "a file name, or equal"},
                   {"equal --radius area", "--radius and --density cannot be combined"},
                   {"equal --initial harmonic", "--initial and --density cannot be combined"},
                   {"equal --method arap", "--density requires --method bld"},
                   {"density.ply --fill-holes all", "replaced by --repair"}});
}

TEST_F(Map_program, refuses_bad_values_with_the_good_ones)
{
  expect_messages("sphere.off -o result.off --json result.json ",
                  {{"--method tutte", "bld, hierarchical, harmonic, conformal, arap, stereographic or schnyder"},
                   {"--energy elastic", "symmetric-dirichlet, isometric or conformal"},
                   {"--prefer best", "average, balance, worst or sampling"},
                   {"--initial spherical", "hierarchical, stereographic, harmonic, conformal, schnyder, or a file"},
                   {"--radius 2", "objective, two-phase, optimal, area, balanced or fixed=R"},
                   {"--paper --radius objective", "must be two-phase, optimal, area, balanced or fixed=R"},
                   {"--tolerance -1", "a number from 0 to 1"},
                   {"--tolerance nan", "a number from 0 to 1"},
                   {"--sharpness -1", "from 0 to 1e6"},
                   {"--sharpness nan", "from 0 to 1e6"},
                   {"--schedule 0,10", "2.3e-308 <= FIRST <= LAST <= 1e6"},
                   {"--schedule 0.1,1e7", "2.3e-308 <= FIRST <= LAST <= 1e6"},
                   {"--schedule 5,1", "--schedule"},
                   {"--schedule 5", "--schedule"},
                   {"--schedule 0.1,1,-1", "--schedule"},
                   {"--schedule 0.1,1,1.5", "--schedule"},
                   {"--iterations -1", "from 0"},
                   {"--iterations many", "from 0"},
                   {"--time-limit -1", "from 2.3e-308 to 1.7e308"},
                   {"--time-limit 1e-320", "from 2.3e-308 to 1.7e308"},
                   {"--threads 0", "from 1"},
                   {"--page page.txt", "a file name that ends with .html"},
                   {"--repair --max-added-area 2", "a number from 0 to 1"},
                   {"--repair --max-hole -1", "a number that is not negative"},
                   {"--repair --max-handle x", "a number that is not negative"},
                   {"--repair --wrap 0", "a number from 1e-4 to 1"},
                   {"--repaired a.txt", "a file name that ends with .off"},
                   {"--convention freesurfer", "cortex or none"},
                   {"--format bmp", "must be off, obj, ply, ts, gifti or freesurfer"}});
  for(const char* radius : {"0", "-1", "1e-320", "nan", "inf", "", "1x"})
    expect_message(std::string("sphere.off -o result.off --radius fixed=") + radius,
                   "a number R from 2.3e-308 to 1.7e308");
}

TEST_F(Map_program, refuses_options_that_would_be_ignored)
{
  expect_messages("sphere.off -o result.off --json result.json ",
                  {{"--schedule 1,10 --prefer worst", "--schedule and --prefer"},
                   {"--sharpness 1 --prefer worst", "--prefer and --sharpness"},
                   {"--energy isometric --prefer sampling", "omit --energy"},
                   {"--schedule 0.1,3 --sharpness 1", "--schedule and --sharpness"},
                   {"--method harmonic --energy isometric", "bld or hierarchical"},
                   {"--method harmonic --initial stereographic", "bld or arap"},
                   {"--method arap --sharpness 1", "--method bld"},
                   {"--method arap --radius area", "arap supports only --initial, --iterations and --time-limit"},
                   {"--method conformal --radius area", "conformal supports only --iterations and --time-limit"},
                   {"--method stereographic --iterations 5", "bld, harmonic, conformal or arap"},
                   {"--method stereographic --time-limit 5", "stereographic has no settings"},
                   {"--method hierarchical --iterations 5", "hierarchical supports only --energy and --time-limit"},
                   {"--method hierarchical --schedule 1,10", "--method bld"},
                   {"--paper --method bld", "--method"},
                   {"--paper --energy isometric", "--initial, --schedule, --radius, --iterations"},
                   {"--paper --prefer worst", "--initial, --schedule"},
                   {"--paper --sharpness 1", "--initial, --schedule"},
                   {"--paper --tolerance 0", "--initial, --schedule"},
                   {"--method harmonic --tolerance 0", "--tolerance requires --method bld"},
                   {"--wrap 0.1 --initial sphere.off", "--wrap and a file of --initial cannot be combined"}});
}

TEST_F(Map_program, counts_faces_that_are_nearly_flat)
{
  test_meshes::Triangle_list list = test_meshes::icosphere(1);
  list.points[0] = list.points[1] = list.points[list.triangles[0][1]]; // the faces between them are left without area
  write_off("flat.off", list);
  expect_part(run("flat.off").out, " faces are nearly flat\n");
}

} // namespace

#endif
