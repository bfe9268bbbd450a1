// The command line program with the surfaces of a study, which have the same names in many folders: which are found, where the
// results go, and what is not replaced.

#include "Program_fixture.h"

#ifdef SPHERICAL_PARAMETERIZATION_PROGRAM

namespace {

struct Studies : Program_fixture
{
  Studies()
  {
    write("corner.off", corner_off);
    for(const char* subject : {"bert", "ernie"})
      for(const char* name : {"lh.white", "rh.white", "lh.pial", "rh.pial"})
        write_surface(std::string("SUBJECTS/") + subject + "/surf/" + name, surface);
    write_curv("SUBJECTS/bert/surf/lh.white.H", {1., 2., 3., 4.});
  }

  // the paths of all files in a folder and in those below it
  Names files_in(const std::string& folder) const
  {
    Names names;
    for(const fs::directory_entry& entry : fs::recursive_directory_iterator(path(folder)))
      if(!entry.is_directory())
        names.insert(entry.path().lexically_relative(path(folder)).string());
    return names;
  }

  // runs the program, which maps so many surfaces, and returns what it says on the error stream
  std::string expect_mapped(const std::string& arguments, int n, int n_left_out = 0, int status = 0) const
  {
    SCOPED_TRACE(arguments);
    const Outcome outcome = run("batch " + arguments);
    EXPECT_EQ(outcome.status, status) << outcome.err;
    expect_part(outcome.out, "Mapped " + std::to_string(n) + ", left out " + std::to_string(n_left_out) + ",");
    return outcome.err;
  }

  static Names with_reports(const Names& spheres)
  {
    Names result = spheres;
    for(const std::string& sphere : spheres)
      result.insert(sphere + ".json");
    return result;
  }

