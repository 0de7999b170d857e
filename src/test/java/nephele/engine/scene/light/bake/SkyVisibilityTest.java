package nephele.engine.scene.light.bake;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import nephele.engine.level.Brush;
import nephele.engine.level.Solid;
import nephele.engine.level.TextureMapping;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Vec3;
import nephele.engine.scene.light.LightMapLookup;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** The baked visibility matches analytic values of the cosine-weighted visible part of the sky within 0.01. */
@Execution(ExecutionMode.CONCURRENT)
class SkyVisibilityTest {
    private static final double TOLERANCE = 0.01;
    private static final int TOP = 2;

    @Test
    void openPlaneSeesTheWholeSky() {
        SkyVisibility ground = baked(List.of(box(0, -0.5, 0, 10, 1, 10)));
        for (double x = -5; x <= 5; x += 0.5) {
            assertEquals(1, seen(ground, 0, TOP, new Vec3(x, 0, 0.3 * x)), 1e-4, "open plane at x = " + x);
        }
    }

    @Test
    void footOfALongHighWallSeesHalfOfTheSky() {
        List<Brush> scene = List.of(box(0, -0.5, 0, 8, 1, 8), box(-2, 8, 0, 1, 16, 16));
        assertEquals(0.5, seen(scene, 0, TOP, new Vec3(-1.5, 0, 0)), TOLERANCE, "at the foot of the wall");
    }

    /** A wall of height h at distance d hides (1 − d/√(d² + h²)) / 2; the fraction is its edge's cosine of altitude. */
    @Test
    void longWallHidesAsMuchAsItsFormFactor() {
        double h = 3;
        SkyVisibility scene = baked(List.of(box(0, -0.5, 0, 24, 1, 8), box(-10, h / 2, 0, 1, h, 4000)));
        for (double d : new double[] {0.5, 1, 2, 4, 8}) {
            double expected = 1 - (1 - d / Math.sqrt(d * d + h * h)) / 2;
            assertEquals(expected, seen(scene, 0, TOP, new Vec3(-9.5 + d, 0, 0)), TOLERANCE, d + " m from the wall");
        }
    }

    @Test
    void nothingIsSeenInAClosedRoom() {
        List<Brush> room = room();
        SkyVisibility baked = SkyVisibility.bake(StaticShapes.of(room), done -> {});
        double brightest = 0;
        for (double x = -2.5; x <= 2.5; x += 0.05) {
            for (double z = -2.5; z <= 2.5; z += 0.05) {
                brightest = Math.max(brightest, seen(baked, 0, TOP, new Vec3(x, 0, z)));
            }
        }
        assertEquals(0, brightest, "the floor of a closed room, up to its very walls");
        assertTrue(seen(baked, 0, TOP, new Vec3(4, 0, 0)) > 0.4, "the same floor face outside the walls");
    }

    /** Under a square roof of half width a at height h only the sky between roof and horizon is visible. */
    @Test
    void roofWithoutWallsLeavesTheRim() {
        double a = 2;
        double h = 2;
        List<Brush> scene = List.of(box(0, -0.5, 0, 8, 1, 8), box(0, h + 0.1, 0, 2 * a, 0.2, 2 * a));
        // Form factor of the quarter rectangle a × a seen from a point under its corner (Howell, configuration B-3).
        double x = a / h;
        double quarter = 2 * x / Math.sqrt(1 + x * x) * Math.atan(x / Math.sqrt(1 + x * x)) / (2 * Math.PI);
        // The roof's thickness hides a little more than its lower face alone.
        double y = a / (h + 0.2);
        double upper = 2 * y / Math.sqrt(1 + y * y) * Math.atan(y / Math.sqrt(1 + y * y)) / (2 * Math.PI);
        double middle = seen(scene, 0, TOP, new Vec3(0, 0, 0));
        assertTrue(upper < quarter);
        assertEquals(1 - 4 * quarter, middle, TOLERANCE, "under the middle of the roof");
    }

    /** Beside a kerb of 3 cm a face has the mean brightness of its points, not the darkness of the joint. */
    @Test
    void kerbDarkensNoMoreThanItHides() {
        double h = 0.03;
        SkyVisibility scene = baked(List.of(box(0, -0.5, 0, 8, 1, 8), box(-2, h / 2, 0, 1, h, 8)));
        double hidden = 0;
        for (double d = 0.005; d < 1; d += 0.01) {
            hidden += 0.01 * (1 - seen(scene, 0, TOP, new Vec3(-1.5 + d, 0, 0.1)));
        }
        // The integral of (1 − d/√(d² + h²)) / 2 over the first metre.
        double expected = (1 + h - Math.sqrt(1 + h * h)) / 2;
        assertEquals(expected, hidden, 0.006, "metres of sky hidden along the first metre");
    }

