package nephele.app.corpus;

import static nephele.app.corpus.OddLevel.bare;
import static nephele.app.corpus.OddLevel.body;
import static nephele.app.corpus.OddLevel.box;
import static nephele.app.corpus.OddLevel.floorAnd;
import static nephele.app.corpus.OddLevel.many;
import static nephele.app.corpus.OddLevel.portal;
import static nephele.app.corpus.OddLevel.seen;
import static nephele.app.corpus.OddLevel.solids;
import static nephele.app.corpus.OddLevel.vector;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import nephele.engine.asset.SamplePictures;

/** Levels at the limits of the file format; {@code check} accepts some of them and rejects the others. */
final class OddLevels {
    private static final String AHEAD = "\"normal\": [0, 0, 1], \"widthMetres\": 1, \"heightMetres\": 2";
    private static final String BACK = "\"normal\": [0, 0, -1], \"widthMetres\": 1, \"heightMetres\": 2";
    private static final String WALL = box("wall", "[0, 2, -0.5]", "[6, 4, 1]");
    private static final String BEHIND = box("behind", "[0, 2, 9.5]", "[6, 4, 1]");

    private OddLevels() {}

    /** Writes all levels, and the assets that they name, into a folder. Returns the levels' file names. */
    static List<String> write(Path folder) throws IOException {
        Files.write(folder.resolve("pixel.png"), SamplePictures.png(1, 1, 8, 2, 1));
        Files.write(folder.resolve("wide.png"), SamplePictures.png(5, 2, 16, 2, 1));
        Files.write(folder.resolve("grey.png"), SamplePictures.png(3, 3, 8, 0, 1));
        OddModels.write(folder);
        List<String> files = new ArrayList<>();
        for (OddLevel level : all()) {
            String file = level.name().replace(",", "").replace(' ', '-') + ".json";
            Files.writeString(folder.resolve(file), level.text());
            files.add(file);
        }
        return files;
    }

    private static List<OddLevel> all() {
        return Stream.of(views(), shapes(), Crowds.ALL, lights(), portals(), bodies(), OddModels.ALL, pictures())
                .flatMap(List::stream)
                .toList();
    }

    private static List<OddLevel> views() {
        return List.of(
                bare("nothing", ""),
                bare("only a player", "\"player\": {\"feet\": [0, 0, 0]}"),
                bare("only a camera", OddLevel.CAMERA),
                seen("a player at the end of the world", "\"player\": {\"feet\": [1e7, 1e7, -1e7]}"),
                seen(
                        "a camera at the end of the world",
                        floorAnd("")
                                + ", \"cameras\": [{\"id\": \"c\", \"position\": [1e7, 0, 0], \"target\": [0, 0, 0]}]"),
                seen(
                        "a camera that looks along its up",
                        floorAnd("")
                                + ", \"cameras\": [{\"id\": \"c\", \"position\": [0, 9, 0], \"target\": [0, 0, 0]}]"),
                seen(
                        "a camera in a solid that sees nearly half of everything",
                        floorAnd("") + ", \"cameras\": [{\"id\": \"c\", \"position\": [0, -0.5, 0], \"target\":"
                                + " [1, -0.5, 0], \"horizontalFovDegrees\": 170, \"nearMetres\": 0.001}]"));
    }

    private static List<OddLevel> shapes() {
        return List.of(
                solids("the world in a box", box("world", "[0, 0, 0]", "[1e7, 1e7, 1e7]")),
                solids(
                        "a grain, a plate, a needle, a blade, and boxes in one place",
                        box("grain", "[0, 1, 0]", "[1e-4, 1e-4, 1e-4]") + ", "
                                + box("plate", "[0, 9, 0]", "[1e7, 1e-4, 1e7]") + ", "
                                + many(100, i -> box("b" + i, "[2, 1, 0]", "[1, 2, 1]")) + ", "
                                + many(40, i -> box("f" + i, vector(0.1 * i - 7, 0.5, 0), "[1, 1, 1]")) + ", "
                                + prism("n", "[0, 5, 0]", 10) + ", {\"id\": \"w\", \"kind\": \"wedge\", \"centre\":"
                                + " [0, 1, -3], \"size\": [1e4, 1e-4, 1], \"rising\": \"+x\"}"),
                solids("a needle of 10 km with 62 sides", prism("p", "[0, 0, -2]", 10_000)),
                solids(
                        "planes twice, and planes that touch in a corner",
                        "{\"id\": \"p\", \"kind\": \"planes\", \"planes\": [" + many(2, i -> planes())
                                + "]}, {\"id\": \"q\", \"kind\": \"planes\", \"planes\": [" + planes()
                                + ", {\"normal\": [1, 1, 1], \"distanceMetres\": 1.7320508}]}"));
    }

