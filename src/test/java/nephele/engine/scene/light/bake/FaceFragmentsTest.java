package nephele.engine.scene.light.bake;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import nephele.engine.level.Brush;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.scene.light.ShadowTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** Every edge of touching solids contains all the corners on it, with the same bits. */
@Execution(ExecutionMode.CONCURRENT)
class FaceFragmentsTest {
    private static final int PLUS_X = 0;
    private static final int PLUS_Z = 4;

    /** A low wall continues a high one; at −0.7 their corners differ in the last bit, as sums written in levels do. */
    private static final List<Brush> WALLS =
            List.of(ShadowTest.box(-1.75, 1.5, -0.85, 1.5, 3, 0.3), ShadowTest.box(-0.85, 1, -3, 0.3, 2, 4.6));

    private static Set<Vec3> corners(List<FaceFragment> face) {
        return face.stream().flatMap(part -> part.corners().stream()).collect(Collectors.toSet());
    }

    @Test
    void theHighWallsEdgeHasTheLowWallsCorner() {
        for (List<List<List<FaceFragment>>> fragments : List.of(
                FaceFragments.uncut(WALLS).byBrush(), FaceFragments.of(WALLS).byBrush())) {
            Set<Vec3> high = corners(fragments.get(0).get(PLUS_Z));
            Set<Vec3> low = corners(fragments.get(1).get(PLUS_Z));
            Vec3 junction = high.stream()
                    .filter(p -> Math.abs(p.x() + 1) < 1e-9 && Math.abs(p.y() - 2) < 1e-9)
                    .findFirst()
                    .orElseThrow();
            assertTrue(low.contains(junction), "the same bits on both sides of the seam");
        }
    }

    @Test
    void whatTheLowWallHidesOfTheHighOnesEndIsCovered() {
        List<FaceFragment> end = FaceFragments.of(WALLS).byBrush().get(0).get(PLUS_X);
        double hidden = end.stream()
                .filter(FaceFragment::isCovered)
                .mapToDouble(part -> PolygonClipping.area(part.outline()))
                .sum();
        assertEquals(2 * 0.3, hidden, 1e-3);
    }

    /** A face is hidden if another solid's face contains it; a portal would show it with the eye in the wall. */
    @Test
    void aFaceThatStaysWholeIsHiddenWhereAnotherSolidsFaceHoldsAllOfIt() {
        List<Brush> abutting = List.of(ShadowTest.box(0, 0, 0, 1, 1, 1), ShadowTest.box(1, 0, 0, 1, 2, 2));
        var fragments = FaceFragments.uncut(abutting).byBrush();
        for (int solid = 0; solid < 2; solid++) {
            for (int face = 0; face < 6; face++) {
                boolean hidden = solid == 0 && face == PLUS_X;
                assertEquals(hidden, fragments.get(solid).get(face).get(0).cover() == FaceFragment.Cover.TOUCHING);
            }
        }
    }

    /** A copy at the same position changes nothing. */
    @Test
    void solidsThatAreThereManyTimesAreCutOnce() {
        List<Brush> repeated = new ArrayList<>(WALLS);
        repeated.addAll(Collections.nCopies(2_000, WALLS.get(0)));
        repeated.addAll(Collections.nCopies(2_000, WALLS.get(1)));
        var once = FaceFragments.of(WALLS).byBrush();
        var all = FaceFragments.of(repeated).byBrush();
        for (int i = 0; i < all.size(); i++) {
            int original = WALLS.indexOf(repeated.get(i));
            assertEquals(described(once.get(original)), described(all.get(i)));
        }
    }

    /** A fragment as a value: two are equal if every number has the same bits. */
    private record Described(FaceFragment.Cover cover, List<Vec3> corners, List<Integer> triangles) {}

    private static List<Described> described(List<List<FaceFragment>> faces) {
        return faces.stream()
                .flatMap(List::stream)
                .map(part -> new Described(
                        part.cover(),
                        part.corners(),
                        Arrays.stream(part.triangles()).boxed().toList()))
                .toList();
    }

