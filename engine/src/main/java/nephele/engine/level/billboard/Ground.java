package nephele.engine.level.billboard;

import nephele.engine.math.Vec3;

/** A surface on which things stand: at most one height at a place of the horizontal plane. */
public interface Ground {
    /** The rectangle that it covers, in metres. */
    record Area(double minX, double minZ, double maxX, double maxZ) {
        public double width() {
            return maxX - minX;
        }

        public double depth() {
            return maxZ - minZ;
        }

        /** Returns true if there is no area. */
        public boolean isEmpty() {
            return !(width() > 0 && depth() > 0);
        }
    }

    /** A place of the ground. @param normal unit, upwards */
    record Place(Vec3 at, Vec3 normal) {}

    Area area();

    /** Returns the place at x and z; {@code null} where there is no ground. */
    Place at(double x, double z);
}
