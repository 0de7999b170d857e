package nephele.engine.reference.volume;

import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.cloud.field.CloudMedium;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.RayHit;
import nephele.engine.math.bvh.SpatialIndex;

/**
 * Media that may overlap. Their collisions are independent, so the first collision of all is the nearest of their first
 * ones, and transmittances multiply. Immutable.
 */
public final class CloudMedia {
    private final List<CloudMedium> media;
    private final SpatialIndex index;

    /**
     * A collision with a medium.
     *
     * @param metres ray parameter
     */
    public record Collision(CloudMedium medium, double metres) {}

    public CloudMedia(List<CloudMedium> media) {
        this.media = List.copyOf(media);
        index = SpatialIndex.of(
                this.media.stream().map(medium -> medium.field().bounds()).toList());
    }

    public boolean isEmpty() {
        return media.isEmpty();
    }

    /**
     * Returns a random first collision on a part of a ray, or {@code null} if there is none.
     *
     * @param ray of unit direction
     * @param toMetres may be infinite
     */
    public Collision collision(Ray ray, double fromMetres, double toMetres, SplittableRandom random) {
        var hit = new RayHit();
        boolean isMet = index.nearest(
                ray,
                toMetres,
                (r, item, limit) -> MajorantTracking.collision(media.get(item).field(), r, fromMetres, limit, random),
                hit);
        return isMet ? new Collision(media.get(hit.item()), hit.distance()) : null;
    }

    /** Returns the media that have an extinction at a place. */
    public List<CloudMedium> at(Vec3 place) {
        return media.stream()
                .filter(medium -> medium.field().perMetre(place.x(), place.y(), place.z()) > 0)
                .toList();
    }

    /**
     * Returns a random number in 0 to 1 whose mean is the transmittance of a part of a ray.
     *
     * @param ray of unit direction
     * @param toMetres may be infinite
     */
    public double transmittance(Ray ray, double fromMetres, double toMetres, SplittableRandom random) {
        double[] product = {1};
        boolean isOpaque = index.anyHit(ray, toMetres, (r, item, limit) -> {
            product[0] *= MajorantTracking.transmittance(media.get(item).field(), r, fromMetres, limit, random);
            return product[0] > 0 ? Double.POSITIVE_INFINITY : 0;
        });
        return isOpaque ? 0 : product[0];
    }
}