  SP::IO::Surface_file surface = corner_surface();
};

TEST_F(Studies, results_lie_as_their_surfaces_do)
{
  const std::string study = "SUBJECTS --surfaces lh.white rh.white --output-folder out";
  expect_mapped(study, 4);
  EXPECT_EQ(files_in("out"), with_reports({"bert/surf/lh.sphere", "bert/surf/rh.sphere", "ernie/surf/lh.sphere",
                                           "ernie/surf/rh.sphere"}));
  EXPECT_EQ(json("out/ernie/surf/rh.sphere.json").get<std::string>("subject"), "ernie");
  EXPECT_EQ(json("out/ernie/surf/rh.sphere.json").get<std::string>("hemisphere"), "right");
  ASSERT_EQ(run("SUBJECTS/bert/surf/lh.white -o lh.single").status, 0);
  EXPECT_EQ(content(path("out/bert/surf/lh.sphere")), content(path("lh.single")));

  expect_mapped(study + " --resume", 0, 4);
  fs::remove(path("out/bert/surf/lh.sphere"));
  expect_mapped(study + " --resume", 1, 3);
  // the same names in the parts of an array of jobs; one that is missing fails alone
  EXPECT_EQ(
      expect_mapped("SUBJECTS --surfaces ernie/surf/lh.white elmo/surf/lh.white --resume --output-folder out", 0, 1, 1),
      "spherical_parameterization: SUBJECTS/elmo/surf/lh.white: No such file or directory\n");
  expect_mapped("SUBJECTS --surfaces 'e*/surf/?h.white' --resume --output-folder out", 0, 2);

  // subjects one by one
  expect_mapped("SUBJECTS/bert SUBJECTS/ernie/ --surfaces '?h.white' --resume --output-folder out", 0, 4);
  expect_mapped("SUBJECTS/bert --surfaces lh.white --output-folder own", 1);
  EXPECT_EQ(files_in("own"), with_reports({"surf/lh.sphere"}));
  EXPECT_EQ(json("own/surf/lh.sphere.json").get<std::string>("subject"), "bert");

  // beside the surfaces; what earlier runs have written is no surface
  expect_mapped("SUBJECTS/ --surfaces '?h.white' --output-folder SUBJECTS", 4);
  expect_mapped("SUBJECTS --surfaces '?h.white' --output-folder SUBJECTS --resume", 0, 4);
  EXPECT_EQ(content(path("SUBJECTS/bert/surf/lh.sphere")), content(path("lh.single")));
  expect_mapped("SUBJECTS --surfaces '?h.white' --output-folder SUBJECTS/out --format off", 4);
  expect_mapped("SUBJECTS --surfaces 'lh.white' 'lh.pial' --output-folder SUBJECTS/out2 --template corner.off", 4);
  EXPECT_EQ(files_in("SUBJECTS/out2").count("bert/surf/lh.pial"), 1u);
  EXPECT_EQ(files_in("SUBJECTS/out").count("ernie/surf/rh.sphere.off"), 1u);
}

TEST_F(Studies, nothing_of_others_is_replaced)
{
  write_surface("SUBJECTS/ernie/surf/lh.sphere", surface); // of the same size
  write("out/bert/surf/rh.sphere.json", "{}\n");
  const Names before = files_in("SUBJECTS");
  const std::string beside = "SUBJECTS --surfaces '?h.white' --output-folder SUBJECTS",
                    mirrored = "SUBJECTS --surfaces '?h.white' --output-folder out";
  expect_message("batch " + beside,
                 "SUBJECTS/ernie/surf/lh.sphere: is there already, and no report beside it tells that this "
                 "program has written it.\nChoose another --output-folder, or replace such files by --overwrite");
  expect_message("batch " + mirrored, "out/bert/surf/rh.sphere.json: is there already");
  EXPECT_EQ(files_in("SUBJECTS"), before);
  EXPECT_EQ(files_in("out"), Names{"bert/surf/rh.sphere.json"});
  expect_mapped(beside + " --overwrite", 4);
  expect_mapped(beside, 4);
  const std::string own = content(path("SUBJECTS/ernie/surf/lh.sphere"));
  write_surface("SUBJECTS/ernie/surf/lh.sphere", surface);
  ASSERT_EQ(content(path("SUBJECTS/ernie/surf/lh.sphere")).size(), own.size());
  expect_message("batch " + beside + " --resume", "SUBJECTS/ernie/surf/lh.sphere: is there already");
}

TEST_F(Studies, nothing_of_others_is_removed_for_a_surface_that_fails)
{
  write_surface("SUBJECTS/ernie/surf/lh.sphere", surface);
  const std::string own = content(path("SUBJECTS/ernie/surf/lh.sphere"));
  write("SUBJECTS/ernie/surf/lh.white", "");
  const std::string beside = "SUBJECTS --surfaces 'lh.white' --output-folder SUBJECTS --overwrite";
  expect_mapped(beside, 1, 0, 1);
  EXPECT_EQ(content(path("SUBJECTS/ernie/surf/lh.sphere")), own);
}

TEST_F(Studies, a_folder_that_cannot_be_read_fails_alone)
{
  fs::create_directories(path("SUBJECTS/lost+found"));
  fs::create_symlink("lost+found", path("SUBJECTS/again"));
  // for which the superuser has to be one who may not read everything
  const Outcome outcome = run_script("chmod 0 SUBJECTS/lost+found; [ $(id -u) != 0 ] || may_not='setpriv "
                                     "--bounding-set=-dac_override,-dac_read_search'; $may_not ls SUBJECTS/lost+found "
                                     "2>/dev/null && exit 77; $may_not "
                                     "\"$PROGRAM\" batch SUBJECTS --surfaces lh.white --output-folder out; status=$?; "
                                     "chmod 755 SUBJECTS/lost+found; exit $status");
  if(outcome.status == 77)
    GTEST_SKIP() << "The test may read all folders.";
  EXPECT_EQ(outcome.status, 1);
  expect_part(outcome.err, "spherical_parameterization: SUBJECTS/lost+found: cannot be read: Permission denied\n");
  expect_part(outcome.out, "Mapped 2, left out 0, folded 0, failed 1");
}

TEST_F(Studies, links_are_followed_but_not_written_through)
{
  write_surface("elsewhere/fsaverage/surf/lh.white", surface);
  fs::create_symlink("../elsewhere/fsaverage", path("SUBJECTS/fsaverage"));
  fs::create_symlink("bert", path("SUBJECTS/again")); // which has a name of its own
  fs::create_symlink("../..", path("SUBJECTS/bert/up"));
  fs::create_symlink(".", path("SUBJECTS/bert/here"));
  expect_mapped("SUBJECTS --surfaces lh.white --output-folder out", 3);
  EXPECT_EQ(files_in("out"), with_reports({"bert/surf/lh.sphere", "ernie/surf/lh.sphere", "fsaverage/surf/lh.sphere"}));

  const std::string err = expect_mapped("SUBJECTS --surfaces lh.white --output-folder SUBJECTS", 2);
  expect_part(err, "SUBJECTS/fsaverage: left out, as it is a link");
  EXPECT_EQ(names_of_files("elsewhere/fsaverage/surf"), Names{"lh.white"});
  expect_message("batch SUBJECTS --surfaces fsaverage/*/lh.white --output-folder SUBJECTS",
                 "links to other folders are left out");

  fs::create_directories(path("out2"));
  fs::create_symlink("../elsewhere", path("out2/ernie"));
  expect_message("batch SUBJECTS --surfaces lh.white --output-folder out2",
                 "out2/ernie/surf: there is a link on the way");
  EXPECT_EQ(names_of_files("elsewhere"), Names{"fsaverage"});
}

TEST_F(Studies, what_is_not_in_order_is_told)
{
  const Messages table = {
      {"SUBJECTS --surfaces lh.whit --output-folder out", "SUBJECTS: no surface below this folder is called lh.whit"},
      {"SUBJECTS --surfaces lh.white.H --output-folder out", "no surface below this folder is called lh.white.H"},
      {"SUBJECTS --surfaces lh.white lh.pial --output-folder out",
       "out/bert/surf/lh.sphere.json: would be written for both SUBJECTS/bert/surf/lh.pial and "
       "SUBJECTS/bert/surf/lh.white"},
      {"SUBJECTS --surfaces '?h.*' --output-folder SUBJECTS", "the next run would take this result for a surface"},
      {"SUBJECTS --surfaces lh.white --output-folder SUBJECTS --template SUBJECTS/bert/surf/lh.pial",
       "the next run would take this result for a surface"},
      {"SUBJECTS/bert/surf/lh.white --surfaces lh.white --output-folder out", "is a file; with --surfaces"},
      {"SUBJECTS/bert SUBJECTS/../SUBJECTS/bert/ --surfaces lh.white --output-folder out",
       "SUBJECTS/../SUBJECTS/bert/surf/lh.white: is given twice"},
      {"missing --surfaces lh.white --output-folder out", "missing: there is no such file"},
      {"SUBJECTS --output-folder out", "--surfaces names those of folders below it"},
      {"corner.off --surfaces lh.white", "--output-folder"},
      {"SUBJECTS --overwrite --output-folder out", "--surfaces"},
      {"--surfaces lh.white SUBJECTS --output-folder out", "INPUT"},
      {"SUBJECTS --surfaces ../lh.white --output-folder out", "--surfaces takes names of files"},
      {"SUBJECTS --surfaces lh.white/ --output-folder out", "--surfaces takes names of files"},
      {"SUBJECTS --surfaces . --output-folder out", "--surfaces takes names of files"},
      {"SUBJECTS --surfaces '' --output-folder out", "--surfaces takes names of files"},
  };
  for(const auto& [arguments, message] : table)
  {
    expect_message("batch " + arguments, message);
    EXPECT_FALSE(fs::exists(path("out"))) << arguments;
  }
  write("SUBJECTS/ernie/surf/rh.white", ""); // as a program leaves it that was stopped
  EXPECT_EQ(expect_mapped("SUBJECTS --surfaces '*white*' --output-folder out", 3, 0, 1),
            "spherical_parameterization: SUBJECTS/ernie/surf/rh.white: the file is empty\n");
}

TEST_F(Studies, other_formats_and_names)
{
  write_surface("study/lh.smoothwm.nofix", surface);
  write_surface("study/a/lh.own", surface);
  write("study/lh.smoothwm.json", "{}\n"); // which is no surface
  write("study/b/white_orig.off", corner_off);
  expect_mapped("study --surfaces 'lh.smooth*' lh.own 'b/*_orig.off' --output-folder study", 3);
  EXPECT_EQ(files_in("study"), (Names{"lh.smoothwm.json", "lh.smoothwm.nofix", "lh.sphere.nofix",
                                      "lh.sphere.nofix.json", "a/lh.own", "a/lh.own_sphere", "a/lh.own_sphere.json",
                                      "b/white_orig.off", "b/white_sphere.off", "b/white_sphere.json"}));
  EXPECT_EQ(json("study/a/lh.own_sphere.json").get<std::string>("subject"), "a");
}

#ifdef TEST_GIFTI

TEST_F(Studies, derivatives_of_BIDS)
{
  const auto add = [&](const std::string& folder, const std::string& name, const std::string& structure) {
    surface.origin.metadata_of_points = {{"AnatomicalStructurePrimary", structure}};
    write_by(folder + "/" + name, [&](auto& out, auto& message) { return SP::IO::write_GIFTI(out, surface, message); });
  };
  add("bids/sub-1/anat", "sub-1_hemi-L_white.surf.gii", "CortexLeft");
  add("bids/sub-1/anat", "sub-1_hemi-R_white.surf.gii", "CortexRight");
  add("bids/sub-2/ses-b/anat", "sub-2_ses-b_hemi-L_desc-white_white.surf.gii", "CortexLeft");
  write("bids/sub-1/anat/sub-1_hemi-L_curv.shape.gii", "of no interest");
  EXPECT_EQ(expect_mapped("bids --surfaces '*_white.surf.gii' --output-folder out", 3), "");
  EXPECT_EQ(files_in("out"), (Names{"sub-1/anat/sub-1_hemi-L_sphere.surf.gii", "sub-1/anat/sub-1_hemi-L_sphere.json",
                                    "sub-1/anat/sub-1_hemi-R_sphere.surf.gii", "sub-1/anat/sub-1_hemi-R_sphere.json",
                                    "sub-2/ses-b/anat/sub-2_ses-b_hemi-L_desc-white_sphere.surf.gii",
                                    "sub-2/ses-b/anat/sub-2_ses-b_hemi-L_desc-white_sphere.json"}));
  EXPECT_EQ(json("out/sub-2/ses-b/anat/sub-2_ses-b_hemi-L_desc-white_sphere.json").get<std::string>("subject"),
            "sub-2/ses-b");
  EXPECT_EQ(json("out/sub-1/anat/sub-1_hemi-R_sphere.json").get<std::string>("hemisphere"), "right");
  add("bids/sub-3", "sub-3_hemi-R_white.surf.gii", "CortexLeft");
  EXPECT_EQ(expect_mapped("bids --surfaces sub-3/*.gii --output-folder out", 1),
            "spherical_parameterization: bids/sub-3/sub-3_hemi-R_white.surf.gii: "
            "bids/sub-3/sub-3_hemi-R_white.surf.gii by its metadata is of the left hemisphere, but "
            "bids/sub-3/sub-3_hemi-R_white.surf.gii by its name of the right one\n");
}

#endif

} // namespace

#endif
