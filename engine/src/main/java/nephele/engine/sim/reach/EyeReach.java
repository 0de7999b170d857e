package nephele.engine.sim.reach;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.Camera;
import nephele.engine.level.Cloud;
import nephele.engine.level.Level;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/**
 * All places where an eye can be in a level, as boxes: those that the player reaches by walking, jumping and falling,
 * through the level's portals and through portals that can be shot, and those of the cameras. A bound from above: some of
 * it may be out of reach.
 *
 * @param parts empty for a level without a player, whose eye can be anywhere
 */
public record EyeReach(List<Part> parts) {
    /** The reach of an eye that can be anywhere. */
    public static final EyeReach ANYWHERE = new EyeReach(List.of());

    /** The means by which the eye comes to a place. */
    public enum Means {
        WALKING("on foot"),
        PORTALS("through the level's portals"),
        SHOTS("through portals that can be shot"),
        CAMERAS("as a camera");

        private final String words;

        Means(String words) {
            this.words = words;
        }

        /** Returns the words of a sentence about it. */
        public String words() {
            return words;
        }
    }

    /** A box of places. */
    public record Part(Aabb box, Means means) {}

    public EyeReach {
        parts = List.copyOf(parts);
    }

    /**
     * Returns the reach in a level.
     *
     * @param statics the shapes that follow from the level
     */
    public static EyeReach of(Level level, StaticShapes statics) {
        if (level.player() == null) {
            return ANYWHERE;
        }
        List<Part> parts = new ArrayList<>(ReachFlood.of(level, statics));
        for (Camera camera : level.cameras()) {
            parts.add(new Part(at(camera.position()), Means.CAMERAS));
            camera.path().forEach(waypoint -> parts.add(new Part(at(waypoint.position()), Means.CAMERAS)));
        }
        return new EyeReach(parts);
    }

    /** Returns this reach with one more place of a camera; an eye that can be anywhere stays so. */
    public EyeReach with(Vec3 eye) {
        if (isAnywhere()) {
            return this;
        }
        List<Part> more = new ArrayList<>(parts);
        more.add(new Part(at(eye), Means.CAMERAS));
        return new EyeReach(more);
    }

    private static Aabb at(Vec3 eye) {
        return new Aabb(eye.x(), eye.y(), eye.z(), eye.x(), eye.y(), eye.z());
    }

    /** Returns true if nothing bounds it. */
    public boolean isAnywhere() {
        return parts.isEmpty();
    }

    /** Returns the part that is nearest to a box; {@code null} for an eye that can be anywhere. */
    public Part nearest(Aabb box) {
        Part best = null;
        for (Part part : parts) {
            if (best == null || metresBetween(part.box(), box) < metresBetween(best.box(), box)) {
                best = part;
            }
        }
        return best;
    }

    /** Returns the bounds of a cloud at the start; those of a layer are infinite along x and z. */
    public static Aabb bounds(Cloud.Extent extent) {
        if (extent instanceof Cloud.Extent.Layer layer) {
            double far = Double.POSITIVE_INFINITY;
            double base = layer.baseAltitudeMetres();
            return new Aabb(-far, base, -far, far, base + layer.thicknessMetres(), far);
        }
        var volume = (Cloud.Extent.Volume) extent;
        return Aabb.around(volume.centre(), volume.size());
    }

    /** Returns the least distance between two boxes, which may be infinite along some axes; 0 if they touch. */
    public static double metresBetween(Aabb a, Aabb b) {
        double x = gap(a.minX(), a.maxX(), b.minX(), b.maxX());
        double y = gap(a.minY(), a.maxY(), b.minY(), b.maxY());
        double z = gap(a.minZ(), a.maxZ(), b.minZ(), b.maxZ());
        return Math.sqrt(x * x + y * y + z * z);
    }

    private static double gap(double least, double greatest, double otherLeast, double otherGreatest) {
        return Math.max(0, Math.max(otherLeast - greatest, least - otherGreatest));
    }

    /** Returns the bounds of all places; empty for an eye that can be anywhere. */
    public Aabb bounds() {
        Aabb bounds = Aabb.EMPTY;
        for (Part part : parts) {
            bounds = bounds.union(part.box());
        }
        return bounds;
    }

    /** Returns the greatest distance of any place from a point, in metres; infinite for an eye that can be anywhere. */
    public double farthestMetres(Vec3 from) {
        double farthest = isAnywhere() ? Double.POSITIVE_INFINITY : 0;
        for (Part part : parts) {
            Aabb box = part.box();
            double x = Math.max(Math.abs(from.x() - box.minX()), Math.abs(from.x() - box.maxX()));
            double y = Math.max(Math.abs(from.y() - box.minY()), Math.abs(from.y() - box.maxY()));
            double z = Math.max(Math.abs(from.z() - box.minZ()), Math.abs(from.z() - box.maxZ()));
            farthest = Math.max(farthest, Math.sqrt(x * x + y * y + z * z));
        }
        return farthest;
    }
}
