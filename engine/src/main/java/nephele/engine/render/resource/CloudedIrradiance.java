package nephele.engine.render.resource;

import nephele.engine.cloud.cells.CellMarch.OutsideOfCloud;
import nephele.engine.cloud.drawn.CloudInterval;
import nephele.engine.cloud.drawn.CloudTimeline;
import nephele.engine.cloud.drawn.SkyThroughClouds;
import nephele.engine.level.Environment;
import nephele.engine.level.Sun;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.math.Vec3;
import nephele.engine.scene.light.SkyIrradiance;
import org.joml.Vector3d;

/** The light of the sky on surfaces under clouds, as the middle of the level sees it. */
final class CloudedIrradiance {
    private CloudedIrradiance() {}

    static SkyIrradiance of(CloudInterval clouds, Environment now, SkyIrradiance clear) {
        double ground = clouds.groundShare();
        OutsideOfCloud around = around(now, clear, ground);
        SkyThroughClouds sky = clouds.from().sky();
        return SkyIrradiance.of(
                (height, x, y, z) -> sky.from(
                        clouds.to().sky(),
                        clouds.share(),
                        clear.radiance(x, y, z).mul(y < 0 ? ground : 1),
                        around,
                        new Vector3d(x, y, z)),
                SkyThroughClouds.SIDE);
    }

    /** Returns the light around clouds. @param ground share of its light that the plain keeps */
    private static OutsideOfCloud around(Environment now, SkyIrradiance clear, double ground) {
        Sun sun = Daylight.onGround(now);
        return new OutsideOfCloud(
                CloudTimeline.towardsSun(now),
                sun == null ? Vec3.ZERO : sun.irradiance(),
                Vec3.of(clear.ambient(0, 1, 0)),
                Vec3.of(clear.ambient(0, -1, 0)).scaled(ground));
    }
}
