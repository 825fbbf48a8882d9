// Camera, light, surfaces, view and selection by commands.
#include <fstream>
#include <iterator>
#include <sstream>

#include "modeler/orbit.h"
#include "modeler/view.h"
#include "tests/modeler_fixture.h"
#include "tracer/render.h"

namespace sir::test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

class Looks : public ModelerTest {
 protected:
  std::string file(const char* name) { return (folder / name).string(); }
  const CameraFile& camera() const { return *interpreter.looks().camera; }
  const Lighting& light() const { return *interpreter.looks().lighting; }
  const Surface& surface(std::int64_t number) const {
    return interpreter.looks().surfaces.at(number);
  }
};

TEST_F(Looks, TheCameraIsSaidInAnyOrder) {
  say("camera focal 2 up 0 0 1 target 1 2 3 window 8 6 parallel distance 5 normal 0 1 0");
  EXPECT_EQ(camera_text(camera()), "8 6\n1 2 3\n0 1 0\n5\n0 0 1\nPARALELA\n");
  say("câmera perspectiva");  // what it was before is not forgotten
  EXPECT_EQ(camera().focal, 2);
  say("CAMERA Focal Auto DISTANCIA 7 janela 4 3");
  EXPECT_EQ(camera_text(camera()), "4 3\n1 2 3\n0 1 0\n7\n0 0 1\n");
  EXPECT_EQ(camera().focal, 7);
  const std::string told = say("camera").text;
  modeler::Interpreter again;
  again.execute(told.substr(0, told.size() - 1));
  EXPECT_EQ(looks_of(again), looks_of(interpreter));
}

TEST_F(Looks, WhatNoCameraCouldBeIsRefused) {
  say("camera target 1 2 3");
  expect_refused("camera normal 0 0 0", "the normal direction must not be zero");
  expect_refused("camera up 0 1 0 normal 0 -2 0", "parallel to the normal");
  expect_refused("camera window 0 3", "must be > 0");
  expect_refused("camera distance -1", "must not be negative");
  expect_refused("camera focal 0", "the focal distance must be > 0");
  expect_refused("camera focal auto distance 0", "the distance is 0");
  expect_refused("camera target 1 2", "wrong number of words; it is camera [window W H]");
  expect_refused("camera target 1 2 x", "\"x\" is not a finite number");
  expect_refused("camera target 1 2 3 4", "\"4\" is no word of camera: window, target");
  expect_refused("camera taget 1 2 3", "did you mean target?");
  expect_refused("camera focal 3 load x", "wrong number of words");
  expect_refused("camera turn 1", "it is camera turn RIGHT DOWN");
  expect_refused("camera zoom 1 2", "it is camera zoom STEPS");
  expect_refused("camera frame balll", "there is no solid \"balll\"");
  expect_refused("camera load " + file("none"), "none.CAM: is missing");
  folder.write("bad.CAM", "1 2\n");
  expect_refused("camera load " + file("bad.CAM"), "bad.CAM");
  expect_refused("camera save " + file("none/x"), "none");
  expect_refused("camera save x.LUZ", "the name of another kind of file; this is a .CAM");
  expect_refused("undo camara", "undo [camera]");
  expect_refused("redo camera", "there is no camera to go on to");
}

TEST_F(Looks, TheCameraIsLedAndFramed) {
  say_all({"create a sphere 1", "create b cube 1", "translate b 5 0 0"});
  const modeler::Box all{{-1, -1, -1}, {6, 1, 1}};
  modeler::Orbit orbit(all, 4.0 / 3);
  EXPECT_EQ(camera_text(interpreter.camera()), camera_text(orbit.camera()));  // made up
  EXPECT_FALSE(interpreter.looks().camera);
  say("create c sphere 1");
  say("translate c 0 50 0");
  EXPECT_EQ(camera_text(interpreter.camera()), camera_text(orbit.camera()));  // and stays
  orbit.turn(0.1, -0.2);
  say("camera turn 0.1 -0.2");
  orbit.pan(0.3, 0.1);
  say("camera pan 0.3 0.1");
  orbit.zoom(2.5);
  say("camera zoom 2.5");
  EXPECT_EQ(camera_text(camera()), camera_text(orbit.camera()));
  say("camera frame b");
  EXPECT_EQ(camera_text(camera()), camera_text(modeler::framing({{5, 0, 0}, {6, 1, 1}}, 4.0 / 3)));
  say("camera window 1 2");
  say("câmera enquadra b");
  EXPECT_EQ(camera_text(camera()), camera_text(modeler::framing({{5, 0, 0}, {6, 1, 1}}, 0.5)));
  say("camera auto");
  EXPECT_FALSE(interpreter.looks().camera);
  EXPECT_GT(interpreter.camera().target.y, 20);  // made up anew
}

