package nephele.editor.document;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import nephele.editor.record.Entities;
import nephele.editor.record.EntityRef;
import nephele.editor.record.FieldKind;
import nephele.editor.record.RecordField;
import nephele.editor.record.RecordKind;
import nephele.engine.level.Billboards;
import nephele.engine.level.Body;
import nephele.engine.level.Brush;
import nephele.engine.level.Exit;
import nephele.engine.level.Hint;
import nephele.engine.level.Level;
import nephele.engine.level.ModelPlacement;
import nephele.engine.level.PlayerStart;
import nephele.engine.level.PortalSpec;
import nephele.engine.level.Solid;
import nephele.engine.level.Spatial;
import nephele.engine.level.Terrain;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.sim.state.PlayerDimensions;

/** The box around an entity, from the meaning of its components in the world. */
public final class EntityBounds {
    /** Half the side of the box around an entity that has a place and no size. */
    public static final double SYMBOL_METRES = 0.2;

    private EntityBounds() {}

    /** Returns the box in world metres; {@link Aabb#EMPTY} for a record without a place. */
    public static Aabb of(Record entity) {
        if (entity instanceof Solid solid) {
            return solid(solid);
        } else if (entity instanceof PlayerStart start) {
            return standing(start.feet());
        } else if (entity instanceof Exit exit) {
            return standing(exit.feet(), exit.radiusMetres(), exit.heightMetres());
        } else if (entity instanceof Body body) {
            return Aabb.around(body.centre(), size(body));
        } else if (entity instanceof PortalSpec portal) {
            double half = Math.max(portal.widthMetres(), portal.heightMetres()) / 2;
            return Aabb.around(portal.centre(), portal.normal()).union(cube(portal.centre(), half / 2));
        } else if (entity instanceof ModelPlacement model) {
            return cube(origin(model), SYMBOL_METRES);
        } else if (entity instanceof Terrain terrain) {
            return terrain(terrain);
        } else if (entity instanceof Billboards billboards) {
            return billboards.listedBounds();
        } else if (entity instanceof Hint hint) {
            return hint.near() == null ? Aabb.EMPTY : cube(hint.near().position(), SYMBOL_METRES);
        }
        return generic(entity);
    }

    /** Returns the box around entities of a level, in world metres. */
    public static Aabb of(Level level, Collection<EntityRef> refs) {
        Aabb bounds = Aabb.EMPTY;
        for (EntityRef ref : refs) {
            bounds = bounds.union(of(level, ref));
        }
        return bounds;
    }

    /** Returns the box around an entity of a level; {@link Aabb#EMPTY} if it has no place. */
    public static Aabb of(Level level, EntityRef ref) {
        return Entities.LEVEL.find(level, ref).map(EntityBounds::of).orElse(Aabb.EMPTY);
    }

    private static Aabb terrain(Terrain terrain) {
        double halfX = terrain.sizeMetres().x() / 2;
        double halfZ = terrain.sizeMetres().z() / 2;
        Vec3 centre = terrain.centre();
        Terrain.HeightRange range = terrain.heightRangeMetres();
        return new Aabb(
                centre.x() - halfX,
                centre.y() + Math.min(range.low(), range.high()),
                centre.z() - halfZ,
                centre.x() + halfX,
                centre.y() + Math.max(range.low(), range.high()),
                centre.z() + halfZ);
    }

    private static Aabb solid(Solid solid) {
        try {
            return Brush.of(solid).shape().bounds();
        } catch (IllegalArgumentException noVolume) {
            return Aabb.EMPTY;
        }
    }

    /** Returns the box of a player who stands here. */
    public static Aabb standing(Vec3 feet) {
        return standing(feet, PlayerDimensions.RADIUS_METRES, PlayerDimensions.Stance.STANDING.heightMetres());
    }

    private static Aabb standing(Vec3 feet, double radius, double height) {
        return new Aabb(
                feet.x() - radius,
                feet.y(),
                feet.z() - radius,
                feet.x() + radius,
                feet.y() + height,
                feet.z() + radius);
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

    private static Aabb cube(Vec3 centre, double half) {
        return Aabb.around(centre, new Vec3(2 * half, 2 * half, 2 * half));
    }

    /** Returns the model's origin without its parents. */
    private static Vec3 origin(ModelPlacement model) {
        Vec3 origin = Vec3.ZERO;
        for (ModelPlacement.TransformStep step : model.transform()) {
            if (step instanceof ModelPlacement.TransformStep.Translate translate) {
                origin = origin.plus(translate.by());
            }
        }
        return origin;
    }

    private static Aabb generic(Record entity) {
        List<Vec3> points = new ArrayList<>();
        Vec3 extent = new Vec3(2 * SYMBOL_METRES, 2 * SYMBOL_METRES, 2 * SYMBOL_METRES);
        RecordKind kind = RecordKind.of(entity);
        for (RecordField field : kind.fields()) {
            Object value = kind.get(entity, field);
            if (field.spatial() == Spatial.POINT && value instanceof Vec3 point && points.isEmpty()) {
                points.add(point);
            } else if (field.spatial() == Spatial.EXTENT && value instanceof Vec3 size) {
                extent = size;
            } else if (field.declaration().beside() && field.kind() == FieldKind.VARIANT) {
                return generic((Record) value);
            }
        }
        return points.isEmpty() ? Aabb.EMPTY : Aabb.around(points.get(0), extent);
    }
}
