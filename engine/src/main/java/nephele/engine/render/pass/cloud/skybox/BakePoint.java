package nephele.engine.render.pass.cloud.skybox;

import nephele.engine.level.Level;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.model.BoundingSphere;

/** The point from which a cloud is baked. */
final class BakePoint {
    /** Height of the player's eye over the feet. */
    private static final Vec3 EYE = new Vec3(0, 1.65, 0);

    private BakePoint() {}

    /**
     * Returns the middle of where eyes can be if all of them are on this side of the cloud, otherwise the first camera or
     * the player's start.
     */
    static Vec3 of(Level level, BoundingSphere eyes, Aabb cloud) {
        if (eyes != null && eyes.radius() < cloud.nearest(eyes.centre())) {
            return eyes.centre();
        }
        if (!level.cameras().isEmpty()) {
            return level.cameras().get(0).position();
        }
        return level.player() == null ? Vec3.ZERO : level.player().feet().plus(EYE);
    }
}
