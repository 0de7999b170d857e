package nephele.engine.render.pass.cloud.volume;

import nephele.engine.cloud.DeltaScaling;
import nephele.engine.cloud.cells.CellBox;
import nephele.engine.cloud.drawn.DrawnCloud;
import nephele.engine.cloud.drawn.DrawnClouds;
import nephele.engine.cloud.field.ProfiledNoise;
import nephele.engine.cloud.light.CloudOptics;
import nephele.engine.level.Environment;
import nephele.engine.level.Sun;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.SharedResources;
import nephele.engine.render.pass.cloud.CloudTextures;
import nephele.engine.render.pass.cloud.volume.MarchProgram.Noise;
import nephele.engine.scene.View;
import nephele.engine.scene.light.SkyIrradiance;

/** A cloud of the level with its cells on the GPU and the light around it. */
final class MarchedCloud {
    private final SharedResources shared;
    private final DrawnCloud cloud;
    private final CloudTextures textures;
    /** {@code null} if the density comes from cells. */
    private final NoiseTextures noiseTextures;

    private Environment followed;
    private Vec3 towardsSun;
    private Vec3 irradiance;
    private Vec3 above;
    private Vec3 below;

    MarchedCloud(LoadContext context, DrawnCloud cloud) {
        shared = context.shared();
        this.cloud = cloud;
        textures = new CloudTextures(context, cloud.cells());
        if (cloud.noise() == null) {
            noiseTextures = null;
        } else {
            noiseTextures = new NoiseTextures(
                    context,
                    (ProfiledNoise) cloud.noise().density(),
                    cloud.cells().levels());
            noiseTextures.uploadPlan(cloud.noise(), cloud.cells());
        }
    }

    Noise noise() {
        return cloud.noise() == null ? Noise.NONE : cloud.evolves() ? Noise.EVOLVING : Noise.STILL;
    }

    Aabb bounds() {
        return cloud.bounds();
    }

    double halfCurvature() {
        return cloud.halfCurvature();
    }

    /** Takes the light of the present environment. */
    void follow(Environment now) {
        if (now == followed) {
            return;
        }
        followed = now;
        Sun sun = Daylight.onGround(now);
        towardsSun = DrawnClouds.towardsSun(now);
        irradiance = sun == null ? Vec3.ZERO : sun.irradiance();
        SkyIrradiance sky = shared.surfaceLight().clearIrradiance(now);
        above = Vec3.of(sky.ambient(0, 1, 0));
        below = Vec3.of(sky.ambient(0, -1, 0));
    }

    void bind(MarchProgram program, View view, double stepCells) {
        textures.bind();
        if (noiseTextures != null) {
            noiseTextures.bind(program.noisePlaces(), cloud.noise(), view);
        }
        var places = program.places();
        CellBox narrowest = cloud.cells().narrowest();
        Aabb box = narrowest.box();
        places.cells()
                .set(
                        narrowest.ny(),
                        cloud.cells().light().get(0).cells().ny(),
                        cloud.cells().levels(),
                        (float) narrowest.shortest());
        places.cloudBase()
                .set((float) ((box.minX() + box.maxX()) / 2 - view.eyeX()), (float) (box.minY() - view.eyeY()), (float)
                        ((box.minZ() + box.maxZ()) / 2 - view.eyeZ()));
        places.cloudHalf().set((float) ((box.maxX() - box.minX()) / 2), (float) (box.maxY() - box.minY()), (float)
                ((box.maxZ() - box.minZ()) / 2));
        CloudOptics optics = cloud.cells().physics().optics();
        DeltaScaling medium = cloud.cells().physics().medium();
        places.medium()
                .set((float) cloud.greatestPerMetre(), (float) medium.depthFactor(), (float) optics.albedo(), (float)
                        medium.albedo());
        places.phase()
                .set(
                        (float) medium.g(),
                        (float) cloud.cells().physics().smallAngles().deepest(),
                        (float) halfCurvature(),
                        (float) optics.meanCosine());
        places.stepping().set((float) stepCells, 0.5f, (float) view.eyeY());
        set(places.cloudSun(), towardsSun);
        set(places.irradiance(), irradiance);
        set(places.skyAbove(), above);
        set(places.skyBelow(), below);
    }

    private static void set(nephele.engine.render.gl.shader.Uniforms.Vector3 place, Vec3 v) {
        place.set((float) v.x(), (float) v.y(), (float) v.z());
    }
}
