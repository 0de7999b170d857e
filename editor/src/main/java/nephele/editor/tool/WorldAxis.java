package nephele.editor.tool;

import nephele.editor.pane.MarkColour;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/** An axis of the world. */
public enum WorldAxis {
    X(new Vec3(1, 0, 0), MarkColour.AXIS_X),
    Y(new Vec3(0, 1, 0), MarkColour.AXIS_Y),
    Z(new Vec3(0, 0, 1), MarkColour.AXIS_Z);

    private final Vec3 unit;
    private final MarkColour colour;

    WorldAxis(Vec3 unit, MarkColour colour) {
        this.unit = unit;
        this.colour = colour;
    }

    /** Returns the axis that is most nearly parallel to a direction. */
    public static WorldAxis nearest(Vec3 direction) {
        double x = Math.abs(direction.x());
        double y = Math.abs(direction.y());
        double z = Math.abs(direction.z());
        if (y >= x && y >= z) {
            return Y;
        }
        return x >= z ? X : Z;
    }

    /** Returns the unit vector along the axis. */
    public Vec3 unit() {
        return unit;
    }

    /** Returns the colour of marks along the axis. */
    public MarkColour colour() {
        return colour;
    }

    /** Returns the component of a vector along the axis. */
    public double of(Vec3 v) {
        return this == X ? v.x() : this == Y ? v.y() : v.z();
    }

    /** Returns a vector with another component along the axis. */
    public Vec3 with(Vec3 v, double component) {
        return new Vec3(this == X ? component : v.x(), this == Y ? component : v.y(), this == Z ? component : v.z());
    }

    /** Returns the lower end of a box along the axis. */
    public double least(Aabb box) {
        return of(new Vec3(box.minX(), box.minY(), box.minZ()));
    }

    /** Returns the upper end of a box along the axis. */
    public double most(Aabb box) {
        return of(new Vec3(box.maxX(), box.maxY(), box.maxZ()));
    }
}
