package nephele.engine.level.appearance;

import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;

/** A conservative test if a punctual light can light anything in a box; it never returns false wrongly. */
public final class LightReach {
    private LightReach() {}

    /** Returns false only if the light cannot reach anything in the box. */
    public static boolean touches(PunctualLight light, Aabb box) {
        Vec3 p = light.position();
        double dx = outside(p.x(), box.minX(), box.maxX());
        double dy = outside(p.y(), box.minY(), box.maxY());
        double dz = outside(p.z(), box.minZ(), box.maxZ());
        double range = light.rangeMetres();
        return dx * dx + dy * dy + dz * dz <= range * range && (!light.isSpot() || coneMeets(light, box));
    }

    private static double outside(double x, double min, double max) {
        return Math.max(0, Math.max(min - x, x - max));
    }

    /**
     * Tests the box's bounding sphere against the cone: the angle to its centre, less the angle that its radius spans.
     */
    private static boolean coneMeets(PunctualLight light, Aabb box) {
        Vec3 c = box.centre();
        double x = box.maxX() - box.minX();
        double y = box.maxY() - box.minY();
        double z = box.maxZ() - box.minZ();
        double radius = Math.sqrt(x * x + y * y + z * z) / 2;
        Vector3d towards = c.toVector().sub(light.position().toVector());
        double distance = towards.length();
        if (distance <= radius) {
            return true;
        }
        double cosine = Math.min(Math.max(towards.dot(light.axis().toVector()) / distance, -1), 1);
        double outer = StrictMath.acos(Math.min(Math.max(light.cosOuter(), -1), 1));
        return StrictMath.acos(cosine) - StrictMath.asin(radius / distance) <= outer + 1e-6;
    }
}
