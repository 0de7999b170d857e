package nephele.editor.problem;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import nephele.editor.document.NoteEdits;
import nephele.editor.pane.Mark;
import nephele.editor.record.EntityRef;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Cloud;
import nephele.engine.level.Level;
import nephele.engine.level.json.LevelFile;
import nephele.engine.level.json.LevelJson;
import nephele.engine.level.placed.NoFiles;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Problems have a place, an entity, a lasting name, and remedies that remove them and make no others. */
@Execution(ExecutionMode.CONCURRENT)
class ProblemSearchTest {
    private static final String WALLS = box("floor", "0, -0.5, 0", "10, 1, 10", "") + ","
            + box("roof", "0, 3.5, 0", "10, 1, 10", "") + "," + box("west", "-4.5, 1.5, 0", "1, 3, 10", "") + ","
            + box("east", "4.5, 1.5, 0", "1, 3, 10", "") + "," + box("south", "0, 1.5, 4.5", "8, 3, 1", "") + ","
            + box("north", "0, 1.5, -4.5", "8, 3, 1", "");

    private static final String START = ", \"player\": {\"feet\": [0, 0, 0]}";
    private static final String EXIT = ", \"exits\": [{\"id\": \"e\", \"feet\": [3, 0, 3]}]";
    private static final String RED = ", \"material\": \"red\"";

    private static String box(String id, String centre, String size, String more) {
        return "{\"id\": \"" + id + "\", \"kind\": \"box\", \"centre\": [" + centre + "], \"size\": [" + size + "]"
                + more + "}";
    }

    private static Level level(String moreSolids, String sections) {
        String solids = moreSolids.isEmpty() ? WALLS : WALLS + "," + moreSolids;
        return read("\"materials\": [{\"id\": \"red\"}], \"solids\": [" + solids + "]" + sections);
    }

    private static Level read(String members) {
        String json = "{\"format\": \"nephele-level\", \"version\": 1, " + members + "}";
        return LevelJson.read("test.json", json.getBytes(StandardCharsets.UTF_8));
    }

    private static List<LevelProblem> problems(Level level) {
        return ProblemSearch.of(level, NoFiles.AT_ALL);
    }

    private static List<String> keys(Level level) {
        return problems(level).stream().map(LevelProblem::key).toList();
    }

    /** A level with exactly one problem: its key, and the level's parts. */
    private static LevelProblem only(String moreSolids, String sections) {
        List<LevelProblem> found = problems(level(moreSolids, sections + EXIT));
        assertEquals(1, found.size(), found.toString());
        return found.get(0);
    }

    @Test
    void aGoodLevelHasNone() {
        assertEquals(List.of(), keys(level("", START + EXIT)));
    }

    private static final String BODY = ", \"bodies\": [{\"id\": \"cube\", \"kind\": \"box\", \"centre\": [%s],"
            + " \"size\": [0.5, 0.5, 0.5], \"massKilograms\": 5}]";
    private static final String LIGHT = ", \"lights\": [{\"id\": \"lamp\", \"kind\": \"point\", \"position\": [%s],"
            + " \"radiantIntensity\": [1, 1, 1], \"rangeMetres\": 0.5}]";

    private static String solids(String kind) {
        return switch (kind) {
            case "duplicate" -> box("floor", "0, 0.5, 2", "1, 1, 1", "");
            case "material" -> box("crate", "0, 0.5, 2", "1, 1, 1", ", \"material\": \"blue\"");
            case "inside" -> box("crate", "0, -0.5, 2", "0.5, 0.5, 0.5", "");
            case "thin" -> box("crate", "0, 0.5, 2", "0.5, 0.5, 0.0005", "");
            case "fight" -> box("rug", "0, -0.6, 2", "1, 1.2, 1", RED);
            case "small" -> box("panel", "0, 0.5, 2", "1, 1, 1", ", \"faces\": {\"-z\": {\"portalable\": true}}");
            case "tiles" ->
                box("panel", "0, 0.5, 2", "1, 1, 1", ", \"faces\": {\"-z\": {\"portalable\": true}}") + ","
                        + box("panel2", "1, 0.5, 2", "1, 1, 1", ", \"faces\": {\"-z\": {\"portalable\": true}}");
            case "smallSolid" -> box("panel", "0, 0.5, 2", "1, 1, 1", ", \"portalable\": true");
            case "volume" ->
                "{\"id\": \"open\", \"kind\": \"planes\", \"planes\": [{\"normal\": [0, 1, 0],"
                        + " \"distanceMetres\": 1}]}";
            default -> "";
        };
    }

