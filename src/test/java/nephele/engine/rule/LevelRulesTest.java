package nephele.engine.rule;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import nephele.engine.level.BadLevel;
import nephele.engine.level.Problem;
import nephele.engine.level.json.LevelFile;
import nephele.engine.level.json.LevelJson;
import nephele.engine.level.json.LevelJsonTest;
import nephele.engine.level.json.NumberText;
import nephele.host.named.LevelCatalogue;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The rules accept what they should; {@link nephele.engine.level.BadRelations} has what they refuse. */
@Execution(ExecutionMode.CONCURRENT)
class LevelRulesTest {
    private static List<Problem> structure(String sections) {
        return LevelRules.checkRecords(LevelJsonTest.sections(sections));
    }

    @Test
    void everyShippedLevelIsFreeOfErrorsAndCanBeSaved() throws IOException {
        List<Path> files;
        try (var levels = Files.walk(Path.of("levels"))) {
            files = levels.filter(LevelCatalogue::isLevel)
                    .filter(file -> !file.toString().contains("replays"))
                    .toList();
        }
        for (Path file : files) {
            LevelFile.Opened opened = LevelFile.load(file);
            assertEquals(
                    List.of(),
                    LevelRules.checkRecords(opened.level()).stream()
                            .filter(Problem::isError)
                            .map(problem -> problem.line(file.toString()))
                            .toList());
            assertEquals(opened.level(), LevelJsonTest.read(LevelJson.write(opened.level())));
        }
        assertTrue(files.size() > 4);
    }

    @Test
    void lightsWhoseShadowsFindNoPlaceAreSaid() {
        assertEquals(List.of(), structure(pointLights(85)));
        List<Problem> problems = structure(pointLights(86));
        assertEquals(1, problems.size());
        String line = problems.get(0).line("f");
        assertTrue(line.startsWith("f: lights[85].castsShadow: warning: at most 85 point lights or 512 spots"), line);
    }

    private static String pointLights(int count) {
        String lights = IntStream.range(0, count)
                .mapToObj(i -> "{\"id\": \"l" + i
                        + "\", \"kind\": \"point\", \"position\": [0, 9, 0], \"radiantIntensity\": [1, 1, 1]}")
                .collect(Collectors.joining(","));
        String box = "\", \"kind\": \"box\", \"size\": [1, 1, 1], \"centre\": [0, ";
        return "\"player\": {\"feet\": [9, 0, 9]}, \"solids\": [{\"id\": \"a" + box + "0, 0]}, {\"id\": \"b" + box
                + "2, 0]}], \"lights\": [" + lights + "]";
    }

    @Test
    void aTechniqueThatCannotShowACloudIsSaid() {
        List<Problem> problems = LevelRules.checkRecords(
                LevelJsonTest.sections("\"player\": {\"feet\": [9, 0, 9]}, \"environment\": {\"clouds\": [{\"id\":"
                        + " \"c\", \"kind\": \"layer\", \"baseAltitudeMetres\": 900, \"thicknessMetres\": 300,"
                        + " \"technique\": \"particles\"}]}"));
        assertEquals(
                List.of("f: environment.clouds[0].technique: warning: an endless layer is not divided into balls and is"
                        + " drawn as a volume: choose the kind volume, or the technique auto"),
                problems.stream().map(problem -> problem.line("f")).toList());
    }

