package nephele.engine.math;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

class ConvexPolyhedronTest {
    private static final Aabb BOX = new Aabb(-1, -2, -3, 1, 2, 3);

    private static List<Plane> planesOf(ConvexPolyhedron p) {
        return p.faces().stream().map(ConvexPolyhedron.Face::plane).toList();
    }

    @Test
    void theClosedFormBoxAndTheGeneralWayAgree() {
        ConvexPolyhedron general = ConvexPolyhedron.fromPlanes(planesOf(ConvexPolyhedron.box(BOX)));
        assertEquals(BOX, general.bounds());
        assertEquals(8, general.vertices().size());
        for (int i = 0; i < 6; i++) {
            assertCounterClockwise(ConvexPolyhedron.box(BOX).faces().get(i));
            assertCounterClockwise(general.faces().get(i));
        }
    }

    private static void assertCounterClockwise(ConvexPolyhedron.Face face) {
        List<Vec3> p = face.polygon();
        for (int i = 0; i < p.size(); i++) {
            var a = p.get(i).toVector();
            var b = p.get((i + 1) % p.size()).toVector();
            var c = p.get((i + 2) % p.size()).toVector();
            var turn = b.sub(a, new org.joml.Vector3d()).cross(c.sub(b, new org.joml.Vector3d()));
            assertTrue(turn.dot(face.plane().normal().toVector()) > 0, () -> "corner of face " + face);
        }
    }

    @Test
    void anOpenBoxIsRefusedWithTheReason() {
        List<Plane> open = planesOf(ConvexPolyhedron.box(BOX)).subList(0, 5);
        var refusal = assertThrows(IllegalArgumentException.class, () -> ConvexPolyhedron.fromPlanes(open));
        assertTrue(refusal.getMessage().contains("plane"), refusal.getMessage());
    }

    @Test
    void planesThatExcludeEachOtherEncloseNothing() {
        List<Plane> planes = new ArrayList<>(planesOf(ConvexPolyhedron.box(BOX)));
        planes.add(new Plane(1, 0, 0, -5));
        assertThrows(IllegalArgumentException.class, () -> ConvexPolyhedron.fromPlanes(planes));
    }

    @Test
    void aRedundantPlaneGivesNoFace() {
        List<Plane> planes = new ArrayList<>(planesOf(ConvexPolyhedron.box(BOX)));
        planes.add(new Plane(1, 0, 0, 9));
        planes.add(new Plane(1, 0, 0, 1));
        assertEquals(6, ConvexPolyhedron.fromPlanes(planes).faces().size());
    }

    /** Random solids fulfil Euler's formula; each edge is counted once from both of its faces. */
    @Test
    void randomPolyhedraAreClosed() {
        var random = new Random(7);
        for (int trial = 0; trial < 300; trial++) {
            List<Plane> planes = new ArrayList<>(planesOf(ConvexPolyhedron.box(BOX)));
            for (int i = 0; i < 10; i++) {
                var n = new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
                planes.add(Plane.of(n, 0.3 + random.nextDouble()));
            }
            ConvexPolyhedron solid = ConvexPolyhedron.fromPlanes(planes);
            int corners =
                    solid.faces().stream().mapToInt(f -> f.polygon().size()).sum();
            assertEquals(0, corners % 2);
            assertEquals(
                    2, solid.vertices().size() - corners / 2 + solid.faces().size());
        }
    }
}