    private static String sections(String kind) {
        return switch (kind) {
            case "body" -> START + String.format(BODY, "0, 0.1, 2");
            case "bodyInWall" -> START + String.format(BODY, "4.2, 0.25, 2");
            case "lampInWall" -> START + String.format(LIGHT, "0, 3.2, 0");
            case "lampFar" -> START + String.format(LIGHT, "0, 1.5, 0");
            case "lampDark" -> START + String.format(LIGHT, "0, 0.2, 0").replace("[1, 1, 1]", "[0, 0, 0]");
            case "start" -> ", \"player\": {\"feet\": [4.2, 0, 0]}";
            case "small", "tiles", "smallSolid" -> START + ", \"portalGun\": {}";
            default -> START;
        };
    }

    @ParameterizedTest
    @CsvSource({
        "duplicate, duplicate-id solids/floor.id, solids/floor, 1",
        "material, missing-material solids/crate.material, solids/crate, 2",
        "inside, inside-another solids/crate, solids/crate, 1",
        "thin, too-thin solids/crate, solids/crate, 1",
        "volume, no-volume solids/open, solids/open, 1",
        "fight, fighting-faces solids/rug.faces.+y, solids/rug, 1",
        "small, too-small-for-portal solids/panel.faces.-z.portalable, solids/panel, 1",
        "tiles, too-small-for-portal solids/panel.faces.-z.portalable, solids/panel, 1",
        "smallSolid, too-small-for-portal solids/panel.portalable, solids/panel, 1",
        "body, entity-in-solid bodies/cube.centre, bodies/cube, 2",
        "bodyInWall, entity-in-solid bodies/cube.centre, bodies/cube, 2",
        "lampInWall, entity-in-solid lights/lamp.position, lights/lamp, 2",
        "lampFar, light-without-effect lights/lamp.rangeMetres, lights/lamp, 1",
        "lampDark, light-without-effect lights/lamp.radiantIntensity, lights/lamp, 1",
        "start, entity-in-solid player.feet, player, 1"
    })
    void eachFixRemovesItsProblemAndMakesNoOther(String kind, String key, String entity, int fixes) {
        LevelProblem problem = only(solids(kind), sections(kind));
        assertEquals(key, problem.key());
        assertEquals(EntityRef.of(entity), problem.entity());
        assertEquals(fixes, problem.fixes().size());
        assertTrue(kind.equals("volume") || !problem.marks().isEmpty(), "its place is shown");
        Level level = level(solids(kind), sections(kind) + EXIT);
        for (int i = 0; i < fixes; i++) {
            LevelProblem.Fix fix = problems(level).get(0).fixes().get(i);
            Level repaired = problems(level).get(0).fixes().get(i).change().apply(level);
            assertEquals(List.of(), keys(repaired), fix.label().english());
            assertSame(repaired, fix.change().apply(repaired), "what it repairs is gone");
        }
    }

    @Test
    void aDeletedEntityLeavesTheNotes() {
        EntityRef crate = EntityRef.of("solids/crate");
        List<EntityRef> two = List.of(crate, EntityRef.of("solids/floor"));
        Level plain = level(solids("inside"), START + EXIT);
        Level noted = NoteEdits.grouped(NoteEdits.locked(NoteEdits.hidden(plain, two), two), "g", two);
        Level repaired = problems(noted).get(0).fixes().get(0).change().apply(noted);
        assertEquals(List.of("solids/floor"), repaired.editor().hidden());
        assertEquals(List.of("solids/floor"), repaired.editor().locked());
        assertEquals(List.of(), repaired.editor().groups());
    }

    @Test
    void aBodyInTheFloorIsLiftedOntoIt() {
        Level level = level("", sections("body") + EXIT);
        Level repaired = problems(level).get(0).fixes().get(0).change().apply(level);
        assertEquals(0.25, repaired.bodies().get(0).centre().y(), 1e-9);
        assertEquals(2, repaired.bodies().get(0).centre().z(), 0);
    }

