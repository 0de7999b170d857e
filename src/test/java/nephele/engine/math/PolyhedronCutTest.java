package nephele.engine.math;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashMap;
import java.util.Map;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

final class PolyhedronCutTest {
    private static Plane plane(SplittableRandom random, Vec3 centre) {
        while (true) {
            Vec3 n = new Vec3(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1));
            if (n.length() > 0.1) {
                Plane unit = Plane.of(n, 0);
                double along = unit.signedDistance(centre);
                return new Plane(unit.nx(), unit.ny(), unit.nz(), along + random.nextDouble(-0.6, 0.6));
            }
        }
    }

    /** Returns the volume by the divergence theorem, relative to a corner. */
    static double volume(ConvexPolyhedron solid) {
        Vec3 o = solid.vertices().get(0);
        double sixfold = 0;
        for (ConvexPolyhedron.Face face : solid.faces()) {
            Vec3 a = face.polygon().get(0);
            for (int i = 2; i < face.polygon().size(); i++) {
                Vec3 b = face.polygon().get(i - 1);
                Vec3 c = face.polygon().get(i);
                sixfold += determinant(a.minus(o), b.minus(o), c.minus(o));
            }
        }
        return sixfold / 6;
    }

    private static double determinant(Vec3 a, Vec3 b, Vec3 c) {
        return a.dot(b.cross(c));
    }

    /** Asserts that every edge belongs to two faces that use it in opposite directions. */
    private static void assertClosed(ConvexPolyhedron solid) {
        Map<String, Integer> edges = new HashMap<>();
        for (ConvexPolyhedron.Face face : solid.faces()) {
            for (int i = 0; i < face.polygon().size(); i++) {
                Vec3 a = face.polygon().get(i);
                Vec3 b = face.polygon().get((i + 1) % face.polygon().size());
                edges.merge(a + " " + b, 1, Integer::sum);
                edges.merge(b + " " + a, -1, Integer::sum);
            }
        }
        assertTrue(edges.values().stream().allMatch(n -> n == 0), () -> "open: " + solid);
    }

    /**
     * A box cut a dozen times at the origin, 10 km and 1000 km from it keeps its volume; parts are closed and convex.
     */
    @Test
    void partsAddUpToTheWhole() {
        for (double away : new double[] {0, 10_000, 1e6}) {
            SplittableRandom random = new SplittableRandom(7);
            for (int i = 0; i < 300; i++) {
                Vec3 centre = new Vec3(away, -away, away / 3);
                ConvexPolyhedron rest = ConvexPolyhedron.box(Aabb.around(centre, new Vec3(1, 2, 0.5)));
                double cutOff = 0;
                for (int k = 0; k < 12; k++) {
                    PolyhedronCut cut = PolyhedronCut.of(rest, plane(random, centre));
                    if (cut.behind() == null) {
                        continue;
                    }
                    rest = cut.behind();
                    cutOff += cut.inFront() == null ? 0 : volume(cut.inFront());
                    if (away == 0) {
                        assertClosed(rest);
                    }
                }
                assertEquals(1, volume(rest) + cutOff, 1e-6, "cut " + i + " at " + away);
            }
        }
    }

    @Test
    void aPlaneAlongAFaceLeavesTheSolidAlone() {
        ConvexPolyhedron box = ConvexPolyhedron.box(Aabb.around(Vec3.ZERO, new Vec3(2, 2, 2)));
        for (ConvexPolyhedron.Face face : box.faces()) {
            assertSame(box, PolyhedronCut.of(box, face.plane()).behind());
            assertNull(PolyhedronCut.of(box, face.plane()).inFront());
        }
        PolyhedronCut through = PolyhedronCut.of(box, Plane.of(new Vec3(1, 1, 0), 0));
        assertEquals(5, through.behind().faces().size(), "a plane through edges");
        assertEquals(4, volume(through.behind()), 1e-12);
        assertClosed(through.inFront());
    }
}