TEST_F(Looks, TheCameraHasAnUndoOfItsOwn) {
  say_all({"create a cube 1", "camera target 1 0 0", "translate a 1 0 0", "camera target 2 0 0"});
  say("undo");
  EXPECT_EQ(camera().target.x, 2);
  EXPECT_THAT(interpreter.script(), ElementsAre("create a cube 1", StartsWith("camera window ")));
  say("undo camera");
  EXPECT_EQ(camera().target.x, 1);
  say("anula câmera");
  EXPECT_FALSE(interpreter.looks().camera);
  expect_refused("undo camera", "there is no camera to go back to");
  say("redo camera");
  say("redo camera");
  EXPECT_EQ(camera().target.x, 2);
  say("camera turn 0 0");  // nothing new
  say("undo camera");
  EXPECT_EQ(camera().target.x, 1);
  say("camera distance 9");
  expect_refused("redo camera", "there is no camera to go on to");
  // A hand's is one, whatever it did.
  const std::string before = looks_of(interpreter);
  interpreter.hold_camera();
  for (int i = 0; i < 5; ++i) {
    interpreter.hold_camera();
    say("camera turn 0.1 0.01");
  }
  interpreter.let_go_of_camera();
  say("camera zoom 1");
  say("undo camera");
  EXPECT_NE(looks_of(interpreter), before);
  say("undo camera");
  EXPECT_EQ(looks_of(interpreter), before);
}

TEST_F(Looks, LightsAreAddedChangedAndCounted) {
  say_all({"light set", "light background 0.1 0.2 0.3", "luz ambiente 0.4", "light add 1 2 3 0.5",
           "light add 4 5 6 0.1 0.2 1.5", "luz move 1 -1 -2 -3", "light colour 2 1"});
  EXPECT_EQ(lighting_text(light()),
            "0.1 0.2 0.3\n0.4 0.4 0.4\n2\n-1 -2 -3 0.5 0.5 0.5\n4 5 6 1 1 1\n");
  EXPECT_EQ(say("light").text,
            "background 0.1 0.2 0.3\nambient 0.4 0.4 0.4\n"
            "light 1: at -1 -2 -3, intensity 0.5 0.5 0.5\nlight 2: at 4 5 6, intensity 1 1 1\n");
  say("light delete 1");
  ASSERT_EQ(light().lights.size(), 1u);
  EXPECT_EQ(light().lights[0].position.x, 4);
  for (int i = 0; i < 7; ++i) say("undo");
  EXPECT_EQ(lighting_text(light()), "0 0 0\n0 0 0\n0\n");
  for (int i = 0; i < 6; ++i) say("redo");
  EXPECT_EQ(light().lights.size(), 2u);
  expect_refused("light move 3 0 0 0", "there is no light 3: they count from 1 to 2");
  expect_refused("light delete 0", "there is no light 0");
  expect_refused("light colour 1 -1", "a light's intensity must not be negative");
  expect_refused("light ambient 1 2", "wrong number of words; it is light ambient R G B");
  expect_refused("light add 1 2 3", "it is light add X Y Z R G B");
  expect_refused("light background 0 0 -1", "the background must not be negative");
  expect_refused("light bakground 1", "did you mean background?");
  expect_refused("light set add 1 2 3 1 load x", "wrong number of words");
  expect_refused("light load " + file("none"), "none.LUZ: is missing");
  say("light set");
  expect_refused("light move 1 0 0 0", "there are none");
}

// What nobody has said is seen before and after: only what was said is otherwise.
TEST_F(Looks, AMadeUpLightIsKeptOnceItIsTouched) {
  say_all({"create a cube 1", "camera target 1 2 3"});
  Lighting expected = modeler::made_up_lighting(camera());
  EXPECT_EQ(lighting_text(interpreter.lighting()), lighting_text(expected));
  expected.ambient = glm::dvec3(0.9);
  say("light ambient 0.9");
  EXPECT_EQ(lighting_text(light()), lighting_text(expected));
  say("camera turn 0.5 0");
  EXPECT_EQ(lighting_text(interpreter.lighting()), lighting_text(expected));
  EXPECT_THAT(interpreter.script(), ElementsAre("create a cube 1", modeler::light_line(expected),
                                                StartsWith("camera window ")));
  say("undo");
  EXPECT_FALSE(interpreter.looks().lighting);
  say("redo");
  say("light auto");
  EXPECT_EQ(lighting_text(interpreter.lighting()),
            lighting_text(modeler::made_up_lighting(camera())));
  say("light delete 1");
  EXPECT_TRUE(light().lights.empty());
}

