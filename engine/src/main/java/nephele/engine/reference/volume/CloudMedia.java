package nephele.engine.reference.volume;

import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.cloud.field.CloudMedium;
import nephele.engine.math.Ray;

/**
 * Media that may overlap. Their collisions are independent, so the first collision of all is the nearest of their first
 * ones, and transmittances multiply.
 */
public final class CloudMedia {
    private final List<CloudMedium> media;

    /**
     * A collision with a medium.
     *
     * @param metres ray parameter
     */
    public record Collision(CloudMedium medium, double metres) {}

    public CloudMedia(List<CloudMedium> media) {
        this.media = List.copyOf(media);
    }

    /**
     * Returns a random first collision on a part of a ray, or {@code null} if there is none.
     *
     * @param ray of unit direction
     * @param toMetres may be infinite
     */
    public Collision collision(Ray ray, double fromMetres, double toMetres, SplittableRandom random) {
        CloudMedium met = null;
        double nearest = toMetres;
        for (CloudMedium medium : media) {
            double metres = DeltaTracking.collision(medium.field(), ray, fromMetres, nearest, random);
            if (metres < nearest) {
                nearest = metres;
                met = medium;
            }
        }
        return met == null ? null : new Collision(met, nearest);
    }

    /**
     * Returns a random number in 0 to 1 whose mean is the transmittance of a part of a ray.
     *
     * @param ray of unit direction
     * @param toMetres may be infinite
     */
    public double transmittance(Ray ray, double fromMetres, double toMetres, SplittableRandom random) {
        double transmittance = 1;
        for (CloudMedium medium : media) {
            if (transmittance > 0) {
                transmittance *= RatioTracking.transmittance(medium.field(), ray, fromMetres, toMetres, random);
            }
        }
        return transmittance;
    }
}
