package nephele.engine.collision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Vec3;
import nephele.workshop.prove.geometry.BruteForce;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** Distances equal brute force, and GJK and separating axes agree and terminate on degenerate pairs. */
@Execution(ExecutionMode.CONCURRENT)
class SeparationTest {
    private final Gjk gjk = new Gjk();
    private final SeparatingAxes axes = new SeparatingAxes();
    private final Separation separation = new Separation();

    private static RoundedHull segment(Vector3d half, double radius) {
        return RoundedHull.capsule(new Vec3(half.x, half.y, half.z), radius);
    }

    @Test
    void gjkEqualsBruteForce() {
        var random = new SplittableRandom(1);
        for (int i = 0; i < 10_000; i++) {
            ConvexPolyhedron solid = Solids.any(random);
            Vector3d half = Solids.point(random, random.nextBoolean() ? 1 : 0.01);
            Vector3d at = Solids.point(random, 4);
            double expected = BruteForce.distance(new Vector3d(at).sub(half), new Vector3d(at).add(half), solid);
            separation.measure(segment(half, 0), at.x, at.y, at.z, new Collider("", solid));
            if (expected > 0) {
                assertEquals(expected, separation.metres(), 1e-9, "pair " + i);
            } else {
                assertTrue(separation.metres() <= 1e-9, "pair " + i);
            }
        }
    }

    @Test
    void movingAlongTheNormalAddsWhatItMoves() {
        var random = new SplittableRandom(2);
        for (int i = 0; i < 5000; i++) {
            Collider solid = new Collider("", Solids.any(random));
            RoundedHull shape = segment(Solids.point(random, 1), 0.3);
            Vector3d at = Solids.point(random, 3);
            separation.measure(shape, at.x, at.y, at.z, solid);
            double before = separation.metres();
            at.fma(0.5, separation.normal());
            separation.measure(shape, at.x, at.y, at.z, solid);
            assertEquals(before + 0.5, separation.metres(), 1e-8, "pair " + i);
        }
    }

    /** Two boxes have the same distance or depth, whichever of them is the collider. */
    @Test
    void twoBoxesMeasureEachOtherAlike() {
        var random = new SplittableRandom(4);
        int deep = 0;
        for (int i = 0; i < 3000; i++) {
            Vec3[] a = halves(random);
            Vec3[] b = halves(random);
            Vector3d at = Solids.point(random, 1.5);
            Collider first = new Collider("", ConvexPolyhedron.box(Vec3.ZERO, a[0], a[1], a[2]));
            Collider second = new Collider("", ConvexPolyhedron.box(Vec3.of(at), b[0], b[1], b[2]));
            separation.measure(RoundedHull.box(b[0], b[1], b[2]), at.x, at.y, at.z, first);
            double metres = separation.metres();
            separation.measure(RoundedHull.box(a[0], a[1], a[2]), 0, 0, 0, second);
            assertEquals(metres, separation.metres(), 1e-9, "pair " + i);
            deep += metres < -0.01 ? 1 : 0;
        }
        assertTrue(deep > 1000, "deep " + deep);
    }

    /** Returns the half edges of a box, a plate or a stick, in any orientation. */
    private static Vec3[] halves(SplittableRandom random) {
        Vector3d x = Solids.direction(random);
        Vector3d y = Solids.direction(random).cross(x).normalize();
        Vector3d z = new Vector3d(x).cross(y);
        Vec3[] halves = new Vec3[3];
        int axis = 0;
        for (Vector3d unit : new Vector3d[] {x, y, z}) {
            halves[axis++] = Vec3.of(unit.mul(random.nextInt(3) == 0 ? 0.02 : random.nextDouble(0.1, 1.5)));
        }
        return halves;
    }

    /**
     * Covers touching, parallel, crossing at a corner, tiny and vast. GJK's bound loses length² / distance · 1e-16,
     * towards intersection.
     */
    @Test
    void gjkAndSeparatingAxesAgreeOnDegeneratePairs() {
        var random = new SplittableRandom(3);
        for (int i = 0; i < 10_000; i++) {
            Collider solid = new Collider("", Solids.any(random));
            int vertex = random.nextInt(solid.shape().vertices().size());
            double near = random.nextInt(3) == 0 ? 0 : StrictMath.pow(10, -14 * random.nextDouble());
            Vector3d at = new Vector3d(solid.vertex(vertex, 0), solid.vertex(vertex, 1), solid.vertex(vertex, 2));
            at.add(Solids.direction(random).mul(near));
            RoundedHull shape = degenerate(random, solid);
            gjk.measure(shape, at.x, at.y, at.z, solid);
            axes.measure(shape, at.x, at.y, at.z, solid);
            Vec3 centre = solid.centre();
            separation.measure(shape, at.x + centre.x(), at.y + centre.y(), at.z + centre.z(), solid);
            double length = shape.greatest(0) + shape.greatest(1) + shape.greatest(2);
            if (Math.abs(axes.distance()) > 1e-7 * (1 + length)) {
                assertEquals(axes.distance() > 0, gjk.distance() > 0, "pair " + i);
            }
            assertTrue(gjk.distance() < 1e-9 || axes.distance() > -1e-9, "pair " + i + ": gjk sees a gap in solid");
            assertTrue(axes.distance() < 1e-9 || separation.metres() > 0, "pair " + i + ": a gap is lost");
        }
    }

    private static RoundedHull degenerate(SplittableRandom random, Collider solid) {
        int edge = random.nextInt(solid.edges());
        Vector3d along = new Vector3d(solid.edge(edge, 0), solid.edge(edge, 1), solid.edge(edge, 2));
        return switch (random.nextInt(5)) {
            case 0 -> RoundedHull.sphere(0);
            case 1 -> segment(along.mul(0.5), 0);
            case 2 -> segment(along.mul(1e-9), 0);
            case 3 -> segment(along.mul(1000), 0);
            default -> RoundedHull.box(new Vec3(0.5, 0, 0), new Vec3(0, 0.5, 0), new Vec3(0, 0, 0.5));
        };
    }

    @Test
    void aPointInTheMiddleOfABoxIsAsDeepAsTheNearestFace() {
        Collider solid = new Collider("", Solids.box(4, 2, 6));
        separation.measure(RoundedHull.sphere(0.3), 0.5, 0.25, 0, solid);
        assertEquals(-0.75 - 0.3, separation.metres(), 1e-12);
        assertEquals(1, separation.normal().y(), 1e-12);
    }

    @Test
    void aThousandKilometresOutIsAsGoodAsTheOrigin() {
        double far = 1 << 20;
        ConvexPolyhedron solid =
                ConvexPolyhedron.box(nephele.engine.math.Aabb.around(new Vec3(far, -far, far), new Vec3(2, 2, 2)));
        separation.measure(RoundedHull.sphere(0.25), far + 1.5, -far, far, new Collider("", solid));
        assertEquals(0.25, separation.metres(), 1e-12);
    }
}