TEST_F(Looks, SurfacesAreDescribed) {
  say("surface 7 name \"Vidro azul\" colour 0.1 0.2 0.3 specular 0.4 exponent 60 transmission 0.6");
  EXPECT_EQ(surfaces_text({surface(7)}),
            "1\n\n7\nVidro azul\nLISA\n0.1 0.2 0.3 0.1 0.2 0.3 0.4 60 0.6 1.5\n\n");
  say("superfície 7 índice 1.3 difusa 0.5");
  EXPECT_EQ(surface(7).first.index, 1.3);
  EXPECT_EQ(surface(7).first.ambient, glm::dvec3(0.1, 0.2, 0.3));
  EXPECT_EQ(surface(7).first.diffuse, glm::dvec3(0.5));
  say("surface 8 chequer 4 2 odd colour 0.1 even colour 1");
  EXPECT_EQ(surface(8).cells_u, 4);
  EXPECT_EQ(surface(8).first.diffuse, glm::dvec3(1));
  EXPECT_EQ(surface(8).second.diffuse, glm::dvec3(0.1));
  // What is not said is as it is made up.
  EXPECT_EQ(surface(8).first.specular, modeler::made_up_surface(8).first.specular);
  say("surface 9 chequer 3 3");
  EXPECT_EQ(surface(9).second.diffuse, 0.5 * surface(9).first.diffuse);
  EXPECT_THAT(say("surface 10").text,
              AllOf(StartsWith("surface 10 name "), HasSubstr("# made up")));
  const std::string told = say("surfaces").text;
  modeler::Interpreter again;
  std::istringstream lines(told);
  for (std::string line; std::getline(lines, line);) again.execute(line);
  EXPECT_EQ(looks_of(again), looks_of(interpreter));
  say("surface 8 plain");
  EXPECT_EQ(surface(8).texture, TextureKind::plain);
  say("surfaces delete 8");
  EXPECT_EQ(interpreter.looks().surfaces.count(8), 0u);
  say("undo");
  EXPECT_EQ(surface(8).texture, TextureKind::plain);
  say("undo");
  EXPECT_EQ(surface(8).texture, TextureKind::chequer);
}

TEST_F(Looks, WhatNoSurfaceCouldBeIsRefused) {
  say("surface 1 colour 0.5");
  expect_refused("surface", "wrong number of words; it is surface NUMBER");
  expect_refused("surface x colour 1", "surface number \"x\" is not a non-negative integer");
  expect_refused("surface 1 colour -1", "must not be negative");
  expect_refused("surface 1 specular -1", "coefficients must not be negative");
  expect_refused("surface 1 transmission 1 index 0", "needs a refraction index > 0");
  expect_refused("surface 1 chequer 0 1", "two positive integers");
  expect_refused("surface 1 odd colour 1", "only a chequer has odd cells");
  expect_refused("surface 1 name \" x\"", "white space");
  expect_refused("surface 1 glossy 1", "\"glossy\" is no word of surface: name, colour");
  expect_refused("surface 1 specualr 1", "did you mean specular?");
  expect_refused("surfaces delete 2", "surface 2 is not described");
  expect_refused("surfaces lod x", "did you mean load?");
  expect_refused("surfaces load " + file("none"), "none.SUP: is missing");
}

TEST_F(Looks, FilesComeBack) {
  const std::string base = SIR_IMAGES "/calice";
  const Scene scene = read_scene(base);
  say("camera load " + base);
  say("light load " + base + ".LUZ");
  say("surfaces load " + base);
  EXPECT_EQ(camera_text(camera()), camera_text(scene.camera));
  EXPECT_EQ(lighting_text(light()), lighting_text(scene.lighting));
  EXPECT_EQ(surfaces_text(interpreter.looks().surface_list()), surfaces_text(scene.surfaces));
  for (const char* word : {"camera", "light", "surfaces"})
    EXPECT_THAT(say(word + std::string(" save ") + file("OUT")).done, HasSubstr("wrote "));
  EXPECT_EQ(folder.read("OUT.CAM"), camera_text(scene.camera));
  EXPECT_EQ(folder.read("OUT.LUZ"), lighting_text(scene.lighting));
  EXPECT_EQ(folder.read("OUT.SUP"), surfaces_text(scene.surfaces));
  say("surface 99 colour 1");
  say("surfaces load " + base);  // in place of what there was
  EXPECT_EQ(interpreter.looks().surfaces.size(), scene.surfaces.size());
  say("undo");
  EXPECT_EQ(interpreter.looks().surfaces.count(99), 1u);
  interpreter.protect(folder / "OUT.CAM");
  expect_refused("camera save " + file("OUT"), "is not overwritten");
}