    @Test
    void aMissingFileIsLeftOut() {
        Level level = read("\"materials\": [{\"id\": \"m\", \"texture\": \"no.png\"}], \"models\": [{\"id\": \"x\","
                + " \"file\": \"no.3d\"}], \"player\": {\"feet\": [0, 0, 0]}" + EXIT);
        Level repaired = level;
        for (LevelProblem problem : problems(level)) {
            assertTrue(problem.key().startsWith("missing-asset "), problem.key());
            repaired = problem.fixes().get(0).change().apply(repaired);
        }
        assertEquals(List.of(), keys(repaired));
        assertEquals(1, repaired.materials().size());
        assertNull(repaired.materials().get(0).texture());
    }

    @Test
    void aStartAndAnExitAreAddedOnTheFloorOfTheRoom() {
        Level level = level(box("crate", "0, 0.5, 0", "1, 1, 1", ""), "");
        List<LevelProblem> hints = problems(level);
        assertEquals(List.of("no-start player", "no-exit exits"), keys(level));
        assertTrue(hints.stream().allMatch(hint -> hint.severity() == LevelProblem.Severity.HINT));
        Level started = hints.get(0).fixes().get(0).change().apply(level);
        Level ended = hints.get(1).fixes().get(0).change().apply(started);
        assertEquals(List.of(), keys(ended));
        assertEquals(0, ended.player().feet().y(), "on the floor, not on the roof or the crate");
        double apart = ended.exits().get(0).feet().minus(ended.player().feet()).length();
        assertTrue(apart > 4, "far from the start: " + apart);
        Level empty = read("\"solids\": []");
        Level first = problems(empty).get(0).fixes().get(0).change().apply(empty);
        assertEquals(0, first.player().feet().length());
    }

    @Test
    void aLeakIsALineFromTheStart() {
        Level open = read(
                "\"solids\": [" + WALLS.replace("\"size\": [8, 3, 1]", "\"size\": [7, 3, 1]") + "]" + START + EXIT);
        LevelProblem leak = problems(open).get(0);
        assertEquals(LevelProblem.Severity.WARNING, leak.severity());
        assertEquals("leak player.feet", leak.key());
        assertTrue(leak.marks().size() >= 2 && leak.marks().get(0) instanceof Mark.Line);
        Level underASky = open.with(
                read("\"environment\": {\"sky\": {\"kind\": \"constant\", \"radiance\": [1, 1, 1]}}")
                        .environment(),
                List.of());
        assertEquals(LevelProblem.Severity.HINT, problems(underASky).get(0).severity());
        assertEquals(leak.marks(), problems(underASky).get(0).marks());
    }

    @Test
    void whatThisVersionDoesNotDrawIsNoProblem() {
        Level cloudy = level(
                "",
                START + EXIT
                        + ", \"environment\": {\"clouds\": [{\"id\": \"c\", \"kind\": \"volume\", \"centre\": [0, 99,"
                        + " 0], \"size\": [9, 9, 9], \"density\": {\"kind\": \"grid\", \"file\": \"c.vol\"},"
                        + " \"extinctionPerMetre\": 1, \"albedo\": 1, \"phaseG\": 0}]}");
        assertEquals(List.of("missing-asset environment.clouds/c.density.file"), keys(cloudy));
        LevelProblem problem = problems(cloudy).get(0);
        assertEquals(EntityRef.of("environment.clouds/c"), problem.entity());
        assertEquals(List.of(), keys(problem.fixes().get(0).change().apply(cloudy)));
    }

    @Test
    void aCloudIsKeptWithoutItsMissingCoverageMap() {
        Level cloudy = level(
                "",
                START + EXIT
                        + ", \"environment\": {\"clouds\": [{\"id\": \"c\", \"kind\": \"volume\", \"centre\": [0, 99,"
                        + " 0], \"size\": [9, 9, 9], \"density\": {\"kind\": \"noise\", \"coverage\": 0.7,"
                        + " \"coverageMap\": \"c.png\"}}]}");
        LevelProblem problem = problems(cloudy).get(0);
        assertEquals("missing-asset environment.clouds/c.density.coverageMap", problem.key());
        assertEquals(1, problem.fixes().size());
        Level mended = problem.fixes().get(0).change().apply(cloudy);
        assertEquals(List.of(), keys(mended));
        assertEquals(
                new Cloud.Density.Noise(0, 100, 0.7),
                mended.environment().clouds().get(0).density());
    }

