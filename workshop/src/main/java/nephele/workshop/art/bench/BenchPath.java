package nephele.workshop.art.bench;

import nephele.engine.level.Camera;
import nephele.engine.math.Vec3;

/**
 * Camera paths of the benchmark scenes, one round in {@value #FRAMES} frames. Positions and directions are rounded to
 * float where the compared engines round them, so that all engines draw the same views.
 */
final class BenchPath {
    static final int FRAMES = 60;

    private BenchPath() {}

    /** Returns the side of the square grid that holds {@code count} boxes. */
    static int side(int count) {
        return (int) Math.ceil(Math.sqrt(count));
    }

    static Camera.Waypoint clear(int frame) {
        return waypoint(Vec3.ZERO, swayRadians(frame), 0);
    }

    /** Returns a camera that rotates once and looks up and down. */
    static Camera.Waypoint skybox(int frame) {
        return waypoint(Vec3.ZERO, phase(frame), (float) (0.35 * StrictMath.sin(phase(frame))));
    }

    /** Returns a camera above the grid, a quarter of its extent behind the centre, that moves sideways. */
    static Camera.Waypoint boxes(int count, int frame) {
        return above(count, 2, frame);
    }

    /** As {@link #boxes}, above a grid of another spacing. */
    static Camera.Waypoint above(int count, float spacing, int frame) {
        float extent = side(count) * spacing;
        float x = (float) (0.05 * extent * StrictMath.sin(phase(frame)));
        return waypoint(new Vec3(x, 3 + 0.02f * extent, 0.25f * extent), swayRadians(frame), -0.15f);
    }

    /** Returns a camera above the middle of the terrain that flies over it. */
    static Camera.Waypoint terrain(int frame) {
        float x = (float) (60 * StrictMath.sin(phase(frame)));
        return waypoint(new Vec3(x, 120, 300 - 4f * frame), swayRadians(frame), -0.25f);
    }

    /** Returns a camera above the tops of trees that turns once. */
    static Camera.Waypoint forest(int frame) {
        return waypoint(new Vec3(0, 18, 0), phase(frame), -0.05f);
    }

    private static double phase(int frame) {
        return 2 * Math.PI * frame / FRAMES;
    }

    private static double swayRadians(int frame) {
        return StrictMath.toRadians(15) * StrictMath.sin(phase(frame));
    }

    /** @param yawRadians 0 looks along −z, positive to the right */
    private static Camera.Waypoint waypoint(Vec3 eye, double yawRadians, float rise) {
        float x = (float) StrictMath.sin(yawRadians);
        float z = (float) -StrictMath.cos(yawRadians);
        float length = (float) StrictMath.sqrt(x * x + rise * rise + z * z);
        Vec3 target = new Vec3(eye.x() + x / length, eye.y() + rise / length, eye.z() + z / length);
        return new Camera.Waypoint(eye, target);
    }
}
