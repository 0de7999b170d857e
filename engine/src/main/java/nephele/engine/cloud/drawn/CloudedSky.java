package nephele.engine.cloud.drawn;

import java.util.Comparator;
import java.util.List;
import nephele.engine.cloud.cells.CellMarch;
import nephele.engine.level.appearance.SkyRadiance;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;

/** The sky as a place sees it through clouds and with their light: what lights the surfaces there. */
public final class CloudedSky implements SkyRadiance {
    private final DrawnClouds clouds;
    private final CellMarch.OutsideOfCloud outside;
    private final SkyRadiance clear;
    private final Vec3 place;
    private final List<DrawnCloud> fromFarthest;

    /**
     * @param outside light around the clouds
     * @param clear the sky without them
     * @param place from which it is seen
     */
    public CloudedSky(DrawnClouds clouds, CellMarch.OutsideOfCloud outside, SkyRadiance clear, Vec3 place) {
        this.clouds = clouds;
        this.outside = outside;
        this.clear = clear;
        this.place = place;
        fromFarthest = this.clouds.all().stream()
                .sorted(Comparator.comparingDouble(cloud -> -distance(cloud)))
                .toList();
    }

    private double distance(DrawnCloud cloud) {
        return Math.max(
                0,
                Math.max(
                        cloud.bounds().minY() - place.y(),
                        place.y() - cloud.bounds().maxY()));
    }

    @Override
    public Vector3d from(double eyeHeight, double x, double y, double z) {
        Vector3d light = clear.from(eyeHeight, x, y, z);
        var ray = new Ray(place.x(), place.y(), place.z(), x, y, z);
        for (DrawnCloud cloud : fromFarthest) {
            var march = new CellMarch(cloud.cells(), outside);
            march.march(ray, 0, Double.POSITIVE_INFINITY, 1, 0.5);
            light.mul(march.transmittance()).add(march.radiance().toVector());
        }
        return light;
    }
}
