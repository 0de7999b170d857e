package nephele.editor.brush;

import nephele.engine.level.BoxFace;
import nephele.engine.math.Vec3;

/**
 * A rotation by quarter turns around an axis of the world, without rounding of directions.
 *
 * @param axis 0 for x, 1 for y, 2 for z
 * @param turns 0 to 3, counter-clockwise seen against the axis
 */
record QuarterTurn(int axis, int turns) {
    /** Returns the rotation; {@code null} if the axis is none of the world's or the angle no multiple of 90°. */
    static QuarterTurn of(Vec3 axis, double degrees) {
        double quarters = degrees / 90;
        if (!PlaneForm.isAlongAxis(axis) || quarters != Math.rint(quarters)) {
            return null;
        }
        double sign = Math.signum(axis.x() + axis.y() + axis.z());
        int index = axis.x() != 0 ? 0 : axis.y() != 0 ? 1 : 2;
        double fourth = (sign * quarters) % 4;
        return new QuarterTurn(index, Math.floorMod((int) fourth, 4));
    }

    /** Returns a direction turned. */
    Vec3 direction(Vec3 v) {
        Vec3 turned = v;
        for (int i = 0; i < turns; i++) {
            turned = switch (axis) {
                case 0 -> new Vec3(turned.x(), -turned.z(), turned.y());
                case 1 -> new Vec3(turned.z(), turned.y(), -turned.x());
                default -> new Vec3(-turned.y(), turned.x(), turned.z());
            };
        }
        return ExactNumber.positiveZeros(turned);
    }

    /** Returns a point turned around a pivot; numbers of few decimals stay such. */
    Vec3 point(Vec3 p, Vec3 pivot) {
        return ExactNumber.clean(pivot.plus(direction(p.minus(pivot))), ExactNumber.OF_SUMS);
    }

    /** Returns edge lengths turned. */
    Vec3 size(Vec3 size) {
        Vec3 turned = direction(size);
        return new Vec3(Math.abs(turned.x()), Math.abs(turned.y()), Math.abs(turned.z()));
    }

    BoxFace side(BoxFace side) {
        return Simplified.side(direction(side.normal())).orElseThrow();
    }
}
