package nephele.engine.cloud.drawn;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import nephele.engine.asset.AssetSource;
import nephele.engine.cloud.cells.CellMarch;
import nephele.engine.cloud.field.CloudMedium;
import nephele.engine.cloud.field.LoadedClouds;
import nephele.engine.cloud.light.CloudLight;
import nephele.engine.cloud.light.CloudOptics;
import nephele.engine.level.Cloud;
import nephele.engine.level.Environment;
import nephele.engine.level.Sun;
import nephele.engine.math.Directions;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;

/** All clouds of a level that have any extinction, sampled for drawing. Immutable. */
public final class DrawnClouds {
    private static final Vec3 NOON = new Vec3(0, 1, 0);

    private final List<DrawnCloud> all;
    private final Vec3 towardsSun;

    private DrawnClouds(List<DrawnCloud> all, Vec3 towardsSun) {
        this.all = List.copyOf(all);
        this.towardsSun = towardsSun;
    }

    /**
     * Samples the clouds of an environment, those of its weather included, at time 0.
     *
     * @throws nephele.engine.asset.AssetException if a picture or grid is unusable
     */
    public static DrawnClouds of(Environment environment, AssetSource assets) {
        LoadedClouds loaded = LoadedClouds.of(environment, assets);
        List<CloudMedium> media = loaded.at(0);
        Map<CloudOptics, CloudLight> physics = new HashMap<>();
        List<DrawnCloud> all = new ArrayList<>();
        Vec3 sun = towardsSun(environment);
        for (int i = 0; i < media.size(); i++) {
            Cloud cloud = loaded.clouds().get(i);
            CloudLight light = physics.computeIfAbsent(CloudOptics.of(cloud.albedo(), cloud.phaseG()), CloudLight::new);
            DrawnCloud drawn = DrawnCloud.of(cloud, media.get(i).field(), light, Vec3.ZERO, sun);
            if (!drawn.cells().isEmpty()) {
                all.add(drawn);
            }
        }
        return new DrawnClouds(all, sun);
    }

    /** Returns the unit direction towards the sun of an environment; any without one. */
    public static Vec3 towardsSun(Environment environment) {
        Sun sun = environment.sun();
        return sun == null ? NOON : Directions.unit(sun.directionTowardsSun());
    }

    /** Returns the clouds in the light of another sun. */
    public DrawnClouds lit(Vec3 otherSun) {
        return new DrawnClouds(all.stream().map(cloud -> cloud.lit(otherSun)).toList(), otherSun);
    }

    public List<DrawnCloud> all() {
        return all;
    }

    /** Returns the sun by which the clouds are lit. */
    public Vec3 towardsSun() {
        return towardsSun;
    }

    /** Returns the share of the sun's light that reaches a point through all clouds. */
    public double sunShare(Vec3 at) {
        var up = Ray.of(at, towardsSun);
        double share = 1;
        for (DrawnCloud cloud : all) {
            var march = new CellMarch(cloud.cells(), DARK);
            march.march(up, 0, Double.POSITIVE_INFINITY, 1, 0.5);
            share *= march.transmittance();
        }
        return share;
    }

    private static final CellMarch.OutsideOfCloud DARK =
            new CellMarch.OutsideOfCloud(NOON, Vec3.ZERO, Vec3.ZERO, Vec3.ZERO);
}
