package nephele.engine.math;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

@Execution(ExecutionMode.CONCURRENT)
class RayClipTest {
    private static final Plane RIGHT = new Plane(1, 0, 0, 3);
    private static final Plane LEFT = new Plane(-1, 0, 0, -1);

    private static RayClip clip(Vec3 origin, Vec3 direction) {
        return new RayClip(Ray.of(origin, direction), 0, Double.POSITIVE_INFINITY);
    }

    private static boolean isEmpty(RayClip clip) {
        return clip.enter() > clip.leave();
    }

    @Test
    void whatIsBetweenTwoPlanesIsKept() {
        RayClip clip = clip(Vec3.ZERO, new Vec3(0.5, 1, 0));
        clip.keepBehind(RIGHT);
        clip.keepBehind(LEFT);
        assertEquals(2, clip.enter());
        assertEquals(6, clip.leave());
    }

    @Test
    void inFrontIsTheOtherPart() {
        RayClip clip = clip(Vec3.ZERO, new Vec3(0.5, 1, 0));
        clip.keepInFront(RIGHT);
        assertEquals(6, clip.enter());
        assertEquals(Double.POSITIVE_INFINITY, clip.leave());
        clip.keepInFront(LEFT);
        assertTrue(isEmpty(clip));
    }

    @Test
    void aRayAlongAPlaneIsKeptUnlessItIsInFront() {
        RayClip on = clip(new Vec3(3, 0, 0), new Vec3(0, 1, 0));
        on.keepBehind(RIGHT);
        assertEquals(0, on.enter());
        assertEquals(Double.POSITIVE_INFINITY, on.leave());
        RayClip before = clip(new Vec3(3.001, 0, 0), new Vec3(0, 1, 0));
        before.keepBehind(RIGHT);
        assertTrue(isEmpty(before));
    }
}
