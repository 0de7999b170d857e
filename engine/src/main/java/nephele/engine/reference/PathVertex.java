package nephele.engine.reference;

import java.util.SplittableRandom;
import nephele.engine.cloud.field.CloudMedium;
import nephele.engine.math.Vec3;
import nephele.engine.reference.volume.Deflection;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/** A place at which a path of light turns: a point of a surface, or one in a cloud. */
sealed interface PathVertex permits SurfacePoint, PathVertex.InCloud {
    Vec3 place();

    /** Returns where rays from the vertex begin: a surface is left behind by more than the error of rounding. */
    Vector3d rayOrigin();

    /** Returns true if the vertex may turn light from this direction, of any length, towards the eye. */
    boolean isReachedFrom(Vector3dc towardsLight);

    /** Returns the radiance towards the eye per irradiance on a plane perpendicular to light from a unit direction. */
    Vector3d reflected(Vector3dc towardsLight);

    /** Returns random directions that are likely where the vertex turns much light towards the eye. */
    DirectionSampling sampling();

    /** Random unit directions and their density. */
    interface DirectionSampling {
        /** Returns a random unit direction; one that does not reach the vertex carries no light. */
        Vector3d direction(SplittableRandom random);

        /** Returns the density per steradian of {@link #direction} in a unit direction. */
        double density(Vector3dc towards);
    }

    /**
     * A collision in a cloud.
     *
     * @param along unit direction of the path before it, away from the eye
     */
    record InCloud(Vec3 place, Vec3 along, CloudMedium medium) implements PathVertex, DirectionSampling {
        @Override
        public Vector3d rayOrigin() {
            return place.toVector();
        }

        @Override
        public boolean isReachedFrom(Vector3dc towardsLight) {
            return true;
        }

        @Override
        public Vector3d reflected(Vector3dc towardsLight) {
            return new Vector3d(medium.albedo() * density(towardsLight));
        }

        @Override
        public DirectionSampling sampling() {
            return this;
        }

        @Override
        public Vector3d direction(SplittableRandom random) {
            return Deflection.of(along, medium.phase().sampleSeparation(random), random)
                    .toVector();
        }

        @Override
        public double density(Vector3dc towards) {
            return medium.phase().perSteradian(Deflection.separation(along, Vec3.of(towards)));
        }
    }
}
