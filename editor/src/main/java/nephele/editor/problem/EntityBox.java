package nephele.editor.problem;

import java.lang.reflect.RecordComponent;
import nephele.engine.level.Body;
import nephele.engine.level.Exit;
import nephele.engine.level.PlayerStart;
import nephele.engine.level.Spatial;
import nephele.engine.level.Written;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/** The space that an entity needs, and the point that moves it. */
final class EntityBox {
    private static final double PLAYER_RADIUS_METRES = 0.3;
    private static final double PLAYER_HEIGHT_METRES = 1.8;

    /** Side of the cube that an entity without size gets. */
    private static final double POINT_METRES = 0.1;

    private EntityBox() {}

    /** Returns the box that has to be free; {@code null} for a record without a place. */
    static Aabb of(Object entity) {
        if (entity instanceof PlayerStart start) {
            return standing(start.feet());
        } else if (entity instanceof Exit exit) {
            return standing(exit.feet());
        } else if (entity instanceof Body body) {
            return Aabb.around(body.centre(), size(body));
        }
        String point = entity instanceof Record record ? pointName(record) : null;
        return point == null
                ? null
                : Aabb.around(
                        (Vec3) RecordMembers.get((Record) entity, point),
                        new Vec3(POINT_METRES, POINT_METRES, POINT_METRES));
    }

    /** Returns the box of a player who stands here. */
    static Aabb standing(Vec3 feet) {
        return new Aabb(
                feet.x() - PLAYER_RADIUS_METRES,
                feet.y(),
                feet.z() - PLAYER_RADIUS_METRES,
                feet.x() + PLAYER_RADIUS_METRES,
                feet.y() + PLAYER_HEIGHT_METRES,
                feet.z() + PLAYER_RADIUS_METRES);
    }

    private static Vec3 size(Body body) {
        if (body instanceof Body.Box box) {
            return box.size();
        } else if (body instanceof Body.Sphere sphere) {
            double side = 2 * sphere.radiusMetres();
            return new Vec3(side, side, side);
        }
        Body.Capsule capsule = (Body.Capsule) body;
        double side = 2 * capsule.radiusMetres();
        return new Vec3(side, capsule.heightMetres(), side);
    }

    /** Returns the record moved; the same if it has no place. */
    static Record moved(Record entity, Vec3 by) {
        String point = pointName(entity);
        return point == null
                ? entity
                : RecordMembers.with(entity, point, ((Vec3) RecordMembers.get(entity, point)).plus(by));
    }

    private static String pointName(Record record) {
        for (RecordComponent component : record.getClass().getRecordComponents()) {
            Written written = component.getAnnotation(Written.class);
            if (written != null && written.spatial() == Spatial.POINT) {
                return component.getName();
            }
        }
        return null;
    }
}
