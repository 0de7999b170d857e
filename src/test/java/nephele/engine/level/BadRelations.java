package nephele.engine.level;

import static nephele.engine.level.BadLevel.level;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/**
 * Values that are valid alone and contradict each other, geometry that encloses nothing, and invalid assets. A rotation
 * in a file is an axis and an angle; one without an axis is refused.
 */
final class BadRelations {
    private static final String BOX = "\"kind\": \"box\", \"centre\": [0, 0, 0], \"size\": [4, 4, 4]";

    static final List<BadLevel> ALL = List.of(
            level(
                    "solids[1].id",
                    "already the id",
                    "\"solids\": [{\"id\": \"a\", " + BOX + "}, {\"id\": \"a\", " + BOX + "}]"),
            level(
                    "emitters[1].id",
                    "give it another",
                    "\"emitters\": [" + emitter("smoke", "[1, 1, 1]", "1") + ", " + emitter("fire", "[1, 1, 1]", "1")
                            + "]"),
            level(
                    "emitters[0].ratePerSecond",
                    "at most 200000 particles at once: lower the rates",
                    "\"emitters\": [" + emitter("snow", "[9, 99, 9]", "9000") + "]"),
            level(
                    "emitters[0].repeatSeconds",
                    "an explosion lasts 4.5 s: repeat it later, or give 0",
                    "\"emitters\": [" + emitter("explosion", "[1, 1, 1]", "9, \"repeatSeconds\": 2") + "]"),
            level(
                    "environment.lightning.groundAltitudeMetres",
                    "lower it, raise centre, or give groundShare 0",
                    "\"environment\": {\"lightning\": {\"strikesPerMinute\": 6, \"centre\": [0, 100, 0], \"size\":"
                            + " [9, 90, 9], \"groundAltitudeMetres\": 60}}"),
            level("materials[1].id", "already the id", "\"materials\": [{\"id\": \"m\"}, {\"id\": \"m\"}]"),
            level(
                    "solids[0].material",
                    "no material",
                    "\"solids\": [{\"id\": \"a\", \"material\": \"m\", " + BOX + "}]"),
            level(
                    "solids[0].faces.+y.material",
                    "no material",
                    "\"solids\": [{\"id\": \"a\", " + BOX + ", \"faces\": {\"+y\": {\"material\": \"m\"}}}]"),
            level(
                    "solids[0].planes[3].material",
                    "no material",
                    planes(tetrahedron().replace("[1, 1, 1]}", "[1, 1, 1], \"material\": \"m\"}"))),
            level(
                    "player.feet",
                    "starts inside",
                    "\"player\": {\"feet\": [0, 0, 0]}, \"solids\": [{\"id\": \"a\", " + BOX + "}]"),
            level("player.feet", "starts inside", "\"player\": {\"feet\": [0, -0.5, 0]}, " + planes(tetrahedron())),
            level(
                    "solids[0]",
                    "too thin for its size",
                    planes(String.join(
                            ",",
                            plane(1, 0, 0, 1e-7),
                            plane(-1, 0, 0, 1e-7),
                            plane(0, 1, 0, 5000),
                            plane(0, -1, 0, 5000),
                            plane(0, 0, 1, 1e-7),
                            plane(0, 0, -1, 1e-7)))),
            level("solids[0]", "4 to 64 planes", planes(plane(1, 0, 0, 1))),
            level(
                    "solids[0]",
                    "enclose no volume",
                    planes(String.join(
                            ",",
                            plane(1, 0, 0, 1),
                            plane(-1, 0, 0, 1),
                            plane(0, 1, 0, 1),
                            plane(0, -1, 0, 1),
                            plane(0, 0, 1, 1)))),
            level(
                    "solids[0]",
                    "enclose no volume",
                    planes(String.join(
                            ",",
                            plane(1, 0, 0, -1),
                            plane(-1, 0, 0, -1),
                            plane(0, 1, 0, 1),
                            plane(0, -1, 0, 1),
                            plane(0, 0, 1, 1),
                            plane(0, 0, -1, 1)))),
            level("solids[0].planes", "at most 64", planes(BadLevel.repeated(plane(1, 0, 0, 1), 65))),
            level("solids[0].planes[0].normal", "no length", planes(plane(0, 0, 0, 1) + "," + tetrahedron())),
            level("solids[0]", "horizontal side", wedge("+y", "{}")),
            level("solids[0].faces.+y", "no such face", wedge("+x", "{\"+y\": {}}")),
            prism("side 5", "{}", "", "no such face"),
            prism("side 01", "{}", "", "no such face"),
            prism("+x", "{}", "", "side 0 to side 4 are known"),
            prism("side 4", "{\"material\": \"wood\"}", ".material", "no material 'wood'"),
            prism("+y", "{\"texture\": {\"scaleU\": 0}}", ".texture.scaleU", "or from 0.001 to 10000, not 0"),
            prism("+y", "{\"texture\": {\"scaleV\": -0.0009}}", ".texture.scaleV", "from -10000 to -0.001 or"),
            level(
                    "solids[0].faces.slope.texture.scaleV",
                    "from 0.001 to 10000",
                    wedge("+x", "{\"slope\": {\"texture\": {\"scaleV\": 0}}}")),
            level(
                    "solids[0].planes[4].texture.scaleU",
                    "from 0.001 to 10000",
                    planes(tetrahedron() + ", {\"distanceMetres\": 9, \"normal\": [0, 1, 0],"
                            + " \"texture\": {\"scaleU\": -0}}")),
            level("lights[0].innerConeDegrees", "outerConeDegrees", spot("[0, -1, 0]", ", \"innerConeDegrees\": 50")),
            level("lights[0].direction", "no length", spot("[0, 0, 0]", "")),
            level(
                    "environment.sun.directionTowardsSun",
                    "no length",
                    "\"environment\": {\"sun\": {\"directionTowardsSun\": [0, 0, 0], \"irradiance\": [1, 1, 1]}}"),
            level(
                    "environment.sun.directionTowardsSun",
                    "write a direction",
                    "\"environment\": {\"sun\": {\"irradiance\": [1, 1, 1]}}"),
            camera("target", "[0, 0, 0]", "equals position"),
            camera("up", "[0, 0, 0]", "no length"),
            camera("farMetres", "0.01", "larger than nearMetres"),
            camera("verticalFovDegrees", "30, \"horizontalFovDegrees\": 30", "given already"),
            level(
                    "cameras[0].path[0].target",
                    "equals position",
                    "\"cameras\": [{\"id\": \"c\", \"position\": [0, 0, 0], \"target\": [0, 0, 1], \"path\":"
                            + " [{\"position\": [1, 1, 1], \"target\": [1, 1, 1]}]}]"),
            level("portals[0].linkedTo", "no portal", "\"portals\": [" + portal("a", "b", 1) + "]"),
            level("portals[0].linkedTo", "to itself", "\"portals\": [" + portal("a", "a", 1) + "]"),
            level(
                    "portals[0].linkedTo",
                    "name each other",
                    "\"portals\": [" + portal("a", "b", 1) + "," + portal("b", "c", 1) + "," + portal("c", "a", 1)
                            + "]"),
            level(
                    "portals[0].widthMetres",
                    "do not scale",
                    "\"portals\": [" + portal("a", "b", 1) + "," + portal("b", "a", 2) + "]"),
            level(
                    "portals[0].shape",
                    "has to come out",
                    "\"portals\": [" + portal("a", "b", 1).replace("}", ", \"shape\": \"ellipse\"}") + ","
                            + portal("b", "a", 1) + "]"),
            level("portals", "a level may have 64", "\"portals\": [" + portals(66) + "]"),
            level("portals", "62 and a gun's two", "\"portalGun\": {}, \"portals\": [" + portals(64) + "]"),
            level(
                    "portals[0].up",
                    "along the normal",
                    "\"portals\": [" + portal("a", "b", 1).replace("[0, 0, 1]", "[0, 1, 0]") + "," + portal("b", "a", 1)
                            + "]"),
            level("models[0].parent", "no model", "\"models\": [" + model("a", "b", "") + "]"),
            level("models[0].parent", "below itself", "\"models\": [" + model("a", "a", "") + "]"),
            level("models[0].parent", "below itself", "\"models\": [" + chain() + "]"),
            level(
                    "models[0].transform[0].axis",
                    "no length",
                    "\"models\": ["
                            + model("a", null, "{\"kind\": \"rotate\", \"axis\": [0, 0, 0], \"angleDegrees\": 90}")
                            + "]"),
            level(
                    "models[0].transform[0].by[1]",
                    "or from 1e-9 to 10000000, not",
                    "\"models\": [" + model("a", null, "{\"kind\": \"scale\", \"by\": [1, 0, 1]}") + "]"),
            level(
                    "models[0].transform[0].by[1]",
                    "or from 1e-9 to 10000000, not",
                    "\"models\": [" + model("a", null, "{\"kind\": \"scale\", \"by\": [1, 1e-30, 1]}") + "]"),
            level("models[0].file", "no such file", "\"models\": [" + model("a", null, "") + "]"),
            level(
                    "environment.sky.files",
                    "needs 6 files",
                    "\"environment\": {\"sky\": {\"kind\": \"skybox\", \"files\": [\"real.png\"]}}"),
            level(
                    "environment.sky.files",
                    "needs 1 files",
                    "\"environment\": {\"sky\": {\"kind\": \"skybox\", \"layout\": \"cross\", \"files\": []}}"),
            level(
                    "environment.sky.files",
                    "needs 6 files, not 1; list them in the order rt, bk, lf, ft, up, dn",
                    "\"environment\": {\"sky\": {\"kind\": \"skybox\", \"layout\": \"quake2\", \"files\":"
                            + " [\"sky/miramar\"]}}"),
            skybox("opengl", "[5]", "here 4", "real", "real", "real", "real", "real", "large"),
            skybox("quake2", "[1]", "is 8 x 4 pixels", "real", "wide", "real", "real", "real", "real"),
            skybox("terragen", "[0]", "squares of one size", "wide", "wide", "wide", "wide", "wide", "wide"),
            skybox("faces", "[1]", "is 8 x 4 pixels", "real", "wide", "real", "real", "real", "real"),
            skybox("faces", "[0]", "squares of one size", "wide", "wide", "wide", "wide", "wide", "wide"),
            skybox("faces", "[5]", "here 4", "real", "real", "real", "real", "real", "large"),
            skybox("cross", "[0]", "four columns and three rows", "real"),
            level(
                    "environment.clouds[0].density.file",
                    "no such file",
                    "\"environment\": {\"clouds\": [{\"id\": \"c\", \"kind\": \"layer\", \"baseAltitudeMetres\": 1,"
                            + " \"thicknessMetres\": 1, \"density\": {\"kind\": \"grid\", \"file\": \"no.vol\"}}]}"),
            new BadLevel(
                    "a generated mesh too large for a level",
                    "models[0].file",
                    "stands for 4194304 triangles",
                    () -> BadLevel.wrap("\"models\": [" + model("a", null, "").replace("no.3d", "bezier_256.3d") + "]")
                            .getBytes(StandardCharsets.UTF_8)),
            texture("run.tga", "damaged"),
            texture("short-run.tga", "damaged"),
            texture("palette.tga", "damaged"),
            texture("palette-run.tga", "damaged"),
            texture("../real.png", "'..'"),
            texture("/etc/passwd", "starts"),
            texture("a/../../x", "'..'"),
            texture("..\\\\..\\\\x", "U+005C"),
            texture("C:/x", "U+003A"),
            texture("con", "device name"),
            texture("%2e%2e/x", "U+0025"),
            texture("http://x/y", "U+003A"),
            texture("missing.png", "no such file"),
            texture("folder", "no such file"),
            texture("loop.png", "loop.png: "),
            texture("outside.png", "leads out of"),
            texture("bomb.png", "claims 100000"),
            texture("thin.png", "pixels in"),
            texture("zero.png", "has no pixels"),
            texture("sum.png", "damaged"),
            texture("cut.png", "damaged"),
            texture("text.png", "is not a picture"),
            texture("empty.png", "is not a picture"),
            texture("cut.tga", "cut off"),
            texture("wide.tga", "claims 65535"));

