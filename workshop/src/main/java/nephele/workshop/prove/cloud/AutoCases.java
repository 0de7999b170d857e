package nephele.workshop.prove.cloud;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.Cloud;
import nephele.engine.level.Environment;
import nephele.engine.level.Sun;
import nephele.engine.level.appearance.WeatherClouds;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.scene.View;
import nephele.engine.sim.reach.EyeReach;
import nephele.host.named.LevelName;
import nephele.host.named.OpenedLevel;
import nephele.host.named.Viewpoints;
import nephele.lab.technique.SeenSky;
import nephele.lab.technique.TableCase;

/** Twelve sample skies in the light of three suns, each from three places: none of them is in the table of errors. The sky is the table's. */
final class AutoCases {
    static final List<String> SKIES = List.of(
            "weather-few",
            "weather-scattered",
            "weather-broken",
            "weather-overcast",
            "weather-cirrus",
            "weather-storm",
            "clouds-cumulus",
            "clouds-stratus",
            "clouds-image-grey",
            "clouds-puffs",
            "clouds-grid",
            "clouds-ellipsoid");

    static final int PLACES = 3;
    private static final double[] SUNS = {12, 30, 60};
    private static final double SUN_AZIMUTH_DEGREES = 110;
    /** Half the width of where the eye can be. */
    private static final double STRIDE_METRES = 6;

    private AutoCases() {}

    static int count() {
        return SKIES.size() * SUNS.length * PLACES;
    }

    /**
     * One case.
     *
     * @param sky all of its clouds with technique auto
     * @param tolerance allowed for each of them
     */
    record Case(String name, SeenSky sky, EyeReach reach) {}

    static Case of(int unit, Cloud.Tolerance tolerance) {
        String name = SKIES.get(unit / (SUNS.length * PLACES));
        double sun = SUNS[unit / PLACES % SUNS.length];
        int place = unit % PLACES;
        OpenedLevel opened = new LevelName("levels/samples/" + name + ".json").open();
        Environment environment = lit(opened.placed().level().environment(), sun);
        List<Cloud> clouds = new ArrayList<>();
        WeatherClouds.all(environment).forEach(cloud -> clouds.add(cloud.with(tolerance)));
        Environment written =
                environment.with((nephele.engine.level.Weather) null, 0).withClouds(clouds);
        View view = view(clouds.get(0), place);
        Vec3 eye = view.eye();
        var around = Aabb.around(eye, new Vec3(2 * STRIDE_METRES, 2, 2 * STRIDE_METRES));
        return new Case(
                name + ", sun at " + (int) sun + " degrees, place " + (place + 1),
                SeenSky.alone(name, written, opened.assets(), view),
                new EyeReach(List.of(new EyeReach.Part(around, EyeReach.Means.WALKING))));
    }

    private static Environment lit(Environment environment, double sunDegrees) {
        double up = Math.toRadians(sunDegrees);
        double aside = Math.toRadians(SUN_AZIMUTH_DEGREES);
        var towards = new Vec3(Math.cos(up) * Math.sin(aside), Math.sin(up), -Math.cos(up) * Math.cos(aside));
        return environment.with(TableCase.SKY).with(new Sun(towards, TableCase.SUN_IRRADIANCE, true));
    }

    /** Returns the view of a layer from below, farther away and from a hill, of a finite cloud from three distances. */
    private static View view(Cloud first, int place) {
        double aspect = (double) SeenSky.WIDTH / SeenSky.HEIGHT;
        if (first.extent() instanceof Cloud.Extent.Volume volume) {
            Vec3 middle = volume.centre();
            double away = new double[] {1, 0.6, 2.2}[place];
            double aside = new double[] {0, 0.5, -0.4}[place];
            double far = Math.hypot(middle.x(), middle.z());
            var eye = new Vec3(middle.x() + aside * far, 2, middle.z() + away * far);
            double radius = volume.size().length() / 2;
            double fov = Math.toDegrees(
                    2 * Math.atan(1.2 * radius / middle.minus(eye).length()));
            return Viewpoints.between(eye, middle, fov, aspect);
        }
        Vec3 eye = List.of(new Vec3(0, 2, 0), new Vec3(5200, 2, -3100), new Vec3(-2400, 120, 900))
                .get(place);
        Vec3 ahead = List.of(new Vec3(0, 0.5, -1), new Vec3(0.6, 1.2, 0.8), new Vec3(-1, 0.3, 0.2))
                .get(place);
        return Viewpoints.between(eye, eye.plus(ahead.scaled(1000)), 75.0, aspect);
    }
}
