package nephele.workshop.art;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import nephele.engine.level.Brush;
import nephele.engine.level.Brush.BrushFace;
import nephele.engine.level.Level;
import nephele.engine.level.Material;
import nephele.engine.level.json.LevelFile;
import nephele.engine.level.json.LevelJson;
import nephele.engine.math.Vec3;
import nephele.engine.rule.LevelRules;
import nephele.engine.sim.replay.Replay;
import nephele.host.named.LevelCatalogue;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The rules that every level in the checkout keeps. */
@Execution(ExecutionMode.CONCURRENT)
class ShippedLevelsTest {
    private static final String PANEL = "textures/panel-white.png";
    private static final Path LEVEL_ONE = Path.of("levels/01-courtyard.json");

    static Stream<Path> levels() throws IOException {
        List<Path> files = new ArrayList<>();
        for (String folder : List.of("levels", "levels/samples")) {
            try (Stream<Path> inFolder = Files.list(Path.of(folder))) {
                inFolder.filter(LevelCatalogue::isLevel).sorted().forEach(files::add);
            }
        }
        return files.stream();
    }

    @ParameterizedTest
    @MethodSource("levels")
    void levelIsCanonicalFreeOfProblemsAndDescribed(Path file) throws IOException {
        LevelFile.Opened opened = LevelFile.load(file);
        Level level = opened.level();
        assertEquals(LevelJson.write(level), Files.readString(file), file + " is not in canonical form");
        assertEquals(List.of(), LevelRules.check(opened.level(), opened.assets()));
        assertFalse(level.description().isBlank(), file + " has no description");
        assertEquals("main", level.cameras().get(0).id());
    }

    /**
     * A replay holds its level's current hash: when a level changes, its replay is recorded again or the new hash is
     * written into it.
     */
    @ParameterizedTest
    @ValueSource(strings = {"levels", "levels/samples"})
    void replaysNameTheirLevelAsItIs(String folder) throws IOException {
        try (Stream<Path> replays = Files.list(Path.of(folder, "replays"))) {
            for (Path file : replays.toList()) {
                Replay replay = Replay.read(file.toString(), Files.readAllBytes(file));
                Level level = LevelFile.load(Path.of(folder, file.getFileName().toString()))
                        .level();
                assertEquals(replay.recordedIn(level), replay, file.toString());
            }
        }
    }

    @Test
    void levelOneIsRich() {
        Level level = LevelFile.load(LEVEL_ONE).level();
        long faces = level.solids().stream()
                .mapToLong(solid -> Brush.of(solid).faces().size())
                .sum();
        assertTrue(faces >= 1000, faces + " faces");
        assertTrue(level.environment().sun().castsShadow());
        assertTrue(level.lights().stream().filter(light -> light.castsShadow()).count() <= 6);
    }

    /**
     * White panels teach where portals open: in a level with a gun every portalable face shows one and no other face
     * does, in one without a gun there is none.
     */
    @ParameterizedTest
    @MethodSource("campaign")
    void panelsAreWhereAGunIsOfUse(Path file) {
        Level level = LevelFile.load(file).level();
        var panels = level.materials().stream()
                .filter(material -> PANEL.equals(material.texture()))
                .map(Material::id)
                .toList();
        List<String> wrong = new ArrayList<>();
        int shown = 0;
        for (var solid : level.solids()) {
            for (BrushFace face : Brush.of(solid).faces()) {
                boolean isPanel = panels.contains(face.material());
                shown += isPanel ? 1 : 0;
                if (isPanel != face.portalable()) {
                    wrong.add(solid.id() + ": " + face.material());
                }
            }
        }
        assertEquals(List.of(), wrong);
        assertEquals(level.portalGun() != null, shown > 0, file + " shows " + shown + " faces of panels");
    }

    static Stream<Path> campaign() {
        return LevelCatalogue.campaign().stream().map(level -> Path.of(level.typed()));
    }

