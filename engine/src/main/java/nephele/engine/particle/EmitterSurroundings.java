package nephele.engine.particle;

import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.RayCast;
import nephele.engine.level.Emitter;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;

/** What the static surfaces of a level hide from the middle of an emitter's box: parts of the sky, and the sun. */
public final class EmitterSurroundings {
    private static final int RAYS = 64;
    private static final double FARTHEST_METRES = 1e4;
    private static final double GOLDEN_TURNS = 0.6180339887498949;

    private final CollisionWorld world;
    private final RayCast cast = new RayCast();
    private final Ray ray = Ray.reusable();

    EmitterSurroundings(CollisionWorld world) {
        this.world = world;
    }

    /** Returns the fraction of the upper hemisphere in which the sky is visible. */
    public double skyFraction(Emitter emitter) {
        int open = 0;
        for (int i = 0; i < RAYS; i++) {
            double y = (i + 0.5) / RAYS;
            double level = Math.sqrt(1 - y * y);
            double turns = i * GOLDEN_TURNS;
            open += isOpen(emitter.centre(), level * Waves.cosine(turns), y, level * Waves.sine(turns)) ? 1 : 0;
        }
        return (double) open / RAYS;
    }

    /** Returns true if no surface is in a direction. */
    public boolean sees(Emitter emitter, Vec3 unitDirection) {
        return isOpen(emitter.centre(), unitDirection.x(), unitDirection.y(), unitDirection.z());
    }

    private boolean isOpen(Vec3 from, double x, double y, double z) {
        ray.aim(from.x(), from.y(), from.z(), x, y, z);
        return !cast.cast(world, ray, FARTHEST_METRES);
    }
}
