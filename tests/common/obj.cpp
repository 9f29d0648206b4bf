/// @file obj.cpp

#include <doctest/doctest.h>
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "sampling/rng.hpp"
#include "scene/obj.hpp"
#include "scratch_folder.hpp"

using namespace sr;
using sr::test::ScratchFolder;

namespace {

std::filesystem::path write(const ScratchFolder& folder, const std::string& name, const std::string& bytes) {
    std::filesystem::remove(folder.path / name);  // file systems that flush what is overwritten are slow
    std::ofstream(folder.path / name, std::ios::binary) << bytes;
    return folder.path / name;
}

const std::string square =
    "v 0 0 0\n"
    "v 1 0 0\n"
    "v 1 1 0\n"
    "v 0 1 0\n";

const std::string paints =
    "newmtl red\n"
    "Kd 0.5 0.25 0\n"
    "newmtl lamp\n"
    "Kd 0 0 0\n"
    "Ke 17 12 4\n";

/// What reading says of a file of these bytes, without the folder's name; "" if it reads.
std::string complaint(const std::string& bytes) {
    const ScratchFolder folder("obj_test");
    write(folder, "paints.mtl", paints);
    try {
        static_cast<void>(read_obj(write(folder, "test.obj", bytes)));
    } catch (const std::runtime_error& error) {
        const std::string message = error.what();
        const std::string prefix  = (folder.path / "").string();
        return message.starts_with(prefix) ? message.substr(prefix.size()) : message;
    }
    return "";
}

/// The same of an MTL file.
std::string complaint_of_mtl(const std::string& bytes) {
    const ScratchFolder folder("obj_test");
    write(folder, "test.mtl", bytes);
    try {
        static_cast<void>(read_obj(write(folder, "test.obj", "mtllib test.mtl\n" + square + "f 1 2 3\n")));
    } catch (const std::runtime_error& error) {
        return std::string(error.what()).substr((folder.path / "").string().size());
    }
    return "";
}

Scene read(const std::string& bytes) {
    const ScratchFolder folder("obj_test");
    write(folder, "paints.mtl", paints);
    return read_obj(write(folder, "test.obj", bytes));
}

using Faces = std::vector<Mesh<double>::Face>;

}  // namespace

TEST_CASE("obj: triangles and their materials, and grey where none is named") {
    const Scene scene =
        read("f 1 2 3\nmtllib paints.mtl\n" + square + "usemtl lamp\nf 1 3 4\nusemtl red\nf -4 -2 -1\n");
    REQUIRE(scene.mesh.vertices.size() == 4);
    CHECK(scene.mesh.vertices[2] == Vector3<double>{1, 1, 0});
    CHECK(scene.mesh.faces == Faces{{0, 1, 2}, {0, 2, 3}, {0, 2, 3}});
    REQUIRE(scene.materials.size() == 3);
    CHECK(scene.material_of_face == std::vector<std::uint32_t>{2, 1, 0});
    CHECK(scene.materials[0].name == "red");
    CHECK(scene.materials[0].reflectance() == Spectrum{0.5F, 0.25F, 0});
    CHECK(scene.materials[0].emission == Spectrum{});
    CHECK(scene.materials[1].emission == Spectrum{17, 12, 4});
    CHECK(scene.materials[2].reflectance() == Spectrum{0.8F, 0.8F, 0.8F});
}

TEST_CASE("obj: a polygon becomes a fan from its first corner, also one of more corners than a byte counts") {
    CHECK(read(square + "f 2 3 4 1\n").mesh.faces == Faces{{1, 2, 3}, {1, 3, 0}});

    std::string text;
    for (int i = 0; i < 300; ++i) text += fmt::format("v {} {} 0\n", i, i * i);
    text += "f";
    for (int i = 1; i <= 300; ++i) text += fmt::format(" {}", i);
    const Scene scene = read(text + "\n");
    REQUIRE(scene.mesh.faces.size() == 298);
    CHECK(scene.mesh.faces[0] == Mesh<double>::Face{0, 1, 2});
    CHECK(scene.mesh.faces[297] == Mesh<double>::Face{0, 298, 299});
}