    private BadRelations() {}

    private static BadLevel skybox(String layout, String file, String words, String... names) {
        String files = Arrays.stream(names).map(name -> "\"" + name + ".png\"").collect(Collectors.joining(","));
        BadLevel bad = level(
                "environment.sky.files" + file,
                words,
                "\"environment\": {\"sky\": {\"kind\": \"skybox\", \"layout\": \"" + layout + "\", \"files\": [" + files
                        + "]}}");
        return new BadLevel("skybox " + layout + " of " + String.join(" ", names), bad.path(), words, bad.content());
    }

    private static String emitter(String kind, String size, String rate) {
        return "{\"id\": \"e\", \"kind\": \"" + kind + "\", \"centre\": [0, 0, 0], \"size\": " + size
                + ", \"ratePerSecond\": " + rate + "}";
    }

    private static String plane(int x, int y, int z, double distance) {
        return "{\"normal\": [" + x + ", " + y + ", " + z + "], \"distanceMetres\": " + distance + "}";
    }

    private static String tetrahedron() {
        return String.join(
                ",",
                plane(-1, 0, 0, 1),
                plane(0, -1, 0, 1),
                plane(0, 0, -1, 1),
                "{\"distanceMetres\": 1, \"normal\": [1, 1, 1]}");
    }

