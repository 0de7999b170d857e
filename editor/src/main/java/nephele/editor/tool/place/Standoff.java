package nephele.editor.tool.place;

import nephele.editor.record.RecordWalk;
import nephele.engine.level.Body;
import nephele.engine.level.Camera;
import nephele.engine.level.Cloud;
import nephele.engine.level.Light;
import nephele.engine.level.Solid;
import nephele.engine.level.Spatial;
import nephele.engine.math.Vec3;

/** The distance of an entity's place from the surface on which it stands. */
final class Standoff {
    /** The distance of a lamp or camera from the surface, so that the surface does not hide it. */
    private static final double SYMBOL_METRES = 0.3;

    /** The height of a cloud's base over the floor that is pointed at: on the floor it would be fog in a room. */
    private static final double CLOUD_BASE_METRES = 60;

    private Standoff() {}

    /** Returns the distance in metres along the unit normal. */
    static double metres(Record entity, Vec3 normal) {
        double upright = Math.abs(normal.y());
        if (entity instanceof Light || entity instanceof Camera) {
            return SYMBOL_METRES;
        } else if (entity instanceof Body.Sphere sphere) {
            return sphere.radiusMetres();
        } else if (entity instanceof Body.Capsule capsule) {
            return capsule.radiusMetres() + upright * (capsule.heightMetres() / 2 - capsule.radiusMetres());
        } else if (entity instanceof Solid.Prism prism) {
            double level = Math.sqrt(Math.max(0, 1 - upright * upright));
            return level * prism.radiusMetres() + upright * prism.heightMetres() / 2;
        }
        Vec3 size = extent(entity);
        if (entity instanceof Cloud && normal.y() > 0.5) {
            return CLOUD_BASE_METRES + size.y() / 2;
        }
        return (Math.abs(normal.x()) * size.x() + upright * size.y() + Math.abs(normal.z()) * size.z()) / 2;
    }

    private static Vec3 extent(Record entity) {
        Vec3[] found = {Vec3.ZERO};
        RecordWalk.map(entity, (field, value) -> {
            if (field.spatial() == Spatial.EXTENT && value instanceof Vec3 size) {
                found[0] = size;
            }
            return value;
        });
        return found[0];
    }
}