    /**
     * No two faces of different materials are coplanar with the same orientation where they overlap in a visible place;
     * they would flicker.
     */
    @ParameterizedTest
    @MethodSource("levels")
    void noTwoFacesFightForTheSamePixels(Path file) {
        List<Brush> brushes =
                LevelFile.load(file).level().solids().stream().map(Brush::of).toList();
        List<BrushFace> faces =
                brushes.stream().flatMap(brush -> brush.faces().stream()).toList();
        List<String> fights = new ArrayList<>();
        for (int i = 0; i < faces.size(); i++) {
            for (int j = 0; j < i; j++) {
                if (coplanar(faces.get(i), faces.get(j))) {
                    List<Vector3d> overlap = overlap(faces.get(i), faces.get(j));
                    if (area(overlap) > 1e-5 && inSight(brushes, overlap, faces.get(i))) {
                        fights.add(
                                faces.get(i).material() + " / " + faces.get(j).material() + " at " + middle(overlap));
                    }
                }
            }
        }
        assertEquals(List.of(), fights);
    }

    /** Returns true if the space just in front of the overlap's middle is empty. */
    private static boolean inSight(List<Brush> brushes, List<Vector3d> overlap, BrushFace face) {
        Vector3d before = middle(overlap).fma(1e-3, face.plane().normal().toVector());
        return brushes.stream().noneMatch(brush -> brush.faces().stream()
                .allMatch(side -> side.plane().normal().toVector().dot(before)
                        <= side.plane().distance()));
    }

    private static boolean coplanar(BrushFace a, BrushFace b) {
        Vec3 n = a.plane().normal();
        Vec3 m = b.plane().normal();
        return n.toVector().dot(m.toVector()) > 1 - 1e-9
                && Math.abs(a.plane().distance() - b.plane().distance()) < 1e-4
                && !String.valueOf(a.material()).equals(String.valueOf(b.material()));
    }

    /** Clips one convex polygon by the sides of the other (Sutherland and Hodgman 1974). */
    private static List<Vector3d> overlap(BrushFace a, BrushFace b) {
        Vector3d normal = a.plane().normal().toVector();
        List<Vector3d> clipped = a.polygon().stream().map(Vec3::toVector).toList();
        List<Vec3> border = b.polygon();
        for (int i = 0; i < border.size() && !clipped.isEmpty(); i++) {
            Vector3d from = border.get(i).toVector();
            Vector3d side = border.get((i + 1) % border.size()).toVector().sub(from);
            clipped = clip(clipped, from, new Vector3d(normal).cross(side).normalize());
        }
        return clipped;
    }

    private static double area(List<Vector3d> polygon) {
        Vector3d twiceArea = new Vector3d();
        for (int i = 2; i < polygon.size(); i++) {
            Vector3d first = new Vector3d(polygon.get(i - 1)).sub(polygon.get(0));
            twiceArea.add(first.cross(new Vector3d(polygon.get(i)).sub(polygon.get(0))));
        }
        return twiceArea.length() / 2;
    }

    private static List<Vector3d> clip(List<Vector3d> polygon, Vector3d from, Vector3d inward) {
        List<Vector3d> kept = new ArrayList<>();
        for (int i = 0; i < polygon.size(); i++) {
            Vector3d p = polygon.get(i);
            Vector3d q = polygon.get((i + 1) % polygon.size());
            double depthP = new Vector3d(p).sub(from).dot(inward);
            double depthQ = new Vector3d(q).sub(from).dot(inward);
            if (depthP >= 0) {
                kept.add(p);
            }
            if (depthP * depthQ < 0) {
                kept.add(new Vector3d(p).lerp(q, depthP / (depthP - depthQ)));
            }
        }
        return kept;
    }

    private static Vector3d middle(List<Vector3d> polygon) {
        Vector3d sum = new Vector3d();
        polygon.forEach(sum::add);
        return sum.div(polygon.size());
    }
}