    @Test
    void namesLastWhenEntitiesMove() {
        String crate = box("crate", "0, -0.5, 2", "0.5, 0.5, 0.5", "");
        Level level = level(crate, START + EXIT);
        Level sorted = read("\"solids\": [" + crate + "," + WALLS + "]" + START + EXIT);
        assertEquals(keys(level), keys(sorted));
        LevelProblem problem = problems(level).get(0);
        Level hidden = LevelProblem.hide(level, problem);
        assertTrue(LevelProblem.isHidden(hidden, problems(hidden).get(0)));
        assertSame(hidden, LevelProblem.hide(hidden, problem));
        assertFalse(LevelProblem.isHidden(level, problem));
    }

    @Test
    void anErrorDoesNotHideTheLayoutsWarnings() {
        Level level = level(solids("duplicate") + "," + solids("inside"), START + EXIT);
        assertEquals(List.of("duplicate-id solids/floor.id", "inside-another solids/crate"), keys(level));
    }

    @Test
    void filesAreReadAgainOnlyIfARecordNamesOthers() {
        List<String> asked = new ArrayList<>();
        AssetSource assets = new AssetSource() {
            @Override
            public byte[] bytes(String assetId) {
                asked.add(assetId);
                throw new AssetException(assetId, "is missing", "add it");
            }

            @Override
            public boolean exists(String assetId) {
                return false;
            }
        };
        String material = "\"materials\": [{\"id\": \"m\", \"texture\": \"%s.png\"}]" + START + EXIT;
        ProblemSearch search = new ProblemSearch(assets);
        Level level = read(String.format(material, "a"));
        assertEquals(1, search.find(level, () -> false).orElseThrow().size());
        assertEquals(
                2,
                search.find(level.withExits(List.of()), () -> false)
                        .orElseThrow()
                        .size());
        assertEquals(List.of("a.png"), asked);
        search.find(read(String.format(material, "b")), () -> false);
        assertEquals(List.of("a.png", "b.png"), asked);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "\"terrains\": [{\"id\": \"t\", \"heightMap\": \"%s\", \"centre\": [0, 0, 0], \"sizeMetres\": [9, 9],"
                        + " \"heightRangeMetres\": [0, 1]}]",
                "\"billboards\": [{\"id\": \"b\", \"sprite\": \"%s\", \"sizeMetres\": [1, 1], \"at\": [[0, 0, 0]]}]"
            })
    void anotherFileOfATerrainOrOfBillboardsIsRead(String section) {
        ProblemSearch search = new ProblemSearch(NoFiles.AT_ALL);
        Level before = read(String.format(section, "a.png") + START + EXIT);
        Level after = read(String.format(section, "b.png") + START + EXIT);
        assertTrue(search.find(before, () -> false).orElseThrow().toString().contains("a.png"));
        assertTrue(search.find(after, () -> false).orElseThrow().toString().contains("b.png"));
    }

    @Test
    void aSearchIsCancelledAndGoesOnAfterwards() {
        ProblemSearch search = new ProblemSearch(NoFiles.AT_ALL);
        Level level = level(solids("inside"), START + EXIT);
        int[] asked = {0};
        assertEquals(Optional.empty(), search.find(level, () -> ++asked[0] > 25));
        assertEquals(List.of("inside-another solids/crate"), searched(search, level));
        Thread.currentThread().interrupt();
        assertEquals(Optional.empty(), search.find(level, () -> false));
        assertTrue(Thread.interrupted());
    }

    private static List<String> searched(ProblemSearch search, Level level) {
        return search.find(level, () -> false).orElseThrow().stream()
                .map(LevelProblem::key)
                .toList();
    }

    @Test
    void anEditedLevelIsSearchedLikeAFreshOne() {
        ProblemSearch search = new ProblemSearch(NoFiles.AT_ALL);
        for (String kind : List.of("inside", "volume", "thin", "fight", "none", "duplicate", "small")) {
            Level level = level(solids(kind), sections(kind) + EXIT);
            assertEquals(keys(level), searched(search, level), kind);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"levels/01-courtyard.json", "levels/02-first-shot.json", "levels/04-cube.json"})
    void levelsOfTheGameHaveNoProblemsInTheEditor(Path file) {
        LevelFile.Opened opened = LevelFile.load(file);
        List<LevelProblem> found = ProblemSearch.of(opened.level(), opened.assets());
        assertEquals(
                List.of(),
                found.stream()
                        .filter(each -> each.severity() != LevelProblem.Severity.HINT)
                        .toList());
    }
}
