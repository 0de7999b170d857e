package nephele.editor.tool.brush;

import java.util.List;
import nephele.editor.tool.WorldAxis;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/**
 * The box between a corner on a plane and the pointer.
 *
 * @param axis perpendicular to the plane of the base
 * @param first corner on the base
 * @param second corner opposite to it on the base
 * @param heightMetres from the base along the axis; negative against it
 */
record DrawnBox(WorldAxis axis, Vec3 first, Vec3 second, double heightMetres) {
    DrawnBox withSecond(Vec3 corner) {
        return new DrawnBox(axis, first, axis.with(corner, axis.of(first)), heightMetres);
    }

    DrawnBox withHeight(double metres) {
        return new DrawnBox(axis, first, second, metres);
    }

    /** Returns this box with the shorter side of its base as long as the longer one. */
    DrawnBox square() {
        Vec3 by = second.minus(first);
        double side = Math.max(Math.abs(by.x()), Math.max(Math.abs(by.y()), Math.abs(by.z())));
        Vec3 corner = first;
        for (WorldAxis across : WorldAxis.values()) {
            if (across != axis) {
                corner = across.with(corner, across.of(first) + (across.of(by) < 0 ? -side : side));
            }
        }
        return withSecond(corner);
    }

    /** Returns true if the box encloses nothing. */
    boolean isFlat() {
        Aabb box = bounds();
        return box.minX() == box.maxX() || box.minY() == box.maxY() || box.minZ() == box.maxZ();
    }

    Aabb bounds() {
        return Aabb.of(List.of(first, axis.with(second, axis.of(first) + heightMetres)));
    }
}