    private static String planes(String planes) {
        return "\"solids\": [{\"id\": \"a\", \"kind\": \"planes\", \"planes\": [" + planes + "]}]";
    }

    /** Returns a prism of five sides that says something of one face. */
    private static BadLevel prism(String face, String said, String member, String words) {
        return level(
                "solids[0].faces." + face + member,
                words,
                "\"solids\": [{\"id\": \"p\", \"kind\": \"prism\", \"centre\": [0, 0, 0], \"radiusMetres\": 1,"
                        + " \"heightMetres\": 1, \"sides\": 5, \"faces\": {\"" + face + "\": " + said + "}}]");
    }

    private static String wedge(String rising, String faces) {
        return "\"solids\": [{\"id\": \"w\", \"kind\": \"wedge\", \"centre\": [0, 0, 0], \"size\": [1, 1, 1],"
                + " \"rising\": \""
                + rising + "\", \"faces\": " + faces + "}]";
    }

    private static String spot(String direction, String more) {
        return "\"lights\": [{\"id\": \"l\", \"kind\": \"spot\", \"position\": [0, 0, 0], \"radiantIntensity\": [1, 1,"
                + " 1], \"direction\": " + direction + more + "}]";
    }

    private static BadLevel camera(String key, String value, String words) {
        String target = key.equals("target") ? "" : "\"target\": [0, 0, 1], ";
        return level(
                "cameras[0]." + key,
                words,
                "\"cameras\": [{\"id\": \"c\", \"position\": [0, 0, 0], " + target + "\"" + key + "\": " + value
                        + "}]");
    }

