package nephele.scenes.xml;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import nephele.engine.math.Frustum;
import nephele.engine.math.Vec3;
import nephele.scenes.xml.XmlGroup.Step;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.joml.Vector4d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/**
 * Bounding spheres contain all points under chains of rotations, translations and scales, mirrored and sheared ones
 * included.
 */
@Execution(ExecutionMode.CONCURRENT)
class WorldSpheresTest {
    private static final int TRANSFORMS = 10_000;

    private final Random random = new Random(45);
    private final Matrix4d frame = new Matrix4d();

    private Vec3 direction() {
        Vector3d v;
        do {
            v = new Vector3d(random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
        } while (v.length() < 1e-3);
        return Vec3.of(v.normalize());
    }

    private double factor() {
        return (random.nextBoolean() ? 1 : -1) * Math.pow(10, random.nextDouble() * 3 - 1.5);
    }

    private Step step(int kind) {
        return switch (kind) {
            case 0 -> new Step.Translate(new Vec3(random.nextGaussian() * 10, random.nextGaussian(), 3));
            case 1 -> new Step.Rotate(direction(), random.nextDouble() * 720 - 360);
            default -> new Step.Scale(new Vec3(factor(), factor(), factor()));
        };
    }

    private void place(List<Step> steps) {
        var group = new StepFrames(null, steps);
        group.at(0);
        frame.set(group.worldFromGroup());
    }

    @Test
    void theyHoldEveryPointOfTheModelsOwnSphere() {
        WorldSpheres spheres = new WorldSpheres(1);
        for (int i = 0; i < TRANSFORMS; i++) {
            place(List.of(step(0), step(1), step(2), step(1), step(2), step(0)));
            Vector3d centre = new Vector3d(random.nextGaussian(), 5, random.nextGaussian());
            double radius = Math.abs(factor());
            spheres.place(0, centre.x, centre.y, centre.z, radius, frame);
            for (int k = 0; k < 10; k++) {
                Vector3d point = frame.transformPosition(
                        direction().toVector().mul(radius).add(centre));
                double distance = point.distance(spheres.x(0), spheres.y(0), spheres.z(0));
                assertTrue(distance <= spheres.radius(0), () -> distance + " > " + spheres.radius(0));
            }
        }
    }

    @Test
    void theyAreNoLargerThanThey() {
        WorldSpheres spheres = new WorldSpheres(1);
        for (int i = 0; i < TRANSFORMS; i++) {
            Step.Scale scale = (Step.Scale) step(2);
            place(List.of(step(1), scale, step(1)));
            double largest = Math.max(
                    Math.abs(scale.by().x()),
                    Math.max(Math.abs(scale.by().y()), Math.abs(scale.by().z())));
            spheres.place(0, 0, 0, 0, 2, frame);
            assertEquals(1, spheres.radius(0) / (2 * largest), 1e-9);
        }
    }

    private Matrix4d clipFromWorld(Vec3 eye, Matrix4d clipFromRelative) {
        clipFromRelative
                .setPerspective(Math.toRadians(20 + 100 * random.nextDouble()), 0.5 + random.nextDouble(), 0.5, 200)
                .lookAt(new Vector3d(), direction().toVector(), direction().toVector());
        return new Matrix4d(clipFromRelative).translate(-eye.x(), -eye.y(), -eye.z());
    }

    /** No model with a vertex in the picture, mostly on its very edge, is culled. */
    @Test
    void noneIsCulledThatTouchesTheFrustum() {
        WorldSpheres spheres = new WorldSpheres(1);
        Matrix4d clipFromRelative = new Matrix4d();
        for (int i = 0; i < TRANSFORMS; i++) {
            Vec3 eye = new Vec3(random.nextGaussian() * 100, random.nextGaussian(), random.nextGaussian() * 100);
            Matrix4d worldFromClip = clipFromWorld(eye, clipFromRelative).invert();
            Vector4d clip = new Vector4d(edge(), edge(), edge(), 1).mul(worldFromClip);
            Vector3d seen = new Vector3d(clip.x, clip.y, clip.z).div(clip.w);
            place(List.of(step(1), step(2), step(1), step(2)));
            Vector3d vertex = direction().toVector().mul(1.5);
            Vector3d vertexAt = frame.transformPosition(new Vector3d(vertex));
            Matrix4d placed = new Matrix4d().translate(seen.sub(vertexAt)).mul(frame);
            spheres.place(0, 0, 0, 0, 1.5, placed);
            assertTrue(spheres.maySee(0, Frustum.of(clipFromRelative, eye)), () -> "culled at " + seen);
        }
    }

    private double edge() {
        int kind = random.nextInt(3);
        return kind == 0 ? 1 : kind == 1 ? -1 : random.nextDouble() * 2 - 1;
    }

    @Test
    void whatIsWhollyBehindOnePlaneIsCulled() {
        WorldSpheres spheres = new WorldSpheres(1);
        Matrix4d clipFromRelative = new Matrix4d();
        for (int i = 0; i < TRANSFORMS; i++) {
            Vec3 eye = new Vec3(random.nextGaussian() * 100, random.nextGaussian(), random.nextGaussian() * 100);
            Matrix4d clipFromWorld = clipFromWorld(eye, clipFromRelative);
            int row = random.nextInt(3);
            Vector4d last = clipFromWorld.getRow(3, new Vector4d());
            Vector4d plane = clipFromWorld.getRow(row, new Vector4d());
            plane.mul(random.nextBoolean() ? 1 : -1).add(last);
            plane.div(new Vector3d(plane.x, plane.y, plane.z).length());
            place(List.of(step(1), step(2), step(1), step(2)));
            spheres.place(0, 0, 0, 0, 1, frame);
            double behind = spheres.radius(0) * 1.001 + 0.01;
            Vector3d centre = new Vector3d(eye.x(), eye.y(), eye.z());
            centre.fma(
                    -(plane.x * centre.x + plane.y * centre.y + plane.z * centre.z + plane.w) - behind,
                    new Vector3d(plane.x, plane.y, plane.z));
            spheres.place(0, 0, 0, 0, 1, new Matrix4d().translate(centre).mul(frame));
            assertFalse(spheres.maySee(0, Frustum.of(clipFromRelative, eye)));
        }
    }

    @Test
    void whatHasNoFinitePlaceIsNotSeen() {
        WorldSpheres spheres = new WorldSpheres(1);
        for (double bad : new double[] {Double.NaN, Double.POSITIVE_INFINITY}) {
            spheres.place(0, 0, 0, 0, 1, new Matrix4d().m30(bad));
            assertFalse(spheres.maySee(0, Frustum.everything()));
            spheres.place(0, 0, 0, 0, 1, new Matrix4d().m11(bad));
            assertFalse(spheres.maySee(0, Frustum.everything()));
        }
        spheres.place(0, 0, 0, 0, 1, new Matrix4d());
        assertTrue(spheres.maySee(0, Frustum.everything()));
    }
}