    /** Names with the layout's suffixes in another order are the likeliest mistake that shows no other error. */
    @ParameterizedTest
    @CsvSource({
        "quake2, rt bk lf ft up dn, ''",
        "quake2, ft rt bk lf up dn, 'the files'' names end in ft, rt, bk, lf, up, dn; layout quake2 reads them as rt,'",
        "terragen, left front right back up down, layout terragen reads them as front,",
        "faces, pz nz px nx py ny, layout faces reads them as px,",
        "quake2, a b c d e f, ''",
        "opengl, 1 2 3 4 5 6, ''"
    })
    void namesThatTellAnotherOrderAreDoubted(String layout, String ends, String words) {
        String files = Arrays.stream(ends.split(" "))
                .map(end -> "\"sky/bay_" + end + ".tga\"")
                .collect(Collectors.joining(", "));
        List<Problem> problems = structure("\"environment\": {\"sky\": {\"kind\": \"skybox\", \"layout\": \"" + layout
                + "\", \"files\": [" + files + "]}}");
        List<String> said = problems.stream()
                .filter(problem -> problem.path().equals("environment.sky.files"))
                .map(problem -> problem.line("f"))
                .toList();
        assertEquals(words.isEmpty() ? 0 : 1, said.size(), said.toString());
        assertTrue(
                words.isEmpty()
                        || said.get(0).contains(": warning: ") && said.get(0).contains(words),
                said + "");
    }

    @Test
    void standingOnTheFloorAndTouchingAWallIsFree() {
        String room =
                "\"solids\": [{\"id\": \"floor\", \"kind\": \"box\", \"centre\": [0, -0.5, 0], \"size\": [9, 1, 9]},"
                    + " {\"id\": \"low\", \"kind\": \"box\", \"centre\": [0, 2.3, 0], \"size\": [9, 1, 9]}, {\"id\":"
                    + " \"ramp\", \"kind\": \"wedge\", \"centre\": [2, 1, 0], \"size\": [2, 2, 2], \"rising\":"
                    + " \"+x\"}, {\"id\": \"column\", \"kind\": \"prism\", \"centre\": [-2, 1, 0], \"radiusMetres\":"
                    + " 1, \"heightMetres\": 2}]";
        assertEquals(List.of(), structure("\"player\": {\"feet\": [0, 0, 0]}, " + room));
        assertEquals(1, structure("\"player\": {\"feet\": [-2, 0, 0]}, " + room).size());
        assertEquals(
                1, structure("\"player\": {\"feet\": [2.5, 0, 0]}, " + room).size());
    }

    @Test
    void aPairOfPortalsIsFine() {
        String portal =
                "\"centre\": [0, 0, 0], \"normal\": [0, 0, 1], \"widthMetres\": 1, \"heightMetres\": 2, \"shape\":"
                        + " \"arch\"";
        List<Problem> problems = structure("\"player\": {\"feet\": [0, 0, 0]}, \"portals\": [{\"id\": \"a\","
                + " \"linkedTo\": \"b\", " + portal + "}, {\"id\": \"b\", \"linkedTo\": \"a\", " + portal + "}]");
        assertEquals(List.of(), problems);
    }

    @Test
    void aPortalThatOpensInFreeSpaceIsSaid() {
        String wall = "\"player\": {\"feet\": [0, 0, 5]}, \"solids\": [{\"id\": \"wall\", \"kind\": \"box\","
                + " \"centre\": [0, 2, -0.5], \"size\": [9, 4, 1]}], \"portals\": [";
        String size = ", \"widthMetres\": 1, \"heightMetres\": 2}";
        String a = "{\"id\": \"a\", \"linkedTo\": \"b\", \"centre\": [2, 1, 0], \"normal\": [0, 0, 9]" + size;
        String b = "{\"id\": \"b\", \"linkedTo\": \"a\", \"centre\": [-2, 1, %s], \"normal\": [0, 0, %s]" + size;
        assertEquals(List.of(), paths(wall + a + "," + b.formatted("0.0005", "1") + "]"));
        assertEquals(List.of(), paths(wall + a + "," + b.formatted("-1", "-1") + "]"));
        assertEquals(List.of("portals[1].centre"), paths(wall + a + "," + b.formatted("0.002", "1") + "]"));
        assertEquals(List.of("portals[1].centre"), paths(wall + a + "," + b.formatted("0", "-1") + "]"));
        assertEquals(List.of("portals[1].centre"), paths(wall + a + "," + b.formatted("-0.5", "1") + "]"));
    }

    private static List<String> paths(String sections) {
        return structure(sections).stream().map(Problem::path).toList();
    }

