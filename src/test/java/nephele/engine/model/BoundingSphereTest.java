package nephele.engine.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import nephele.engine.math.Vec3;
import nephele.engine.model.shape.BoxShape;
import nephele.engine.model.shape.ConeShape;
import nephele.engine.model.shape.SphereShape;
import org.junit.jupiter.api.Test;

class BoundingSphereTest {
    private static double farthest(Mesh mesh, BoundingSphere sphere) {
        double most = 0;
        for (int i = 0; i < mesh.vertexCount(); i++) {
            most = Math.max(
                    most, Triangles.position(mesh, i).distance(sphere.centre().toVector()));
        }
        return most;
    }

    private static Mesh cloud(float[] positions) {
        return new Mesh(positions, new float[positions.length], new float[positions.length / 3 * 2], new int[0]);
    }

    @Test
    void everyVertexIsInside() {
        var random = new SplittableRandom(7);
        for (int trial = 0; trial < 2000; trial++) {
            float[] positions = new float[3 * random.nextInt(1, 40)];
            for (int i = 0; i < positions.length; i++) {
                positions[i] = (float) random.nextDouble(-1, 1) * (i % 3 == 0 ? 1000 : 1);
            }
            Mesh mesh = cloud(positions);
            BoundingSphere sphere = BoundingSphere.of(mesh);
            assertTrue(farthest(mesh, sphere) <= sphere.radius());
            assertEquals(sphere.radius(), farthest(mesh, sphere), 1e-9 * sphere.radius());
        }
    }

    /**
     * The sphere of a shape is the smallest; for a cube the radius is that of a corner, √3 times the largest
     * coordinate.
     */
    @Test
    void ofShapesItIsTheSmallest() {
        assertEquals(Math.sqrt(3), BoundingSphere.of(new BoxShape(2, 3).mesh()).radius(), 1e-6);
        assertEquals(1, BoundingSphere.of(new SphereShape(1, 16, 16).mesh()).radius(), 1e-6);
        assertEquals(1.25, BoundingSphere.of(new ConeShape(1, 2, 64, 3).mesh()).radius(), 0.02);
    }

    @Test
    void ofNothingItIsAPoint() {
        assertEquals(new BoundingSphere(Vec3.ZERO, 0), BoundingSphere.of(cloud(new float[0])));
        assertEquals(0, BoundingSphere.of(cloud(new float[] {1, 2, 3})).radius());
    }
}
