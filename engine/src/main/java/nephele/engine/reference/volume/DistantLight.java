package nephele.engine.reference.volume;

import nephele.engine.math.Vec3;

/** A light so far away that its beams are parallel: the sun or the moon. */
public interface DistantLight {
    /** Returns the unit direction towards it. */
    Vec3 towards();

    /** Returns its RGB irradiance at a place, on a plane perpendicular to its beam, before media and walls dim it. */
    Vec3 irradiance(Vec3 place);

    /** A light without air before it: the same everywhere. */
    record Even(Vec3 towards, Vec3 irradiance) implements DistantLight {
        @Override
        public Vec3 irradiance(Vec3 place) {
            return irradiance;
        }
    }
}