    private static String portals(int count) {
        return IntStream.range(0, count)
                .mapToObj(i -> portal("p" + i, "p" + (i ^ 1), 1))
                .collect(Collectors.joining(","));
    }

    private static String portal(String id, String linkedTo, int width) {
        return "{\"id\": \"" + id + "\", \"linkedTo\": \"" + linkedTo
                + "\", \"centre\": [0, 0, 0], \"normal\": [0, 0, 1]," + " \"widthMetres\": " + width
                + ", \"heightMetres\": 2}";
    }

    private static String model(String id, String parent, String step) {
        return "{\"id\": \"" + id + "\", \"file\": \"no.3d\", "
                + (parent == null ? "" : "\"parent\": \"" + parent + "\", ") + "\"transform\": [" + step + "]}";
    }

    /** Returns ten thousand models, each a child of the next, the last a child of the first. */
    private static String chain() {
        return IntStream.range(0, 10_000)
                .mapToObj(i -> model("m" + i, "m" + (i + 1) % 10_000, ""))
                .collect(Collectors.joining(","));
    }

    private static BadLevel texture(String id, String words) {
        BadLevel bad =
                level("materials[0].texture", words, "\"materials\": [{\"id\": \"m\", \"texture\": \"" + id + "\"}]");
        return new BadLevel("texture " + id, bad.path(), words, bad.content());
    }
}
