package nephele.editor.brush;

import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;
import nephele.engine.level.Brush;
import nephele.engine.level.Solid;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/** The sides of a drawn room, by which its slabs are called; north is where -z points, as in plans. */
public final class RoomSides {
    private RoomSides() {}

    /**
     * Returns the slabs of a room with telling ids.
     *
     * @param freshIds returns an unused id for the word of a side: floor, ceiling, north, south, east, west
     */
    public static List<Solid> named(List<Solid> slabs, Aabb room, UnaryOperator<String> freshIds) {
        List<Solid> named = new ArrayList<>();
        for (Solid slab : slabs) {
            named.add(Identity.withId(slab, freshIds.apply(side(slab, room.centre()))));
        }
        return List.copyOf(named);
    }

    private static String side(Solid slab, Vec3 centre) {
        Aabb box = Brush.of(slab).shape().bounds();
        if (box.maxY() < centre.y()) {
            return "floor";
        } else if (box.minY() > centre.y()) {
            return "ceiling";
        } else if (box.maxZ() < centre.z()) {
            return "north";
        } else if (box.minZ() > centre.z()) {
            return "south";
        }
        return box.minX() > centre.x() ? "east" : "west";
    }
}