    /** A chain of parents of any length is followed once. */
    @Test
    void aLongChainOfParentsIsFine() {
        StringBuilder models = new StringBuilder();
        for (int i = 9_999; i >= 0; i--) {
            models.append("{\"id\": \"m").append(i).append("\", \"file\": \"a.3d\"");
            models.append(i == 0 ? "}" : ", \"parent\": \"m" + (i - 1) + "\"},");
        }
        assertTrue(structure("\"models\": [" + models + "]").stream().noneMatch(Problem::isError));
    }

    @Test
    void endlessPlanesAreNotWorkedThrough() {
        StringBuilder planes = new StringBuilder(
                "{\"normal\": [0, 1, 0], \"distanceMetres\": 1}," + "{\"normal\": [0, -1, 0], \"distanceMetres\": 1}");
        for (int i = 0; i < 62; i++) {
            double angle = i * Math.PI / 31;
            planes.append(",{\"normal\": [")
                    .append(NumberText.of(StrictMath.cos(angle)))
                    .append(", 0, ")
                    .append(NumberText.of(StrictMath.sin(angle)))
                    .append("], \"distanceMetres\": 1}");
        }
        StringBuilder solids = new StringBuilder();
        for (int i = 0; i < 400; i++) {
            solids.append(i == 0 ? "" : ",")
                    .append("{\"id\": \"s")
                    .append(i)
                    .append("\", \"kind\": \"planes\", \"planes\": [");
            solids.append(planes).append("]}");
        }
        List<Problem> problems = structure("\"player\": {\"feet\": [9, 0, 9]}, \"solids\": [" + solids + "]");
        assertEquals(1, problems.size());
        assertTrue(problems.get(0).message().contains("are not checked"));
    }

    /** Planes that enclose nothing contain the player, too; that is no second problem. */
    @Test
    void noPlanesAreOneProblem() {
        String planes =
                "\"player\": {\"feet\": [0, 0, 0]}, \"solids\": [{\"id\": \"a\", \"kind\": \"planes\", \"planes\":"
                        + " [%s]}]";
        assertEquals(List.of("solids[0]"), paths(planes.formatted("")));
        String five = "{\"normal\": [0, 1, 0], \"distanceMetres\": 5},".repeat(5);
        assertEquals(List.of("solids[0]"), paths(planes.formatted(five.substring(0, five.length() - 1))));
    }

    /** Errors of structure and unknown materials are reported together. */
    @Test
    void unknownMaterialsAreToldBesideErrorsOfShape() {
        String sections =
                "\"materials\": [{\"id\": \"known\", \"roughness\": -1}], \"solids\": [{\"id\": \"a\", \"kind\":"
                        + " \"box\", \"material\": \"known\", \"centre\": [0, 0, 0], \"size\": [1, 1, 0], \"faces\":"
                        + " {\"+y\": {\"material\": \"no\"}}}, {\"id\": \"b\", \"kind\": \"planes\", \"material\":"
                        + " \"none\", \"planes\": [{\"normal\": [0, 1, 0], \"distanceMetres\": 0, \"material\":"
                        + " \"nix\"}]}]";
        List<Problem> problems = LevelJsonTest.problems(BadLevel.wrap(sections));
        assertEquals(
                List.of(
                        "materials[0].roughness",
                        "solids[0].size[2]",
                        "solids[0].faces.+y.material",
                        "solids[1].material",
                        "solids[1].planes[0].material"),
                problems.stream().map(Problem::path).toList());
        assertEquals(
                "there is no material 'nix': add it to materials",
                problems.get(4).message());
    }

    @Test
    void aNameOfMegabytesIsShortened() {
        String wedge = "\"solids\": [{\"id\": \"w\", \"kind\": \"wedge\", \"centre\": [0, 0, 0], \"size\": [1, 1, 1],"
                + " \"rising\": \"+x\", \"faces\": {\"%s\": {\"material\": \"x\"}}}]";
        List<Problem> problems = structure(wedge.formatted("q".repeat(5_000_000)));
        assertEquals(3, problems.size());
        assertTrue(problems.stream().allMatch(problem -> problem.line("f").length() < 1000));
    }
}