    /**
     * A thousand boxes that all overlap exceed the limit of pairs, ten times the number in a full level: the most
     * crowded get no neighbours.
     */
    @Test
    void inACrowdThoseWithTheMostNeighboursStandAlone() {
        List<Aabb> crowd = new ArrayList<>();
        for (int i = 0; i < 1_000; i++) {
            crowd.add(Aabb.around(new Vec3(i * 1e-3, 0, 0), new Vec3(1, 1, 1)));
        }
        crowd.add(Aabb.around(new Vec3(-0.9, 0, 0), new Vec3(1, 1, 1)));
        Neighbours neighbours = Neighbours.of(crowd, 1e-4);
        assertEquals(0, neighbours.of(500).length);
        assertEquals(101, neighbours.of(1_000).length);
        Neighbours few = Neighbours.of(crowd.subList(0, 500), 1e-4);
        assertEquals(499, few.of(250).length);
    }

    /** Returns a box of a small grid, sometimes off it by up to a micrometre: such boxes touch, overlap and repeat. */
    private static Brush any(SplittableRandom random) {
        double off = random.nextInt(4) == 0 ? 1e-6 * random.nextDouble() : 0;
        return ShadowTest.box(
                0.5 * random.nextInt(8) + off,
                0.5 * random.nextInt(3),
                0.5 * random.nextInt(8) - off,
                0.5 * (1 + random.nextInt(4)),
                0.5 * (1 + random.nextInt(4)),
                0.5 * (1 + random.nextInt(4)));
    }

    @Test
    void whatIsCutAnewNearAnEditIsWhatAFreshCutGives() {
        for (long seed = 0; seed < 40; seed++) {
            SplittableRandom random = new SplittableRandom(seed);
            List<Brush> brushes =
                    new ArrayList<>(Stream.generate(() -> any(random)).limit(25).toList());
            FaceFragments cut = FaceFragments.of(brushes);
            FaceFragments whole = FaceFragments.uncut(brushes);
            for (int edit = 0; edit < 8; edit++) {
                edit(brushes, random);
                cut = cut.edited(brushes);
                whole = whole.edited(brushes);
                assertEqual(FaceFragments.of(brushes), cut, seed, edit);
                assertEqual(FaceFragments.uncut(brushes), whole, seed, edit);
            }
        }
    }

    private static void edit(List<Brush> brushes, SplittableRandom random) {
        int at = random.nextInt(brushes.size());
        switch (random.nextInt(4)) {
            case 0 -> brushes.add(at, any(random));
            case 1 -> brushes.remove(at);
            case 2 -> brushes.add(random.nextInt(brushes.size()), brushes.remove(at));
            default -> brushes.set(at, any(random));
        }
    }

    private static void assertEqual(FaceFragments fresh, FaceFragments edited, long seed, int edit) {
        for (int i = 0; i < fresh.byBrush().size(); i++) {
            int brush = i;
            assertEquals(
                    described(fresh.byBrush().get(i)),
                    described(edited.byBrush().get(i)),
                    () -> "seed " + seed + ", edit " + edit + ", brush " + brush);
        }
    }

    @Test
    void fragmentsFarFromAnEditAreTheSameObjects() {
        List<Brush> brushes = new ArrayList<>(WALLS);
        brushes.add(ShadowTest.box(9, 0, 0, 1, 1, 1));
        var before = FaceFragments.of(brushes);
        brushes.set(2, ShadowTest.box(9, 0, 1, 1, 1, 1));
        brushes.add(0, ShadowTest.box(-9, 0, 1, 1, 1, 1));
        var after = before.edited(brushes);
        for (int i = 0; i < 2; i++) {
            assertSame(before.byBrush().get(i), after.byBrush().get(i + 1));
        }
    }

    @Test
    void aSolidThatTouchesNothingKeepsItsFaces() {
        List<Brush> apart = List.of(ShadowTest.box(0, 0, 0, 1, 1, 1), ShadowTest.box(5, 0, 0, 1, 1, 1));
        FaceFragments.of(apart)
                .byBrush()
                .forEach(faces -> faces.forEach(face -> {
                    assertEquals(1, face.size());
                    assertEquals(4, face.get(0).corners().size());
                }));
    }
}