TEST_CASE("obj: a polygon that is not convex is a fan from the first corner that sees it whole, or refused") {
    const std::string dart =
        "v 0 0 0\nv 2 -1 0\nv 0.5 0 0\nv 2 1 0\n";  // whose third corner is its tip inside
    CHECK(read(dart + "f 1 2 3 4\n").mesh.faces == Faces{{0, 1, 2}, {0, 2, 3}});
    CHECK(read(dart + "f 2 3 4 1\n").mesh.faces == Faces{{2, 3, 0}, {2, 0, 1}});
    CHECK(read("f 2 3 4 1\n" + dart).mesh.faces == Faces{{2, 3, 0}, {2, 0, 1}});
    const std::string comb =  // two notches, and no corner that sees into both
        "v 0 0 0\nv 6 0 0\nv 6 3 0\nv 5 3 0\nv 4 1 0\nv 3 3 0\nv 2 1 0\nv 1 3 0\nv 0 3 0\n";
    CHECK(complaint(comb + "f 1 2 3 4 5 6 7 8 9\n") ==
          "test.obj:10: face of 9 corners that no corner sees whole; must be cut into convex ones");
    for (const char* polygon : {"f 1 1 2 2\n", "f 1 2 3 2\n", "f 1 1 1 1\n"})  // without an area: as they are
        CHECK(read(square + polygon).mesh.faces.size() == 2);
}

TEST_CASE("obj: what a text editor may do to a file changes nothing") {
    const Faces expected{{0, 1, 2}, {0, 2, 3}};
    const auto  faces = [](const std::string& bytes) { return read(bytes).mesh.faces; };
    CHECK(faces(square + "f 1 2 3 4") == expected);
    CHECK(faces("v\t0 0  0 \t\r\nv 1 0 0\r\n\r\nv 1 1 0 # corner\r\nv 0 1 0\r\n   f 1 2\t3 4  \r\n") ==
          expected);
    CHECK(faces("# C:\\scenes\\\n" + square + "f 1 2 \\\n 3 \\\r\n4\n") == expected);
    CHECK(faces(square + "f 1 2 3\\\n4\n") == expected);
    CHECK(faces(square + "f 1 2 3 4 \\") == expected);
    CHECK(faces("v +0 -0 0.\nv 1e0 .0 0 1\nv 1.0 10e-1 0 0.1 0.2 0.3\nv 0 1 0\nf 1/1 2//7 3/3/3 4\n") ==
          expected);
    CHECK(faces("o thing\ng a b\ns off\nvt 0 0\nvn 0 0 1\nl 1 2\np 1\n" + square + "f 1 2 3 4\n") ==
          expected);
}

TEST_CASE("obj: numbers arrive as they are written, to rounding") {
    const Scene scene = read("v 549.6 -1.5e3 1e-20\nv 3e38 1e-300 123456789.123\nv 0 1 0\nf 1 2 3\n");
    const auto  close = [](double a, double b) { return std::abs(a - b) <= 1e-15 * std::abs(b); };
    CHECK(close(scene.mesh.vertices[0].x, 549.6));
    CHECK(close(scene.mesh.vertices[0].y, -1.5e3));
    CHECK(close(scene.mesh.vertices[0].z, 1e-20));
    CHECK(close(scene.mesh.vertices[1].x, 3e38));
    CHECK(close(scene.mesh.vertices[1].y, 1e-300));
    CHECK(close(scene.mesh.vertices[1].z, 123456789.123));
}

