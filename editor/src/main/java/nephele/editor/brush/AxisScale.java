package nephele.editor.brush;

import nephele.engine.level.BoxFace;
import nephele.engine.level.Solid.PlaneFace;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;

/**
 * A scaling along the axes of the world: each coordinate p becomes factor · (p − from) + to.
 *
 * @param factors none of them 0; negative ones mirror
 */
record AxisScale(Vec3 factors, Vec3 from, Vec3 to) {
    Vec3 point(Vec3 p) {
        return ExactNumber.clean(times(p.minus(from)).plus(to), ExactNumber.OF_SUMS);
    }

    Vec3 size(Vec3 size) {
        Vec3 scaled = times(size);
        return ExactNumber.clean(
                new Vec3(Math.abs(scaled.x()), Math.abs(scaled.y()), Math.abs(scaled.z())), ExactNumber.OF_SUMS);
    }

    private Vec3 times(Vec3 v) {
        return v.times(factors);
    }

    BoxFace side(BoxFace side) {
        return times(side.normal()).dot(side.normal()) < 0 ? Simplified.opposite(side) : side;
    }

    /** Scales a normal by the inverse factors, and finds the distance from a scaled point of the plane. */
    PlaneFace plane(PlaneFace face) {
        Plane before = PlaneForm.plane(face);
        Vec3 inverse = new Vec3(before.nx() / factors.x(), before.ny() / factors.y(), before.nz() / factors.z());
        Vec3 normal = Plane.of(inverse, 0).normal();
        Vec3 on = times(before.normal().scaled(before.distance()).minus(from)).plus(to);
        PlaneFace moved = PlaneForm.canonical(Plane.through(normal, on));
        double distance = PlaneForm.isAlongAxis(moved.normal())
                ? ExactNumber.clean(moved.distanceMetres(), ExactNumber.OF_SUMS)
                : moved.distanceMetres();
        return PlaneForm.at(face, moved.normal(), distance);
    }
}
