package nephele.engine.math;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.joml.Matrix4d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

public class FrustumTest {
    /** Returns a projection with the far plane at {@code far}; for infinity, the limit of the usual matrix. */
    public static Matrix4d projection(double near, double far) {
        double depthScale = far == Double.POSITIVE_INFINITY ? -1 : (far + near) / (near - far);
        double depthOffset = far == Double.POSITIVE_INFINITY ? -2 * near : 2 * far * near / (near - far);
        return new Matrix4d(0.6, 0, 0, 0, 0, 1.1, 0, 0, 0, 0, depthScale, -1, 0, 0, depthOffset, 0);
    }

    public static Matrix4d randomView(SplittableRandom random, double near, double far) {
        return projection(near, far)
                .rotateX(random.nextDouble(-1.5, 1.5))
                .rotateY(random.nextDouble(-3.1, 3.1))
                .rotateZ(random.nextDouble(-3.1, 3.1));
    }

    public static Aabb randomBox(SplittableRandom random, Vec3 around, double spread) {
        Vec3 centre = new Vec3(
                around.x() + random.nextDouble(-spread, spread),
                around.y() + random.nextDouble(-spread, spread),
                around.z() + random.nextDouble(-spread, spread));
        double size = Math.pow(10, random.nextDouble(-3, 1.5));
        return Aabb.around(centre, new Vec3(size, size * random.nextDouble(), size * random.nextDouble()));
    }

    /** No box of which clipping leaves a part is culled. */
    @ParameterizedTest
    @ValueSource(doubles = {100, 1e6, Double.POSITIVE_INFINITY})
    void cullsNoBoxThatClippingLeavesAPartOf(double far) {
        var random = new SplittableRandom(5);
        int culled = 0;
        int needlessly = 0;
        int boxes = 35_000;
        for (int i = 0; i < boxes; i++) {
            double farOut = i % 3 == 0 ? 1e7 : 10;
            var eye = new Vec3(farOut * random.nextDouble(), -farOut * random.nextDouble(), farOut);
            Matrix4d clip = randomView(random, 0.05, far);
            Aabb box = randomBox(random, eye, 30);
            boolean seen = Frustum.of(clip, eye).mayIntersect(box);
            boolean visible = BoxClip.leavesSomething(clip, eye, box);
            assertTrue(seen || !visible, () -> "falsely culled " + box + " from " + eye + " with\n" + clip);
            culled += seen ? 0 : 1;
            needlessly += seen && !visible ? 1 : 0;
        }
        assertTrue(culled > boxes / 2, "most random boxes are out of sight, yet only " + culled + " were culled");
        assertTrue(needlessly < boxes / 10, needlessly + " boxes out of sight were kept");
    }

    /** The far plane of an infinite projection has no normal and bounds nothing. */
    @Test
    void anInfiniteFarPlaneIsAlwaysInside() {
        Frustum frustum = Frustum.of(projection(0.05, Double.POSITIVE_INFINITY), Vec3.ZERO);
        assertTrue(frustum.mayIntersect(Aabb.around(new Vec3(0, 0, -1e12), new Vec3(1, 1, 1))));
        assertFalse(frustum.mayIntersect(Aabb.around(new Vec3(0, 0, 1e12), new Vec3(1, 1, 1))));
    }

    /** Boxes at the limits: empty, partly NaN, infinite. */
    @Test
    void anEmptyBoxIsNeverSeenAndAnInfiniteOneAlways() {
        Frustum frustum = Frustum.of(projection(0.05, 100), Vec3.ZERO);
        double inf = Double.POSITIVE_INFINITY;
        assertFalse(frustum.mayIntersect(Aabb.EMPTY));
        assertFalse(frustum.mayIntersect(new Aabb(-1, -1, -5, 1, -2, -3)));
        assertFalse(frustum.mayIntersect(new Aabb(Double.NaN, -1, -5, 1, 1, -3)));
        assertTrue(frustum.mayIntersect(new Aabb(-inf, 5, 5, inf, 6, 6)));
        assertTrue(frustum.mayIntersect(new Aabb(-inf, -inf, -inf, inf, inf, inf)));
    }
}