    private static String prism(String id, String centre, int heightMetres) {
        return "{\"id\": \"" + id + "\", \"kind\": \"prism\", \"centre\": " + centre
                + ", \"radiusMetres\": 0.001, \"heightMetres\": " + heightMetres + ", \"sides\": 62}";
    }

    /** The faces of a cube of 2 m around the origin. */
    private static String planes() {
        return Stream.of("[1, 0, 0]", "[-1, 0, 0]", "[0, 1, 0]", "[0, -1, 0]", "[0, 0, 1]", "[0, 0, -1]")
                .map(normal -> "{\"normal\": " + normal + ", \"distanceMetres\": 1}")
                .reduce((a, b) -> a + ", " + b)
                .orElseThrow();
    }

    private static List<OddLevel> lights() {
        return List.of(
                seen(
                        "lamps in solids and at one place, and spots of no and of full width",
                        floorAnd("") + ", \"lights\": ["
                                + many(
                                        20,
                                        i -> "{\"id\": \"l" + i + "\", \"kind\": \"point\", \"position\": [0, -0.5, 0],"
                                                + " \"radiantIntensity\": [1e9, 0, 0], \"rangeMetres\": 1e7}")
                                + ", " + spot("a", 0, 0.1) + ", " + spot("b", 90, 90) + ", " + spot("c", 0, 90) + "]"),
                seen(
                        "the brightest everything",
                        floorAnd("") + ", \"environment\": {\"exposureStops\": 32, \"ambient\": [1e9, 1e9, 1e9],"
                                + " \"sky\": {\"kind\": \"gradient\", \"zenith\": [1e9, 0, 0], \"horizon\": [0,"
                                + " 1e9, 0]}, \"fog\": {\"extinctionPerMetre\": 1e3, \"radiance\": [1e9, 1e9,"
                                + " 1e9]}, \"sun\": {\"directionTowardsSun\": [1e-8, -1, 0], \"irradiance\":"
                                + " [1e6, 1e6, 1e6]}}"),
                seen(
                        "clouds and an atmosphere",
                        "\"environment\": {\"sky\": {\"kind\": \"atmosphere\"}, \"clouds\": [{\"id\": \"c\", \"kind\":"
                                + " \"layer\", \"baseAltitudeMetres\": 1, \"thicknessMetres\": 1}]}"));
    }

    private static String spot(String id, double inner, double outer) {
        return "{\"id\": \"" + id + "\", \"kind\": \"spot\", \"position\": [0, 3, 0], \"direction\": [0, -1e-3, 0],"
                + " \"radiantIntensity\": [9, 9, 9], \"innerConeDegrees\": " + inner + ", \"outerConeDegrees\": "
                + outer + "}";
    }

    private static String pair(String id, String centreA, String measuresA, String centreB, String measuresB) {
        return portal(id, id + "'", centreA, measuresA) + ", " + portal(id + "'", id, centreB, measuresB);
    }