TEST_F(Looks, ShowTakesWhatWasSet) {
  say("load calice " SIR_IMAGES "/calice");
  say("show calice x --shaded --size 40x30");
  const Planes made_up = written;
  for (const char* word : {"camera", "light", "surfaces"})
    say(word + std::string(" load " SIR_IMAGES "/calice"));
  say("show calice x --shaded --size 40x30");
  RenderOptions options;
  options.size = {40, 30};
  EXPECT_TRUE(written == render(read_scene(SIR_IMAGES "/calice"), options).planes);
  EXPECT_FALSE(written == made_up);
  const Planes set = written;
  say("show calice x --shaded --size 40x30 --scene " SIR_IMAGES "/calice");
  EXPECT_TRUE(written == set);
  say("camera auto");
  say("light auto");
  say("surfaces delete 1");
  say("show calice x --size 40x30");
  const Planes lines = written;
  say("camera load " SIR_IMAGES "/calice");
  say("show calice x --size 40x30");
  EXPECT_FALSE(written == lines);
}

TEST_F(Looks, TheViewIsSwitched) {
  EXPECT_EQ(say("view").text,
            "ghosts off\naxes on\nbounds on\ngrid off\nsilhouette off\nalone off\n");
  say_all({"view ghosts on", "vista eixos não", "view grid on", "view grid off"});
  EXPECT_TRUE(interpreter.view().ghosts);
  EXPECT_FALSE(interpreter.view().axes);
  EXPECT_THAT(interpreter.script(), ElementsAre("view ghosts on", "view axes off"));
  expect_refused("undo", "there is nothing to undo");
  expect_refused("view ghost on", "did you mean ghosts?");
  expect_refused("view ghosts maybe", "\"maybe\" is no state of a switch: on, off");
  expect_refused("view ghosts", "wrong number of words; it is view [ghosts");
}

TEST_F(Looks, WhatIsSelectedIsThere) {
  say_all({"create a sphere 1", "create b cube 2", "combine c a union b"});
  EXPECT_EQ(say("select c 2 5").done, "\"b\" of \"c\": cube, face Z=1");
  EXPECT_EQ(interpreter.selection(), (modeler::Selection{"c", 2, 5}));
  EXPECT_EQ(interpreter.script().back(), "select c 2 5");
  expect_refused("select d", "there is no solid \"d\"");
  expect_refused("select c 3", "\"c\" has no place 3: it has 3 nodes, from 0 on");
  expect_refused("select c 0 0", "\"c\" is a composite");
  expect_refused("select c 1 1", "a sphere has no face 1: it has 1 face");
  expect_refused("select c 1 0 0", "it is select [NAME");
  say_all({"translate c 1 0 0", "rename c d"});
  EXPECT_EQ(interpreter.selection(), (modeler::Selection{"d", 2, 5}));  // it follows
  say("undo");
  EXPECT_EQ(interpreter.selection()->solid, "c");
  say("split c");
  EXPECT_FALSE(interpreter.selection());
  say_all({"seleciona a", "undo"});
  EXPECT_FALSE(interpreter.selection());
  say_all({"select c", "select"});
  EXPECT_FALSE(interpreter.selection());
  EXPECT_THAT(interpreter.script(), ElementsAre("create a sphere 1", "create b cube 2",
                                                "combine c a union b", "translate c 1 0 0"));
}

TEST_F(Looks, ThePagesExampleWorks) {
  std::ifstream page(std::string(SIR_DOCS) + "/modeler.md");
  const std::string text{std::istreambuf_iterator<char>(page), {}};
  const auto begin = text.find("\ncamera target ");
  ASSERT_NE(begin, text.npos);
  std::istringstream lines(text.substr(begin, text.find("```", begin) - begin));
  say("create glass sphere 1");
  int commands = 0;
  for (std::string line; std::getline(lines, line);) {
    // To a folder of its own.
    for (const char* save : {"camera save ", "light save ", "surfaces save "})
      if (line.starts_with(save)) line = save + file("glass");
    say(line);
    ++commands;
  }
  EXPECT_GT(commands, 8);
  EXPECT_EQ(surface(1).first.index, 1.5);
  EXPECT_EQ(light().lights[0].position, glm::dvec3(-4, 8, 6));
  EXPECT_TRUE(folder.has("glass.SUP"));
  EXPECT_EQ(written_to, "glass.png");
}

}  // namespace
}  // namespace sir::test