    @Test
    void resultDoesNotDependOnThreadsOrRuns() {
        List<Brush> room = room();
        short[] once = SkyVisibility.bake(StaticShapes.of(room), done -> {}).texels();
        short[] again = SkyVisibility.bake(StaticShapes.of(room), done -> {}).texels();
        assertArrayEquals(once, again);
    }

    @Test
    void fragmentsCoverTheirFaceExactly() {
        List<Brush> room = room();
        LightMapLayout layout = LightMapLayout.of(room);
        double area = 0;
        double covered = 0;
        for (FaceFragment fragment : layout.fragments().byBrush().get(0).get(TOP)) {
            double a = area(fragment);
            area += a;
            covered += fragment.isCovered() ? a : 0;
        }
        assertEquals(100, area, 1e-6, "area of the floor's fragments");
        assertEquals(6 * 6 - 5 * 5, covered, 1e-3, "area under the walls");
    }

    /** Faces whose fewest texels are more than are wanted were laid out with ever larger texels, and never packed. */
    @Test
    void anyNumberOfFacesIsPackedWithinLittleMoreThanItNeeds() {
        List<Brush> room = room();
        for (int wanted : new int[] {1, 60, 1000, 4000}) {
            LightMapLayout layout = LightMapLayout.of(room, wanted);
            int needed = 0;
            int taken = 0;
            for (LightMapChart chart : layout.charts()) {
                needed += 4;
                taken += chart.columns() * chart.rows();
            }
            assertTrue(taken <= Math.max(wanted, 1.25 * needed), taken + " of " + wanted);
            assertTrue(taken <= layout.width() * layout.height());
            assertTrue(layout.texelMetres() < 1e3);
        }
    }

    private static double area(FaceFragment f) {
        double area = 0;
        for (int i = 0; i < f.triangles().length; i += 3) {
            var a = f.corners().get(f.triangles()[i]).toVector();
            var b = f.corners().get(f.triangles()[i + 1]).toVector().sub(a);
            var c = f.corners().get(f.triangles()[i + 2]).toVector().sub(a);
            area += b.cross(c).y / 2;
        }
        return area;
    }

    private static double seen(List<Brush> scene, int brush, int face, Vec3 p) {
        return seen(baked(scene), brush, face, p);
    }

    private static SkyVisibility baked(List<Brush> scene) {
        return SkyVisibility.bake(StaticShapes.of(scene), done -> {});
    }

    private static double seen(SkyVisibility baked, int brush, int face, Vec3 p) {
        LightMapLayout layout = baked.layout();
        List<FaceFragment> parts = layout.fragments().byBrush().get(brush).get(face);
        for (int i = 0; i < parts.size(); i++) {
            if (!parts.get(i).isCovered() && contains(parts.get(i), p)) {
                LightMapLookup.Spot spot =
                        new LightMapLookup(baked, baked.statics().solids()).of(brush, face, i, parts.get(i));
                return baked.at(spot.columnOf(p), spot.rowOf(p));
            }
        }
        return 0;
    }

    private static boolean contains(FaceFragment part, Vec3 p) {
        List<Vec3> outline = part.outline();
        for (int i = 0; i < outline.size(); i++) {
            Vec3 a = outline.get(i);
            Vec3 b = outline.get((i + 1) % outline.size());
            if ((b.z() - a.z()) * (p.x() - a.x()) - (b.x() - a.x()) * (p.z() - a.z()) < -1e-9) {
                return false;
            }
        }
        return true;
    }

    /** Returns a floor of 10 × 10 m, walls 0.5 m thick around 5 × 5 m on it, and a roof. */
    private static List<Brush> room() {
        return new ArrayList<>(List.of(
                box(0, -0.5, 0, 10, 1, 10),
                box(-2.75, 1.5, 0, 0.5, 3, 6),
                box(2.75, 1.5, 0, 0.5, 3, 6),
                box(0, 1.5, -2.75, 5, 3, 0.5),
                box(0, 1.5, 2.75, 5, 3, 0.5),
                box(0, 3.25, 0, 6, 0.5, 6)));
    }

    private static Brush box(double x, double y, double z, double width, double height, double depth) {
        return Brush.of(new Solid.Box(
                "box", null, false, TextureMapping.WORLD, new Vec3(x, y, z), new Vec3(width, height, depth), Map.of()));
    }
}