    private static List<OddLevel> portals() {
        String tiny = ", \"widthMetres\": 0.01, \"heightMetres\": 0.01";
        String huge = ", \"widthMetres\": 1e4, \"heightMetres\": 1e4, \"shape\": \"ellipse\"";
        String plate = box("plate", "[-2, 1, 0.1]", "[1.5, 2, 0.2]");
        return List.of(
                seen(
                        "portals on each other, over an edge, behind a solid, below the floor",
                        floorAnd(WALL + ", " + BEHIND + ", " + plate) + ", \"portals\": ["
                                + pair("on", "[0, 1.1, 0]", AHEAD, "[0.2, 1.1, 0]", AHEAD) + ", "
                                + pair("over", "[3, 1.1, 0]", AHEAD, "[0, 1.1, 9]", BACK) + ", "
                                + pair("behind", "[-2, 1.1, 0]", AHEAD, "[2, 1.1, 9]", BACK) + ", "
                                + pair("below", "[0, -0.5, 0]", AHEAD, "[-2, 1.1, 9]", BACK) + "]"),
                seen(
                        "portals in the air, touching, tiny, huge, a world apart",
                        floorAnd("") + ", \"portals\": ["
                                + pair("air", "[0, 1.1, 0]", AHEAD, "[0, 1.1, 0]", BACK) + ", "
                                + pair("touch", "[2, 1.1, 0]", AHEAD, "[2, 1.1, 1e-3]", BACK) + ", "
                                + pair(
                                        "tiny",
                                        "[0, 1.1, 1]",
                                        "\"normal\": [0, 0, 1]" + tiny,
                                        "[0, 1, 9]",
                                        "\"normal\": [0, 0, -1]" + tiny)
                                + ", "
                                + pair(
                                        "huge",
                                        "[0, 0, -9e6]",
                                        "\"normal\": [0, 0, 1]" + huge,
                                        "[0, 0, 9e6]",
                                        "\"normal\": [0, 0, -1]" + huge)
                                + "]"));
    }

    private static OddLevel bodies(String name, String bodies) {
        return seen(name, floorAnd("") + ", \"bodies\": [" + bodies + "]");
    }

    private static List<OddLevel> bodies() {
        String capsule = "{\"id\": \"c\", \"kind\": \"capsule\", \"centre\": [2, 1, 0], \"radiusMetres\": 0.2,"
                + " \"heightMetres\": 0.4, \"massKilograms\": 1, \"friction\": 10, \"restitution\": 1}";
        return List.of(
                bodies(
                        "a grain under a tonne, a round capsule, and a body at the end of the world",
                        body("grain", "[0, 5e-5, 0]", "[1e-4, 1e-4, 1e-4]", "1e-6") + ", "
                                + body("tonne", "[0, 0.6, 0]", "[1, 1, 1]", "1e7") + ", " + capsule + ", "
                                + body("far", "[1e7, 1e7, 1e7]", "[1, 1, 1]", "1")),
                bodies("a body larger than the level", body("b", "[0, 500, -600]", "[1e3, 1e3, 1e3]", "1e7")),
                bodies("a body in the floor", body("b", "[0, 0.4, 0]", "[1, 1, 1]", "1")),
                bodies("a body in the player", body("b", "[0, 1, 4]", "[1, 1, 1]", "1")),
                bodies("bodies in each other", many(2, i -> body("b" + i, "[0, 1, 0]", "[1, 1, 1]", "1"))),
                bodies(
                        "two hundred boxes a millimetre apart around the player",
                        many(200, i -> body("b" + i, around(i), "[0.2, 0.2, 0.2]", "1"))));
    }

    /** Returns the centre of a box in a grid of 20.1 cm, with room for the player in the grid's middle. */
    private static String around(int box) {
        int column = box % 50 % 7;
        int row = box % 50 / 7;
        boolean isFree = Math.abs(column - 3) <= 1 && Math.abs(row - 3) <= 1;
        double x = isFree ? 2 + 0.201 * column : 0.201 * (column - 3);
        return vector(x, 0.101 + 0.201 * (box / 50), 4 + 0.201 * (row - 3));
    }

    private static List<OddLevel> pictures() {
        String pixel = many(6, i -> "\"pixel.png\"");
        return List.of(
                seen(
                        "a skybox of six pixels",
                        "\"environment\": {\"sky\": {\"kind\": \"skybox\", \"files\": [" + pixel + "]}}"),
                seen(
                        "a skybox of one wide picture",
                        floorAnd("") + ", \"environment\": {\"sky\": {\"kind\": \"skybox\"," + " \"files\": ["
                                + pixel.replaceFirst("pixel", "wide") + "]}}"),
                seen(
                        "a cross that is none",
                        floorAnd("") + ", \"environment\": {\"sky\": {\"kind\": \"skybox\","
                                + " \"layout\": \"cross\", \"files\": [\"wide.png\"]}}"),
                seen(
                        "a material of odd pictures",
                        floorAnd("").replace("\"kind\"", "\"material\": \"m\", \"kind\"")
                                + ", \"materials\": [{\"id\": \"m\", \"texture\": \"wide.png\", \"normalTexture\":"
                                + " \"grey.png\", \"roughness\": 0, \"metallic\": 1}]"));
    }
}