TEST_CASE("obj: what is no OBJ file is refused") {
    const ScratchFolder folder("obj_folder");
    CHECK_THROWS_WITH(static_cast<void>(read_obj("no/such/file.obj")),
                      "no/such/file.obj: no such file; must be a text file");
    CHECK_THROWS_WITH(static_cast<void>(read_obj("/dev/null")),
                      "/dev/null: is a device or a pipe; must be a text file");
    const std::string path = folder.path.string();
    CHECK_THROWS_WITH(static_cast<void>(read_obj(folder.path)),
                      (path + ": is a directory; must be a text file").c_str());

    CHECK(complaint("") == "test.obj: is empty; must be a text file");
    CHECK(complaint("# nothing\n" + square) == "test.obj: has no faces; must have a line such as f 1 2 3");
    CHECK(complaint(std::string("v 0 0 0\nv \0 0 0\n", 16)) ==
          "test.obj:2: holds the byte 0x00; must be a text file");
    CHECK(complaint("hello world\n") ==
          "test.obj:1: unknown statement 'hello'; must be v, f or another of polygon OBJ");

    Rng         rng{3, 0, 0, 0};
    std::string random;
    for (int i = 0; i < 1000; ++i) random += char(rng.next_u32() & 0xff);
    CHECK(complaint(random) != "");
}

