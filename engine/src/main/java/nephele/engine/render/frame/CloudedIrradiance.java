package nephele.engine.render.frame;

import nephele.engine.cloud.cells.CellMarch.OutsideOfCloud;
import nephele.engine.cloud.drawn.CloudedSky;
import nephele.engine.cloud.drawn.DrawnClouds;
import nephele.engine.level.Environment;
import nephele.engine.level.Sun;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.math.Vec3;
import nephele.engine.scene.light.SkyIrradiance;

/** The light of the sky on surfaces under clouds, as the middle of the level sees it. */
final class CloudedIrradiance {
    /** Cells along a side of the cube over which the sky is integrated. */
    private static final int CELLS = 8;

    private CloudedIrradiance() {}

    static SkyIrradiance of(SharedResources shared, Environment now, SkyIrradiance clear) {
        var sky = new CloudedSky(
                shared.clouds(),
                around(now, clear),
                (height, x, y, z) -> clear.radiance(x, y, z),
                CloudShadeRegion.of(shared.statics()).centre());
        return SkyIrradiance.of(sky, CELLS);
    }

    /** Returns the light around clouds. */
    static OutsideOfCloud around(Environment now, SkyIrradiance clear) {
        Sun sun = Daylight.onGround(now);
        return new OutsideOfCloud(
                DrawnClouds.towardsSun(now),
                sun == null ? Vec3.ZERO : sun.irradiance(),
                Vec3.of(clear.ambient(0, 1, 0)),
                Vec3.of(clear.ambient(0, -1, 0)));
    }
}