TEST_CASE("obj: a vertex must be three numbers that are finite in float") {
    const std::string rule = " after v; must be a finite number that float can hold, such as -1.5e3";
    for (const std::string bad : {"nan", "inf", "-inf", "1e39", "-1e400", "1e-400", "+-1", "abc", "1,5",
                                  "0x10", "1.5f", "--1", "1e", "."}) {
        CAPTURE(bad);
        CHECK(complaint(square + "v 0 " + bad + " 0\nf 1 2 3\n") == "test.obj:5: '" + bad + "'" + rule);
    }
    CHECK(complaint("v 1 2\nf 1 1 1\n") == "test.obj:1: vertex of 2 numbers; must be x y z");
    CHECK(complaint("v\nf 1 1 1\n") == "test.obj:1: vertex of 0 numbers; must be x y z");
    const std::string endless(100'000, '7');
    CHECK(complaint("v " + endless + " 0 0\nf 1 1 1\n").size() <= 150);
}

TEST_CASE("obj: a face must be three or more vertices that there are") {
    CHECK(complaint(square + "f 1 2 5\n") ==
          "test.obj:5: face corner '5'; must be 1 to 4, the file's vertices");
    CHECK(complaint(square + "f 0 1 2\n") ==
          "test.obj:5: face corner '0'; must be 1 to 4, the file's vertices");
    CHECK(complaint(square + "f 1 2 -5\nv 0 0 0\n") ==
          "test.obj:5: face corner '-5'; must be -1 to -4, counted back over the vertices above");
    CHECK(complaint(square + "f 1 2 99999999999999999999\n") ==
          "test.obj:5: face corner '99999999999999999999'; must be a vertex number such as 7, -1 or 7/1/2");
    CHECK(complaint(square + "f 1 2 x\n") ==
          "test.obj:5: face corner 'x'; must be a vertex number such as 7, -1 or 7/1/2");
    CHECK(complaint(square + "f 1 2 3.5\n") != "");
    CHECK(complaint(square + "f 1 2 /3\n") != "");
    CHECK(complaint(square + "f 1 2 -9223372036854775808\n") != "");
    CHECK(complaint(square + "f 1 \\\n2\n") == "test.obj:5: face of 2 corners; must be 3 or more");
    CHECK(complaint(square + "f\n") == "test.obj:5: face of 0 corners; must be 3 or more");
}

TEST_CASE("obj: a material must be one of an MTL file that is there") {
    CHECK(complaint("mtllib no.mtl\n" + square + "f 1 2 3\n") ==
          "test.obj:1: no file 'no.mtl'; mtllib must name one MTL file, seen from here");
    CHECK(complaint("mtllib\n" + square + "f 1 2 3\n") != "");
    const std::string endless(100'000, 'm');
    CHECK(complaint("mtllib " + endless + "\n" + square + "f 1 2 3\n") != "");
    CHECK(complaint("mtllib paints.mtl\nusemtl rde\n" + square + "f 1 2 3\n") ==
          "test.obj:2: material 'rde'; must be a newmtl of an MTL file that mtllib names");
    CHECK(complaint("usemtl red\n" + square + "f 1 2 3\n") != "");
    CHECK(complaint("mtllib paints.mtl\nusemtl red paint\n" + square + "f 1 2 3\n") ==
          "test.obj:2: usemtl with 2 words after it; must be one name without blanks");
    CHECK(complaint("mtllib paints.mtl\nmtllib paints.mtl\n" + square + "f 1 2 3\n") ==
          "paints.mtl:1: a second material 'red'; names must differ");
}

TEST_CASE("mtl: colours must be possible") {
    CHECK(complaint_of_mtl(paints) == "");
    CHECK(complaint_of_mtl("newmtl a\nillum 2\nNs 10\nmap_Kd wood.png\n") == "");
    CHECK(complaint_of_mtl("") == "test.mtl: is empty; must be a text file");
    CHECK(complaint_of_mtl("newmtl\n") ==
          "test.mtl:1: newmtl with 0 words after it; must be one name without blanks");
    CHECK(complaint_of_mtl("Kd 1 1 1\n") == "test.mtl:1: Kd of no material; must follow newmtl");
    CHECK(complaint_of_mtl("newmtl a\nKd 0.1 0.2\n") ==
          "test.mtl:2: Kd is '0.1 0.2'; must be a reflectance, three numbers from 0 to 1");
    CHECK(complaint_of_mtl("newmtl a\nKd 0.1 0.2 1.1\n") ==
          "test.mtl:2: Kd is '0.1 0.2 1.1'; must be a reflectance, three numbers from 0 to 1");
    CHECK(complaint_of_mtl("newmtl a\nKe 1 -1 1\n") ==
          "test.mtl:2: Ke is '1 -1 1'; must be a radiance, three numbers of 0 or more");
    for (const std::string bad : {"nan", "inf", "1e39", "red"}) {
        CAPTURE(bad);
        CHECK(complaint_of_mtl("newmtl a\nKe 1 1 " + bad + "\n") ==
              "test.mtl:2: '" + bad +
                  "' after Ke; must be a finite number that float can hold, such as -1.5e3");
    }
}

namespace {

/// The first material of an MTL file.
Material material(const std::string& mtl) {
    const ScratchFolder folder("obj_test");
    write(folder, "test.mtl", mtl);
    return read_obj(write(folder, "test.obj", "mtllib test.mtl\n" + square + "f 1 2 3\n")).materials.at(0);
}

template <class L>
bool is(const WeightedLobe<float>& part, Spectrum weight) {
    return std::holds_alternative<L>(part.lobe) && part.weight == weight;
}

}  // namespace

TEST_CASE("mtl: illum chooses between paint, highlights, mirror and glass") {
    for (const std::string illum : {"", "illum 0\n", "illum 1\n", "illum 8\n", "illum 10\n"}) {
        const auto lobes = material("newmtl a\nKs 1 1 1\n" + illum + "Kd 0.5 0.25 0\n").scattering.lobes();
        REQUIRE(lobes.size() == 1);
        CHECK(is<Diffuse<float>>(lobes[0], {0.5F, 0.25F, 0}));
    }
    for (const auto& [Ns, e] : {std::pair{"", 20.0F}, {"Ns 0\n", 0.0F}, {"Ns 96.5\n", 96.5F}}) {
        const auto  paint = material("newmtl a\nKd 0.5 0.25 0\nKs 0.5 0.25 1\nillum 2\n" + std::string(Ns));
        const auto& lobes = paint.scattering.lobes();
        REQUIRE(lobes.size() == 2);
        CHECK(is<Diffuse<float>>(lobes[0], {0.5F, 0.25F, 0}));
        REQUIRE(is<Phong<float>>(lobes[1], {0.5F, 0.25F, 1}));
        CHECK(std::get<Phong<float>>(lobes[1].lobe).exponent() == e);
        CHECK(std::get<Phong<float>>(lobes[1].lobe).greatest_albedo() == 1);
    }
    for (const std::string illum : {"3", "5"}) {
        const auto lobes =
            material("newmtl a\nKd 0.5 0.25 0\nKs 0.5 0.75 1\nillum " + illum).scattering.lobes();
        REQUIRE(lobes.size() == 2);
        CHECK(is<Diffuse<float>>(lobes[0], {0.5F, 0.25F, 0}));
        CHECK(is<Mirror<float>>(lobes[1], {0.5F, 0.75F, 1}));
    }
    for (const std::string illum : {"4", "6", "7", "9"}) {
        for (const auto& [Ni, n] : {std::pair{"", 1.5F}, {"Ni 1.25\n", 1.25F}}) {
            const auto glass = material("newmtl a\n" + std::string(Ni) + "illum " + illum);
            CHECK(glass.is_transparent());
            const auto& lobes = glass.scattering.lobes();
            REQUIRE(lobes.size() == 1);
            REQUIRE(is<Dielectric<float>>(lobes[0], {1, 1, 1}));
            CHECK(std::get<Dielectric<float>>(lobes[0].lobe).index_of_refraction() == n);
        }
    }
}

TEST_CASE(
    "mtl: highlights that reflect more light than there is are weakened with their paint, which is noted") {
    const ScratchFolder folder("obj_test");
    write(folder, "test.mtl",
          "newmtl shiny\nillum 2\nKd 0.75 0.25 0\nKs 0.25 1 0.5\n"
          "newmtl good\nillum 2\nKd 0.75 0.25 0\nKs 0.25 0.75 0.5\n"
          "newmtl paint\nKd 1 1 1\nKs 1 1 1\n");
    const auto               obj = write(folder, "test.obj", "mtllib test.mtl\n" + square + "f 1 2 3\n");
    std::vector<std::string> notes;
    const Scene              scene = read_obj(obj, [&](std::string_view line) { notes.emplace_back(line); });
    CHECK(notes == std::vector{(folder.path / "test.mtl").string() +
                               ":1: material 'shiny' reflects Kd + Ks = 1.25; both are divided by that"});
    const auto& shiny = scene.materials.at(0).scattering.lobes();
    const auto& good  = scene.materials.at(1).scattering.lobes();
    CHECK(shiny.at(0).weight == Spectrum{0.6F, 0.2F, 0});
    CHECK(shiny.at(1).weight == Spectrum{0.2F, 0.8F, 0.4F});
    CHECK(good.at(0).weight == Spectrum{0.75F, 0.25F, 0});
    CHECK(good.at(1).weight == Spectrum{0.25F, 0.75F, 0.5F});
}

TEST_CASE("mtl: mirrors and glass must be possible") {
    CHECK(complaint_of_mtl("newmtl a\nillum 3\nKd 0.5 0.5 0.5\nKs 0.2 0.6 0.2\n") ==
          "test.mtl:1: material 'a' reflects Kd + Ks = 1.1; must be at most 1");
    CHECK(complaint_of_mtl("newmtl a\nKs 1.5 0 0\n") ==
          "test.mtl:2: Ks is '1.5 0 0'; must be a reflectance, three numbers from 0 to 1");
    for (const std::string bad : {"0", "-1.5", "1.5 1.5", "11", "0.0001", ""}) {
        CAPTURE(bad);
        CHECK(complaint_of_mtl("newmtl a\n\nNi " + bad + "\n") ==
              "test.mtl:3: Ni is '" + bad +
                  "'; must be an index of refraction from 0.001 to 10, such as 1.5 for glass");
    }
    for (const std::string bad : {"-1", "1e7", "1 2", ""}) {
        CAPTURE(bad);
        CHECK(complaint_of_mtl("newmtl a\nNs " + bad + "\n") ==
              "test.mtl:2: Ns is '" + bad +
                  "'; must be the exponent of highlights from 0 to 1000000, such as 20");
    }
    for (const std::string bad : {"11", "-1", "2.5", ""}) {
        CAPTURE(bad);
        CHECK(complaint_of_mtl("newmtl a\nillum " + bad + "\n") ==
              "test.mtl:2: illum is '" + bad +
                  "'; must be the number of an illumination model, 0 to 10, such as 4 for glass");
    }
    CHECK(complaint_of_mtl("Ni 1.5\n") == "test.mtl:1: Ni of no material; must follow newmtl");
    CHECK(complaint_of_mtl("newmtl a\nNi nan\n") ==
          "test.mtl:2: 'nan' after Ni; must be a finite number that float can hold, such as -1.5e3");
}

namespace {

bool finite(Spectrum s) {
    return std::isfinite(s.r) && std::isfinite(s.g) && std::isfinite(s.b);
}

bool usable(const Scene& scene) {
    const auto& mesh  = scene.mesh;
    const auto  limit = double(std::numeric_limits<float>::max());
    return !mesh.faces.empty() && scene.material_of_face.size() == mesh.faces.size() &&
           std::all_of(mesh.vertices.begin(), mesh.vertices.end(),
                       [&](const auto& p) {
                           return std::abs(p.x) <= limit && std::abs(p.y) <= limit && std::abs(p.z) <= limit;
                       }) &&
           std::all_of(mesh.faces.begin(), mesh.faces.end(),
                       [&](const auto& face) {
                           return std::all_of(face.begin(), face.end(),
                                              [&](auto i) { return i < mesh.vertices.size(); });
                       }) &&
           std::all_of(scene.material_of_face.begin(), scene.material_of_face.end(),
                       [&](auto i) { return i < scene.materials.size(); }) &&
           std::all_of(scene.materials.begin(), scene.materials.end(),
                       [](const Material& m) { return finite(m.reflectance()) && finite(m.emission); });
}

/// The text with a few bytes changed, put in or taken out; often by bytes that mean something.
std::string mutated(std::string text, Rng& rng) {
    static const std::string meaningful = "0123456789+-.eE/# \t\r\n\\vfnaiKdmtlusgo";
    const auto               below      = [&](std::size_t n) { return rng.next_u32() % std::uint32_t(n); };
    for (std::uint32_t changes = 1 + below(4); changes > 0; --changes) {
        const std::uint32_t kind = below(3);
        const std::size_t   at   = below(text.size());
        const bool          any  = below(4) == 0;
        const char          byte = any ? char(below(256)) : meaningful[below(meaningful.size())];
        if (kind == 0) text[at] = byte;
        if (kind == 1) text.insert(at, 1, byte);
        if (kind == 2 && text.size() > 1) text.erase(at, 1 + below(3));
    }
    return text;
}

}  // namespace

TEST_CASE("obj: a damaged file is either refused or read as something that is usable") {
    const std::string obj = "mtllib m.mtl\no a\n" + square +
                            "v -1.5e-3 2.25 +7.\nusemtl red\nf 1 2 3 4\nusemtl lamp\n"
                            "f -1/2 -2//3 \\\n -3/1/1 # note\nf 1 2 5\n";
    const ScratchFolder folder("obj_fuzz");
    int                 read = 0, refused = 0;
    for (int run = 0; run < 4000; ++run) {
        Rng        rng{1, run, 0, 0};
        const bool of_obj = rng.next_u32() % 4 != 0;
        write(folder, "m.mtl", of_obj ? paints : mutated(paints, rng));
        const auto path = write(folder, "a.obj", of_obj ? mutated(obj, rng) : obj);
        try {
            const Scene scene = read_obj(path);
            if (!usable(scene)) FAIL_CHECK("run " << run);
            ++read;
        } catch (const std::exception& error) {
            const std::string message = error.what();
            if (message.empty() || message.find('\n') != std::string::npos)
                FAIL_CHECK("run " << run << ": " << message);
            ++refused;
        }
    }
    // both happen: the damage is neither harmless nor always fatal
    CHECK(read >= 200);
    CHECK(refused >= 200);
}
